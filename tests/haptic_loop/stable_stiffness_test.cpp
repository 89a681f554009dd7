#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/haptic_loop/model_loop.h"

namespace palpate::test {
namespace {

struct Pressed {
  double residual_speed = 0.0;  // m/s, root mean square at the end
  double felt_stiffness = 0.0;  // N/m at the end
};

Pressed press(const ModelPair& pair, const LoopSettings& settings) {
  constexpr int kTicks = 1500;
  constexpr int kObserved = 500;
  constexpr double kForce = 1.0;  // N
  ModelLoop loop(pair, Surface::kBody, settings);
  loop.begin(HandScript::kPress, kForce / settings.hand.stiffness, 0.0, 0.2);
  double squares = 0.0;
  for (int i = 0; i < kTicks; ++i) {
    loop.tick();
    const DVec3& velocity = loop.motion().linear_velocity;
    if (i >= kTicks - kObserved) squares += glm::dot(velocity, velocity);
  }
  return {std::sqrt(squares / kObserved), loop.felt_stiffness()};
}

// The largest stiffness, to five per cent, at which a press comes to rest: as it is felt.
double largest_stable_stiffness(const ModelPair& pair, LoopSettings settings) {
  constexpr double kRest = 1e-3;  // m/s
  constexpr double kGrowth = 1.5, kPrecision = 1.05;
  double felt = 0.0;
  const auto is_stable = [&](double stiffness) {
    settings.scene.stiffness = stiffness;
    const Pressed pressed = press(pair, settings);
    // Written so that a speed that is not a number is not stable.
    if (!(pressed.residual_speed <= kRest)) return false;
    felt = pressed.felt_stiffness;
    return true;
  };
  double stable = 300.0;
  if (!is_stable(stable)) return 0.0;
  double unstable = stable * kGrowth;
  for (; is_stable(unstable); unstable *= kGrowth) stable = unstable;
  while (unstable > kPrecision * stable) {
    const double middle = std::sqrt(stable * unstable);
    (is_stable(middle) ? stable : unstable) = middle;
  }
  return felt;
}

// Below both, theory promises a stable press. A wall whose force is held for a sample gives energy that
// damping takes up to 2 b / T (J. E. Colgate & G. G. Schenkel 1994), and one that feels a position in counts
// gives energy that friction takes up to 2 f / D (J. J. Abbott & A. M. Okamura 2005). What is measured lies
// above: neither is necessary.
struct PromisedStiffness {
  double by_damping;   // N/m
  double by_friction;  // N/m
  double least() const { return std::min(by_damping, by_friction); }
};

PromisedStiffness promised_stiffness(const LoopSettings& settings) {
  return {2.0 * (settings.spec.handle.damping + settings.hand.damping) / ModelLoop::kTick,
          2.0 * settings.spec.handle.friction / settings.spec.limits.position_resolution};
}

class StableStiffness : public testing::TestWithParam<ModelPair> {};

TEST_P(StableStiffness, IsAtLeastWhatTheoryPromises) {
  for (const PhantomSpec& spec : phantom_specs()) {
    LoopSettings settings;
    settings.spec = spec;
    settings.hand = impedance_of(Grip::kLight);
    settings.scene.cutoff = 0.008;
    settings.scene.stiffness_cap = -1.0;
    const double measured = largest_stable_stiffness(GetParam(), settings);
    const PromisedStiffness promised = promised_stiffness(settings);
    std::printf("%-16s %-12s largest stable stiffness %6.0f N/m; 2b/T %6.0f, 2f/D %6.0f, rated %4.0f\n",
                GetParam().name, std::string(spec.uri_name).c_str(), measured, promised.by_damping,
                promised.by_friction, spec.limits.max_stiffness);
    EXPECT_GE(measured, promised.least());
    EXPECT_GE(promised.least(), spec.limits.max_stiffness) << "a scene's own cap is on the safe side";
  }
}

INSTANTIATE_TEST_SUITE_P(Models, StableStiffness, testing::ValuesIn(kModelPairs),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace palpate::test
