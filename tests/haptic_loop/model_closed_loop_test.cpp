#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "tests/haptic_loop/model_loop.h"

namespace palpate::test {
namespace {

constexpr double kCutoff = 0.004;    // m
constexpr int kTicksPerCycle = 500;  // of the scripts
constexpr int kTransient = 2;        // cycles until the motion has become periodic
constexpr int kHolding = 1500;       // ticks
constexpr int kObserved = 500;       // of these, at the end
constexpr double kDepth = 0.006;     // m that the hand presses
constexpr double kTravel = 0.003;    // m that it moves aside
// N/m of a spring. Several push at once, but what the hand feels stays below what sampling makes unstable.
constexpr double kStiffness = 600.0;

struct LoopDevice {
  const char* name;
  const PhantomSpec& (*spec)();
};

const LoopDevice kDevices[] = {{"Premium", premium6dof_spec}, {"Touch", touch_spec}};

struct LoopCap {
  const char* name;
  double stiffness_cap;  // as of SceneOptions
};

struct LoopLaw {
  const char* name;
  ForceLaw law;
};

const LoopLaw kSmooth{"Smooth", ForceLaw::kSmooth}, kSprings{"Springs", ForceLaw::kSprings};
const LoopCap kCaps[] = {{"Rated", 0.0}, {"Free", -1.0}};

struct LoopScript {
  const char* name;
  HandScript script;
  Surface surface;
};

void PrintTo(const LoopDevice& device, std::ostream* out) {
  *out << device.name;
}
void PrintTo(const LoopScript& script, std::ostream* out) {
  *out << script.name;
}
void PrintTo(const LoopCap& cap, std::ostream* out) {
  *out << cap.name;
}
void PrintTo(const LoopLaw& law, std::ostream* out) {
  *out << law.name;
}

const LoopScript kScripts[] = {{"Tap", HandScript::kTap, Surface::kBody},
                               {"Press", HandScript::kPress, Surface::kBody},
                               {"Slide", HandScript::kSlide, Surface::kBody},
                               {"Wedge", HandScript::kWedge, Surface::kGap}};

// A minute where PALPATE_LONG is set. A slide ends where it began.
int cycles() {
  const char* wanted = std::getenv("PALPATE_LONG");
  return wanted && *wanted && *wanted != '0' ? 120 : 6;
}

// The smallest box around what was seen.
class Extent {
 public:
  void add(const DVec3& v) { box_.grow(v); }
  double length() const { return box_.diagonal(); }

 private:
  Box box_;
};

using LoopCase = std::tuple<ModelPair, LoopDevice, LoopScript, LoopLaw, LoopCap>;

std::string name_of(const LoopCase& loop) {
  const auto& [pair, device, script, law, cap] = loop;
  return std::string(pair.name) + device.name + script.name + law.name + cap.name;
}

class ModelClosedLoop : public testing::TestWithParam<LoopCase> {
 protected:
  const LoopDevice& device() const { return std::get<1>(GetParam()); }
  const LoopScript& script() const { return std::get<2>(GetParam()); }

  LoopSettings settings() const {
    LoopSettings settings;
    settings.spec = device().spec();
    settings.hand = impedance_of(Grip::kLight);
    settings.scene.cutoff = kCutoff;
    settings.scene.stiffness = kStiffness;
    settings.scene.stiffness_cap = std::get<4>(GetParam()).stiffness_cap;
    settings.scene.law = std::get<3>(GetParam()).law;
    return settings;
  }

  // N/m of one spring by itself, which is the least that the hand can meet.
  double softest() const {
    const double cap = loop_.stiffness_cap();
    return cap > 0.0 ? 1.0 / (1.0 / kStiffness + 2.0 / cap) : kStiffness;
  }

  // How much of the motion the hand makes, so that one spring alone can push as hard as the hand.
  double reach() const {
    constexpr double kPart = 0.9;  // of what it pushes with where surfaces touch
    return std::min(1.0, kPart * kCutoff * softest() / (hand_stiffness() * std::hypot(kDepth, kTravel)));
  }
  static double hand_stiffness() { return impedance_of(Grip::kLight).stiffness; }

  void run_cycle(int cycle) {
    const double given = loop_.given_to_hand();
    for (int i = 0; i < kTicksPerCycle; ++i) tick();
    if (cycle > kTransient) most_given_ = std::max(most_given_, loop_.given_to_hand() - given);
  }

  void hold() {
    loop_.hold();
    for (int i = 0; i < kHolding; ++i) {
      tick();
      if (i < kHolding - kObserved) continue;
      held_places_.add(loop_.motion().position);
      held_forces_.add(loop_.status().applied.force);
    }
  }

  void tick() {
    loop_.tick();
    nearest_ = std::min(nearest_, loop_.contacts().min_distance);
    stiffest_ = std::max(stiffest_, loop_.felt_stiffness());
    most_lmds_ = std::max(most_lmds_, loop_.contacts().set_count);
    overlaps_ += loop_.contacts().overlap ? 1 : 0;
  }

  ModelLoop loop_{std::get<0>(GetParam()), script().surface, settings()};
  double nearest_ = std::numeric_limits<double>::infinity();  // m
  double stiffest_ = 0.0;                                     // N/m
  double most_given_ = -std::numeric_limits<double>::max();   // J in one cycle
  std::uint32_t most_lmds_ = 0;
  int overlaps_ = 0;  // ticks
  Extent held_places_;
  Extent held_forces_;
};

TEST_P(ModelClosedLoop, IsSteadyAndPassiveAndLetsNothingThrough) {
  loop_.begin(script().script, reach() * kDepth, reach() * kTravel, kTicksPerCycle * ModelLoop::kTick);
  for (int cycle = 0; cycle < cycles(); ++cycle) run_cycle(cycle);
  hold();
  std::printf(
      "%-38s nearest %.2f mm, %u LMDs, %.0f N/m, energy to the hand in a cycle at most %+.4f mJ, "
      "held within %.2f um and %.4f N\n",
      name_of(GetParam()).c_str(), 1e3 * nearest_, most_lmds_, stiffest_, 1e3 * most_given_,
      1e6 * held_places_.length(), held_forces_.length());

  // What the hand could press were the handle held where springs begin.
  const double count = device().spec().limits.position_resolution;
  const double hand_force = hand_stiffness() * reach() * std::hypot(kDepth, kTravel);
  const double allowed = std::min(hand_force, device().spec().limits.max_force) / softest();
  EXPECT_LT(nearest_, kCutoff - 0.1 * allowed) << "the hand touches";
  EXPECT_GT(nearest_, kCutoff - allowed);
  EXPECT_EQ(overlaps_, 0);
  if (loop_.stiffness_cap() > 0.0) {
    EXPECT_LE(stiffest_, loop_.stiffness_cap() * (1.0 + 1e-6));
  }
  EXPECT_LE(most_given_, 0.5 * stiffest_ * count * count) << "the hand got energy from a closed cycle";
  // A limit cycle goes on while the hand rests: the handle would cross counts, and the force step with them.
  EXPECT_LE(held_places_.length(), count);
  EXPECT_LE(held_forces_.length(), stiffest_ * count);
  EXPECT_EQ(loop_.status().safety.state, SafetyState::kArmed);
}

INSTANTIATE_TEST_SUITE_P(Hands, ModelClosedLoop,
                         testing::Combine(testing::ValuesIn(kModelPairs), testing::ValuesIn(kDevices),
                                          testing::ValuesIn(kScripts), testing::Values(kSmooth),
                                          testing::ValuesIn(kCaps)),
                         [](const auto& info) { return name_of(info.param); });

// Minima come and go as the hand slides over these, and each takes its spring along.
INSTANTIATE_TEST_SUITE_P(Jumps, ModelClosedLoop,
                         testing::Combine(testing::Values(kModelPairs[2]), testing::ValuesIn(kDevices),
                                          testing::ValuesIn(kScripts), testing::Values(kSprings),
                                          testing::Values(kCaps[0])),
                         [](const auto& info) { return name_of(info.param); });

// How far a hand at rest is shaken that has slid over minima which come and go under the law of springs.
double shaken(double stiffness_cap) {
  LoopSettings settings;
  settings.spec = premium6dof_spec();
  settings.hand = impedance_of(Grip::kLight);
  settings.scene.cutoff = kCutoff;
  settings.scene.stiffness = kStiffness;
  settings.scene.stiffness_cap = stiffness_cap;
  settings.scene.law = ForceLaw::kSprings;
  ModelLoop loop(kModelPairs[2], Surface::kBody, settings);
  loop.begin(HandScript::kSlide, kDepth, kTravel, kTicksPerCycle * ModelLoop::kTick);
  for (int i = 0; i < 6 * kTicksPerCycle; ++i) loop.tick();
  loop.hold();
  Extent places;
  for (int i = 0; i < kHolding; ++i) {
    loop.tick();
    if (i >= kHolding - kObserved) places.add(loop.motion().position);
  }
  return places.length();
}

// Two springs that take turns keep a hand shaking without a cap. That they do is not wanted: it shows that
// the cap is put to the test.
TEST(ModelLoop, DoesNotShakeAHandByJumpsUnderTheDevicesCap) {
  const double free = shaken(-1.0), rated = shaken(0.0);
  const double count = premium6dof_spec().limits.position_resolution;
  std::printf("shaken by %.2f um without a cap, %.2f um with the device's\n", 1e6 * free, 1e6 * rated);
  EXPECT_GT(free, 10.0 * count);
  EXPECT_LE(rated, count);
}

LoopSettings strong_settings() {
  LoopSettings settings;
  settings.spec = premium6dof_spec();
  settings.hand = impedance_of(Grip::kFirm);
  settings.scene.cutoff = 0.008;
  settings.scene.stiffness = 6000.0;
  settings.scene.stiffness_cap = -1.0;
  return settings;
}

// The device gives all it has, so that the handle stays away from where the hand wants it by what that force
// stretches the hand's own spring: no deeper, and nothing is pressed through.
TEST(ModelLoop, GivesWayAtSaturationByNoMoreThanTheDeviceLacks) {
  constexpr double kWanted = 0.012;  // m
  constexpr int kTicks = 2000, kObserved = 500;
  const LoopSettings settings = strong_settings();
  const double most = settings.spec.limits.max_force;
  for (const ModelPair& pair : kModelPairs) {
    ModelLoop loop(pair, Surface::kBody, settings);
    loop.begin(HandScript::kPress, kWanted, 0.0, 0.5);
    double stretch = 0.0;
    for (int i = 0; i < kTicks; ++i) {
      loop.tick();
      ASSERT_FALSE(loop.contacts().overlap) << pair.name;
      ASSERT_LE(glm::length(loop.status().applied.force), most * (1.0 + 1e-12)) << pair.name;
      if (i < kTicks - kObserved) continue;
      stretch += glm::distance(loop.motion().position, DVec3(0.0, -kWanted, 0.0)) / kObserved;
    }
    const DeviceStatus status = loop.status();
    std::printf("%-16s hand stretched by %.2f mm, device allows %.2f, wanted %.2f N, given %.2f N\n",
                pair.name, 1e3 * stretch, 1e3 * most / settings.hand.stiffness,
                glm::length(status.wanted.force), glm::length(status.applied.force));
    EXPECT_GT(status.safety.ticks_of(Limiter::kForceClamp), 1000u) << pair.name;
    const double friction = settings.spec.handle.friction;
    EXPECT_GE(stretch, (most - friction) / settings.hand.stiffness) << pair.name;
  }
}

// A hand that presses with more than all springs can is through: that is told, and it is no kick.
TEST(ModelLoop, ReportsAnOverlapWhereTheHandIsStronger) {
  LoopSettings settings = strong_settings();
  settings.scene.stiffness = 100.0;
  ModelLoop loop(kModelPairs[0], Surface::kBody, settings);
  loop.begin(HandScript::kTap, 0.03, 0.0, 1.0);
  const double slew = settings.spec.limits.max_force / 4.0;  // N in a tick
  DVec3 before = loop.status().applied.force;
  int overlaps = 0;
  for (int i = 0; i < 2000; ++i) {
    loop.tick();
    overlaps += loop.contacts().overlap ? 1 : 0;
    const DVec3 force = loop.status().applied.force;
    ASSERT_LE(glm::distance(force, before), slew * (1.0 + 1e-9)) << i;
    before = force;
  }
  EXPECT_GT(overlaps, 100);
  EXPECT_LT(overlaps, 1900);
}

}  // namespace
}  // namespace palpate::test
