#include "tests/bench/benches.h"
#include "tests/bench/scenes.h"
#include "tests/bench/touch_scene.h"
#include "tests/bench/turns.h"
#include "tests/support/models.h"

namespace palpate::bench {
namespace {

constexpr double kCutoff = 0.02;
constexpr std::size_t kCounts[] = {0, 1, 10, 100, 1000, 10000};

// The n-th place of a grid that begins far from where the tool moves.
Pose distant_place(std::size_t n, double diagonal) {
  constexpr std::size_t kSide = 22;
  const DVec3 cell(static_cast<double>(n % kSide), static_cast<double>(n / kSide % kSide),
                   static_cast<double>(n / kSide / kSide));
  return {DMat3(1.0), diagonal * (DVec3(5.0) + 1.5 * cell)};
}

// One body that the tool slides over, and others far away.
class Crowd : public Method {
 public:
  Crowd(const Course& course, plp_model a, plp_model b, std::size_t distant)
      : scene_(course.cutoff, PLP_MODE_CERTIFIED, Law::kSprings, 10) {
    scene_.add_static(a, Pose{});
    scene_.add_tool(b, course.b->centre());
    for (std::size_t n = 0; n < distant; ++n)
      scene_.add_static(a, distant_place(n, course.a->bounds().diagonal()));
  }

  std::string name() const override { return "scene_certified"; }
  std::string returns() const override { return "complete set"; }
  void update(const Pose& a_from_b) override { scene_.step(a_from_b); }
  Outcome outcome() const override { return {}; }

 private:
  TouchScene scene_;
};

Series added_us(const Run& crowd, const Run& alone) {
  Series added;
  for (std::size_t i = 0; i < crowd.size(); ++i) added.add(crowd[i]->us - alone[i]->us);
  return added;
}

}  // namespace

void bench_bodies(const Effort& effort, Table& table) {
  const Course course =
      course_of(asset_model("organic_2200"), asset_model("organic_2200", 0.4), kCutoff, effort.poses());
  const cli::OwnedModel a = public_model(*course.a), b = public_model(*course.b);
  table.say("bodies: up to 10,000 distant ones");
  Methods crowds;
  for (std::size_t count : kCounts)
    crowds.push_back(std::make_unique<Crowd>(course, a.get(), b.get(), count));
  const std::vector<Run> runs = run_by_turns(crowds, course.poses);
  for (std::size_t m = 0; m < runs.size(); ++m) {
    const auto add = [&](const char* quantity, const Series& values) {
      table.add({"bodies", "organic_2200", crowds[m]->name(), crowds[m]->returns(),
                 "distant=" + std::to_string(kCounts[m]), quantity, "us"},
                values);
    };
    add("time", time_us(runs[m]));
    if (m > 0) add("added", added_us(runs[m], runs[0]));
  }
}

}  // namespace palpate::bench
