#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>

#include "engine/device/registry.h"
#include "engine/device/safety_limits.h"
#include "engine/device/simulated/recorded_motion.h"
#include "engine/device/simulated/scripted_motion.h"
#include "engine/device/simulated/simulated_phantom.h"
#include "tests/support/allocation_count.h"

namespace palpate {
namespace {

// A second of reading, limiting, writing and stepping, with a fault half way.
void run_second(Device& device, SafetyLimits& limits) {
  for (std::uint64_t tick = 1; tick <= 1000; ++tick) {
    const DeviceState state = device.read();
    const DeviceWrench wanted = {-500.0 * state.tool.position, DVec3(tick == 500 ? std::nan("") : 0.01)};
    device.write(limits.apply({wanted, tick}, state, 1e-3));
    device.step(1e-3);
  }
}

TEST(DeviceAllocation, IsCounted) {
  const std::uint64_t before = test::allocation_count();
  EXPECT_TRUE(DeviceRegistry::standard().open("sim:touch"));
  EXPECT_GT(test::allocation_count(), before);
}

TEST(DeviceAllocation, NoneInATickOnceADeviceIsOpen) {
  const auto recorded = RecordedMotion::from({{0.0, {}}, {0.5, {DVec3(0.01), DQuat(0.8, 0.6, 0.0, 0.0)}}});
  const auto scripted = std::make_shared<ScriptedMotion>(HandScript::kWedge, ScriptParameters{});
  const auto opened = DeviceRegistry::standard().open("sim:premium6dof");
  ASSERT_TRUE(recorded && opened);
  auto& phantom = dynamic_cast<SimulatedPhantom&>(*opened.value());
  SafetyLimits limits(SafetySettings::for_device(phantom.info().limits));
  limits.arm();
  for (const std::shared_ptr<const HandMotion>& motion : {recorded.value(), {scripted}}) {
    phantom.set_motion(motion);
    const std::uint64_t before = test::allocation_count();
    run_second(phantom, limits);
    EXPECT_EQ(test::allocation_count(), before);
  }
  EXPECT_EQ(limits.report().ticks_of(Limiter::kNonFiniteWrench), 2u);
}

}  // namespace
}  // namespace palpate
