#include "tests/bench/benches.h"
#include "tests/bench/scenes.h"
#include "tests/bench/touch_scene.h"
#include "tests/bench/turns.h"
#include "tests/support/models.h"

namespace palpate::bench {
namespace {

constexpr double kCutoff = 0.02;
// The first only warms the caches up that the largest has emptied, and is not told of.
constexpr std::size_t kCounts[] = {0, 0, 1, 10, 100, 1000, 10000};
constexpr std::size_t kAlone = 1;

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
  Crowd(const ModelPair& pair, plp_model a, plp_model b, std::size_t distant)
      : scene_(pair.cutoff, PLP_MODE_CERTIFIED, Law::kSprings, 10) {
    scene_.add_static(a, Pose{});
    scene_.add_tool(b, pair.b->centre());
    for (std::size_t n = 0; n < distant; ++n)
      scene_.add_static(a, distant_place(n, pair.a->bounds().diagonal()));
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
  const auto body = asset_model("organic_2200");
  const ModelPair pair{body, asset_model("organic_2200", 0.4), kCutoff * body->bounds().diagonal()};
  const cli::OwnedModel a = public_model(*pair.a), b = public_model(*pair.b);
  table.say("bodies: up to 10,000 distant ones");
  Methods crowds;
  for (std::size_t count : kCounts) crowds.push_back(std::make_unique<Crowd>(pair, a.get(), b.get(), count));
  const std::vector<Run> runs = run_by_turns(crowds, motion_of(pair, effort.poses()));
  for (std::size_t m = kAlone; m < runs.size(); ++m) {
    const auto add = [&](const char* quantity, const Series& values) {
      table.add({"bodies", "organic_2200", crowds[m]->name(), crowds[m]->returns(),
                 "distant=" + std::to_string(kCounts[m]), quantity, "us"},
                values);
    };
    add("time", time_us(runs[m]));
    if (m > kAlone) add("added", added_us(runs[m], runs[kAlone]));
  }
}

}  // namespace palpate::bench
