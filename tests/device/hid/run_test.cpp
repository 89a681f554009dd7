#include <algorithm>
#include <cstdlib>

#include "tests/device/hid/hid_bench.h"
#include "tests/device/hid/servo_loop.h"
#include "tests/support/allocation_count.h"

namespace palpate::test {
namespace {

class HidRun : public HidBench {};

// A minute where PALPATE_LONG is set.
std::size_t run_length() {
  const char* wanted = std::getenv("PALPATE_LONG");
  return wanted && *wanted ? 60'000 : 3'000;
}

TEST_F(HidRun, AThousandSamplesASecondArriveWithoutLoss) {
  const auto mock = plug_ohhp();
  GuardedDevice device(open("1209:0001"));
  device.arm();
  {
    ServoLoop servo(device);
    const std::size_t began = mock->steps();
    while (mock->steps() < began + run_length()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(servo.wait_until_armed());
  }
  // What is on its way arrives.
  const std::uint16_t last = mock->log().back().sequence;
  ASSERT_TRUE(wait_until([&] { return device.status().state.sequence >= last; }));
  EXPECT_EQ(device.status().state.lost, 0u);
  const auto log = mock->log();
  const auto pushed =
      std::count_if(log.begin(), log.end(), [](const auto& step) { return step.force > 0.99; });
  EXPECT_GT(pushed, 0);
  std::printf("%zu samples, 0 lost; pushed in %td, %zu wrenches too late\n", log.size(), pushed,
              mock->refused());
}

// Neither the servo nor the threads beside it: while the device pushes, when it falls silent, and when
// transfers block. The mock has no thread of its own here, so that it takes and gives only what it is told
// to.
TEST_F(HidRun, ATickAllocatesNothing) {
  const auto mock = std::make_shared<MockOhhp>();
  const int number = bus_.plug(mock);
  GuardedDevice device(open("1209:0001"));
  device.arm();
  hid_device::HapticDevice sampled;
  const auto tick = [&](bool speaks) {
    if (speaks) mock->send(sampled.step());
    device.read();
    device.write({DVec3(0.0, 1.0, 0.0), DVec3(0.0)}, true, 1e-3);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return device.status();
  };
  std::size_t taken = 0, pushed = 0;
  const std::uint64_t before = allocation_count();
  for (int i = 0; i < 30'000 && pushed < 50; ++i) {
    pushed += tick(true).applied.force.y > 0.0;
    taken += mock->discard();
  }
  for (int i = 0; i < 300; ++i) tick(i % 100 < 80);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(pushed, 50u);
  EXPECT_GT(taken, 0u);
  EXPECT_GT(device.status().safety.ticks_of(Limiter::kDevice), 0u);
  bus_.unplug(number);  // which ends the transfer, as a kernel does after a while
}

TEST_F(HidRun, ThePoseIsTheDevices) {
  const auto mock = plug_ohhp();
  mock->change([](hid_device::HapticDevice& device) { device.mass().hold_at({0.01, -0.02, 0.03}); });
  GuardedDevice device(open("1209:0001"));
  const auto arrived = [&] {
    return glm::distance(device.status().state.tool.position, DVec3(0.01, -0.02, 0.03)) < 1e-6;
  };
  EXPECT_TRUE(wait_until(arrived)) << "seen though nobody ticks it";
  mock->change([](hid_device::HapticDevice& device) { device.set_buttons(2); });
  EXPECT_TRUE(wait_until([&] { return device.status().state.buttons == 2; }));
  EXPECT_TRUE(device.status().state.calibrated);
}

}  // namespace
}  // namespace palpate::test
