#include <string>

#include "tests/bench/benches.h"
#include "tests/bench/engine_methods.h"
#include "tests/bench/fcl_methods.h"
#include "tests/bench/sized_shape.h"

namespace palpate::bench {
namespace {

constexpr double kCutoff = 0.02;  // of the diagonal
constexpr double kToolScale = 0.4;

// A tool much coarser than the shape, as a rule, and one that is about as fine.
struct Tool {
  const char* scene;
  double triangles;
};
constexpr Tool kTools[] = {{"organic-tool_2k", 2200}, {"organic-tool_22k", 22000}};

// The methods of all sizes run by turns, so that the growth is of one and the same minutes.
struct Sized {
  Methods methods;
  std::vector<std::string> parameters;  // of each method
};

void add_size(const ModelPair& middle, double triangles, bool peers, Sized& sized) {
  const auto shape = make_model(sized_shape(triangles));
  const ModelPair pair{shape, middle.b, middle.cutoff};
  const std::string parameters = "triangles=" + std::to_string(shape->mesh().triangles.size());
  const auto add = [&](std::unique_ptr<Method> method) {
    sized.methods.push_back(std::move(method));
    sized.parameters.push_back(parameters);
  };
  shape->tree();
  add(search_method(pair));
  add(front_method(pair));
  add(descent_method(pair, DescentForm::kPolar));
  if (peers) add(fcl_rss_method(pair));
}

void report(const std::string& scene, const Sized& sized, const std::vector<Run>& runs, Table& table) {
  for (std::size_t m = 0; m < runs.size(); ++m) {
    const Method& method = *sized.methods[m];
    const auto add = [&](const char* quantity, const char* unit, const Series& values) {
      table.add({"growth", scene, method.name(), method.returns(), sized.parameters[m], quantity, unit},
                values);
    };
    add("time", "us", time_us(runs[m]));
    add("time_per_lmd", "us", per_lmd_us(runs[m]));
    add("lmds", "sets", lmds(runs[m]));
    if (!method.name().starts_with("fcl")) {
      add("node_pairs", "pairs", node_pairs(runs[m]));
      add("triangle_pairs", "pairs", triangle_pairs(runs[m]));
    }
    add("interrupted", "ticks", interruptions(runs[m]));
  }
}

}  // namespace

void bench_growth(const Effort& effort, Table& table) {
  const auto middle = asset_model("organic_97k");
  for (const Tool& tool : kTools) {
    const ModelPair pair{middle, make_model(scaled(sized_shape(tool.triangles), kToolScale)),
                         kCutoff * middle->bounds().diagonal()};
    const std::vector<Pose> motion = motion_of(pair, effort.poses());
    Sized sized;
    for (double size : sizes_from(10e3, effort)) {
      table.say(std::string("growth: preparing ") + tool.scene + ", " +
                std::to_string(static_cast<long>(size)));
      add_size(pair, size, size <= 1e6, sized);
    }
    report(tool.scene, sized, run_by_turns(sized.methods, motion), table);
  }
}

}  // namespace palpate::bench
