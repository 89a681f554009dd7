#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/bench/benches.h"
#include "tests/bench/bullet_method.h"
#include "tests/bench/coal_method.h"
#include "tests/bench/decimate.h"
#include "tests/bench/engine_methods.h"
#include "tests/bench/fcl_methods.h"
#include "tests/bench/point_shell_method.h"
#include "tests/bench/scene_methods.h"

namespace palpate::bench {
namespace {

constexpr double kCutoffs[] = {0.02, 0.01, 0.05};  // shares of the first model's diagonal
constexpr double kMainCutoff = 0.02;               // the one at which all methods run
constexpr unsigned kGlobalPeriods[] = {2, 10, 50, 200};
constexpr std::size_t kDivisors[] = {4, 16, 64};

const char* kComplete = "complete set";
const char* kOneMinimum = "one minimum";

// Methods, and for each the index of the one that is exact under its law.
struct Field {
  Methods methods;
  std::vector<std::size_t> exact;

  void add(std::unique_ptr<Method> method, std::size_t exact_one) {
    methods.push_back(std::move(method));
    exact.push_back(exact_one);
  }
};

void add_scenes(const ModelPair& pair, Law law, Field& field) {
  const std::size_t exact = field.methods.size();
  const DVec3 centre = pair.b->centre();
  field.add(scene_method(pair, {"scene_global", kComplete, PLP_MODE_GLOBAL, centre, law}), exact);
  field.add(scene_method(pair, {"scene_certified", kComplete, PLP_MODE_CERTIFIED, centre, law}), exact);
  for (unsigned period : kGlobalPeriods)
    field.add(
        scene_method(pair, {"scene_descent_" + std::to_string(period), "LMDs followed from the last search",
                            PLP_MODE_DESCENT, centre, law, period}),
        exact);
}

void add_decimated(const ModelPair& pair, Field& field) {
  for (std::size_t divisor : kDivisors) {
    const ModelPair coarse{decimated(*pair.a, divisor), decimated(*pair.b, divisor), pair.cutoff};
    field.add(
        scene_method(coarse, {"decimated_" + std::to_string(divisor), "complete set of decimated models",
                              PLP_MODE_CERTIFIED, pair.b->centre()}),
        0);
  }
}

// The scene that searches from scratch comes first: under springs it is exact.
Field field_of(const ModelPair& pair, bool all) {
  Field field;
  for (Law law : laws()) add_scenes(pair, law, field);
  field.add(search_method(pair), 0);
  field.add(front_method(pair), 0);
  field.add(descent_method(pair, DescentForm::kPolar), 0);
  field.add(descent_method(pair, DescentForm::kNeighbourhood), 0);
  field.add(fcl_obbrss_method(pair), 0);
  field.add(fcl_rss_method(pair), 0);
  if (auto coal = coal_method(pair)) field.add(std::move(coal), 0);
  if (!all) return field;
  add_decimated(pair, field);
  field.add(point_shell_method(pair), 0);
  field.add(bullet_method(pair), 0);
  return field;
}

// Errors of one method, relative to a spring that is pressed by the whole cutoff and acts at the tool's rim.
struct Errors {
  Series force, torque, missed, spurious;
};

Errors errors_of(const Run& run, const Run& exact, double force_scale, double arm) {
  Errors errors;
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (!run[i]) continue;
    const Outcome &got = run[i]->outcome, &right = exact[i]->outcome;
    errors.force.add(glm::length(got.wrench.force - right.wrench.force) / force_scale);
    errors.torque.add(glm::length(got.wrench.torque - right.wrench.torque) / (force_scale * arm));
    const double difference = static_cast<double>(got.lmds) - static_cast<double>(right.lmds);
    errors.missed.add(std::max(0.0, -difference));
    errors.spurious.add(std::max(0.0, difference));
  }
  return errors;
}

// The least time of both at each pose: what FCL could do, had it known which volume to take.
Series best_of(const Run& one, const Run& other) {
  Series best;
  for (std::size_t i = 0; i < one.size(); ++i) best.add(std::min(one[i]->us, other[i]->us));
  return best;
}

// How far one minimum is from the least of the complete set, relative to the cutoff.
Series distance_errors(const Run& run, const Run& exact, double cutoff) {
  Series errors;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double right = exact[i]->outcome.min_distance;
    if (right <= cutoff) errors.add(std::abs(run[i]->outcome.min_distance - right) / cutoff);
  }
  return errors;
}

struct Reported {
  const PairScene& scene;
  const ModelPair& pair;
  std::string parameters;

  Measure measure(const Method& method, const char* quantity, const char* unit) const {
    return {"pairs", scene.name, method.name(), method.returns(), parameters, quantity, unit};
  }
};

void report(const Reported& what, const Field& field, const std::vector<Run>& runs, Table& table) {
  const double force_scale = kStiffness * what.pair.cutoff, arm = what.pair.b->radius();
  for (std::size_t m = 0; m < runs.size(); ++m) {
    const Method& method = *field.methods[m];
    const auto add = [&](const char* quantity, const char* unit, const Series& values) {
      table.add(what.measure(method, quantity, unit), values);
    };
    const Run& exact = runs[field.exact[m]];
    const Errors errors = errors_of(runs[m], exact, force_scale, arm);
    add("time", "us", time_us(runs[m]));
    if (method.name().starts_with("scene_descent")) add("servo_time", "us", servo_us(runs[m]));
    add("time_per_lmd", "us", per_lmd_us(runs[m]));
    add("interrupted", "ticks", interruptions(runs[m]));
    add("lmds", "sets", lmds(runs[m]));
    add("force_error", "k*cutoff", errors.force);
    add("torque_error", "k*cutoff*radius", errors.torque);
    if (method.returns() == kOneMinimum) {
      add("distance_error", "cutoff", distance_errors(runs[m], exact, what.pair.cutoff));
    } else {
      add("lmds_missed", "sets", errors.missed);
      add("lmds_spurious", "sets", errors.spurious);
    }
  }
}

void report_best_fcl(const Reported& what, const Field& field, const std::vector<Run>& runs, Table& table) {
  const auto at = [&](const std::string& name) {
    const auto found = std::ranges::find_if(field.methods, [&](const auto& m) { return m->name() == name; });
    return static_cast<std::size_t>(found - field.methods.begin());
  };
  table.add({"pairs", what.scene.name, "fcl_best", kOneMinimum, what.parameters, "time", "us"},
            best_of(runs[at("fcl_obbrss")], runs[at("fcl_rss")]));
}

std::string parameters_of(double cutoff, int motions) {
  char text[64];
  std::snprintf(text, sizeof text, "cutoff=%g speed=%g seeds=%d..%d", cutoff, kSpeed, static_cast<int>(kSeed),
                static_cast<int>(kSeed) + motions - 1);
  return text;
}

// All methods over several motions, one after the other.
std::vector<Run> run_motions(const Field& field, const ModelPair& pair, int motions, int poses) {
  std::vector<Run> all(field.methods.size());
  for (int i = 0; i < motions; ++i) {
    const std::vector<Pose> motion = motion_of(pair, poses, kSeed + static_cast<std::uint64_t>(i));
    const std::vector<Run> runs = run_by_turns(field.methods, motion);
    for (std::size_t m = 0; m < all.size(); ++m) all[m].insert(all[m].end(), runs[m].begin(), runs[m].end());
  }
  return all;
}

}  // namespace

void bench_pairs(const Effort& effort, Table& table) {
  for (const PairScene& scene : pair_scenes(effort)) {
    for (double cutoff : kCutoffs) {
      const bool all = cutoff == kMainCutoff;
      if (effort.quick && !all) continue;
      const std::string parameters = parameters_of(cutoff, effort.motions());
      table.say(std::string("pairs: ") + scene.name + " " + parameters);
      const ModelPair pair = load(scene, cutoff);
      const Field field = field_of(pair, all);
      const int poses = all ? effort.poses() : effort.poses() / 4;
      const std::vector<Run> runs = run_motions(field, pair, effort.motions(), poses);
      const Reported what{scene, pair, parameters};
      report(what, field, runs, table);
      report_best_fcl(what, field, runs, table);
    }
  }
}

}  // namespace palpate::bench
