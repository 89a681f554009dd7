#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <thread>

#include "engine/device/hid/hid_backend.h"
#include "samples/hid_device/uhid_port.h"
#include "tests/device/hid/servo_loop.h"

// The same devices through the kernel's own hidraw, where a user may make virtual ones.
namespace palpate::test {
namespace {

constexpr const char* kName = "1209:0001:PALPATE-TEST";

template <class Condition>
bool wait_until(Condition&& condition) {
  for (int i = 0; i < 30'000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

// The reference device, plugged in while this lives.
class PluggedIn {
 public:
  PluggedIn() : port_(0x1209, 0x0001, "PALPATE-TEST"), thread_([this] { run(); }) {}
  ~PluggedIn() {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    thread_.join();
  }

  double force() {
    const std::lock_guard lock(mutex_);
    return force_;
  }

 private:
  void run() {
    auto due = std::chrono::steady_clock::now();
    hid_device::HapticDevice device;
    while (true) {
      port_.serve(device, due += std::chrono::milliseconds(1));
      port_.send(device.step());
      const std::lock_guard lock(mutex_);
      force_ = device.force()[1];
      if (stopped_) return;
    }
  }

  hid_device::UhidPort port_;
  std::mutex mutex_;  // guards what follows
  double force_ = 0.0;
  bool stopped_ = false;
  std::thread thread_;
};

TEST(HidKernel, TheReferenceDeviceIsFeltPulledOutAndFeltAgain) {
  if (access("/dev/uhid", R_OK | W_OK) != 0) GTEST_SKIP() << "/dev/uhid cannot be written here";
  auto plugged = std::make_unique<PluggedIn>();
  const HidBackend backend;
  std::unique_ptr<Device> opened;
  ASSERT_TRUE(wait_until([&] {
    auto found = backend.open(kName);
    if (found && found.value()) opened = std::move(found.value());
    return opened != nullptr;
  }));
  GuardedDevice device(std::move(opened));
  device.arm();
  ServoLoop servo(device);
  ASSERT_TRUE(wait_until([&] { return plugged->force() > 0.99; }));
  plugged.reset();
  ASSERT_TRUE(wait_until([&] { return device.status().state.condition == DeviceCondition::kLost; }));
  EXPECT_EQ(device.status().applied.force, DVec3(0.0));
  plugged = std::make_unique<PluggedIn>();
  EXPECT_TRUE(wait_until([&] { return plugged->force() > 0.99; }));
}

}  // namespace
}  // namespace palpate::test
