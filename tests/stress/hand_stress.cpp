#include "tests/stress/hand_stress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/haptic_loop/model_loop.h"

namespace palpate::stress {
namespace {

constexpr double kCutoff = 0.004;     // m
constexpr double kStiffness = 600.0;  // N/m
constexpr double kDepth = 0.006;      // m that the hand presses
constexpr double kTravel = 0.003;     // m that it moves aside
constexpr int kTicksPerCycle = 500;
constexpr int kTransient = 2;   // cycles until the motion has become periodic
constexpr int kCycles = 6;      // at least
constexpr int kHolding = 2000;  // ticks
constexpr std::size_t kListened = 500;

constexpr auto kScenes = std::to_array<HandScene>({
    {"crankshaft, gear", "crankshaft_45k", "gear_6k"},
    {"teapot, spring", "teapot_5600", "spring_23k"},
    {"organic bodies", "organic_97k", "organic_2200"},
    {"slivers, box", "slivers", "box"},
    {"fan, tetrahedron", "fan_200", "tetrahedron"},
    {"saddle, ball", "saddle", "icosphere"},
    {"voxels, bracket", "voxels", "l_bracket"},
    {"plate, box", "plate", "box_tessellated"},
});

test::LoopSettings settings_of(const PhantomSpec& spec, double cap) {
  test::LoopSettings settings;
  settings.spec = spec;
  settings.hand = impedance_of(Grip::kLight);
  settings.scene.cutoff = kCutoff;
  settings.scene.stiffness = kStiffness;
  settings.scene.stiffness_cap = cap;
  settings.scene.law = ForceLaw::kSmooth;
  return settings;
}

// The root mean square of what a signal of one sample a millisecond has between 100 and 500 Hz.
double high_part(const std::vector<DVec3>& signal) {
  const auto count = static_cast<double>(signal.size());
  double power = 0.0;
  for (std::size_t k = signal.size() / 10; k <= signal.size() / 2; ++k) {
    DVec3 real(0.0), imaginary(0.0);
    for (std::size_t i = 0; i < signal.size(); ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k * i % signal.size()) / count;
      real += signal[i] * std::cos(angle);
      imaginary += signal[i] * std::sin(angle);
    }
    power += (k == signal.size() / 2 ? 1.0 : 2.0) * (glm::dot(real, real) + glm::dot(imaginary, imaginary));
  }
  return std::sqrt(power) / count;
}

double deviation_of(const std::vector<DVec3>& signal) {
  DVec3 mean(0.0);
  for (const DVec3& value : signal) mean += (value - signal.front()) / static_cast<double>(signal.size());
  double sum = 0.0;
  for (const DVec3& value : signal) {
    const DVec3 off = value - signal.front() - mean;
    sum += glm::dot(off, off);
  }
  return std::sqrt(sum / static_cast<double>(signal.size()));
}

// One script on one device.
class Run {
 public:
  Run(const HandScene& scene, const PhantomSpec& spec, HandScript script, double cap, HandOutcome& outcome)
      : loop_({scene.name, scene.body, scene.tool, DVec3(0.0), DVec3(0.3, 0.2, 0.1), false},
              test::Surface::kBody, settings_of(spec, cap)),
        count_(spec.limits.position_resolution),
        script_(script),
        outcome_(outcome) {
    // One spring alone can push as hard as the hand.
    const double softest =
        loop_.stiffness_cap() > 0.0 ? 1.0 / (1.0 / kStiffness + 2.0 / loop_.stiffness_cap()) : kStiffness;
    const double hand = impedance_of(Grip::kLight).stiffness;
    const double reach = std::min(1.0, 0.9 * kCutoff * softest / (hand * std::hypot(kDepth, kTravel)));
    loop_.begin(script, reach * kDepth, reach * kTravel, kTicksPerCycle * test::ModelLoop::kTick);
  }

  void cycle(int number) {
    const double given = loop_.given_to_hand();
    for (int i = 0; i < kTicksPerCycle; ++i) tick();
    if (number < kTransient) return;
    ++outcome_.cycles;
    const double most = loop_.given_to_hand() - given;
    // A press rests, which takes and gives nothing.
    if (script_ != HandScript::kPress)
      outcome_.most_given = outcome_.most_given == 0.0 ? most : std::max(outcome_.most_given, most);
    outcome_.active += most > 0.5 * stiffest_ * count_ * count_;
  }

  void rest() {
    loop_.hold();
    std::vector<DVec3> forces;
    for (int i = 0; i < kHolding; ++i) {
      tick();
      forces.push_back(loop_.status().applied.force);
    }
    forces.erase(forces.begin(), forces.end() - kListened);
    const double buzz = high_part(forces);
    outcome_.buzz = std::max(outcome_.buzz, buzz);
    outcome_.deviation = std::max(outcome_.deviation, deviation_of(forces));
    outcome_.loud += buzz > stiffest_ * count_;
    outcome_.pushed = std::max(outcome_.pushed, pushed_);
    outcome_.idle += pushed_ == 0.0;
    outcome_.disarmed += loop_.status().safety.state != SafetyState::kArmed;
  }

 private:
  void tick() {
    loop_.tick();
    stiffest_ = std::max(stiffest_, loop_.felt_stiffness());
    pushed_ = std::max(pushed_, glm::length(loop_.status().applied.force));
    outcome_.seconds += test::ModelLoop::kTick;
  }

  test::ModelLoop loop_;
  const double count_;
  const HandScript script_;
  double pushed_ = 0.0;
  double stiffest_ = 0.0;
  HandOutcome& outcome_;
};

}  // namespace

std::span<const HandScene> hand_scenes() {
  return kScenes;
}

HandOutcome stress_hand(const HandScene& scene, const std::function<bool()>& enough) {
  HandOutcome outcome;
  do {
    for (const PhantomSpec* spec : {&premium6dof_spec(), &touch_spec()})
      for (const double cap : {0.0, -1.0})
        for (const HandScript script : {HandScript::kPress, HandScript::kTap, HandScript::kSlide}) {
          Run run(scene, *spec, script, cap, outcome);
          for (int i = 0; i < kCycles + kTransient; ++i) run.cycle(i);
          run.rest();
        }
  } while (!enough());
  return outcome;
}

}  // namespace palpate::stress
