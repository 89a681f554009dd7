#pragma once

#include <functional>
#include <memory>

#include "engine/device/simulated/simulated_phantom.h"
#include "engine/runtime/haptic_loop.h"

namespace palpate::test {

// A simulated Premium that can be made to lie about itself.
class FaultyDevice final : public Device {
 public:
  using Fault = std::function<DeviceState(const DeviceState&)>;

  FaultyDevice() : phantom_(premium6dof_spec()) {}

  const DeviceInfo& info() const override { return phantom_.info(); }
  DeviceState read() override { return fault_ ? fault_(phantom_.read()) : phantom_.read(); }
  void write(const DeviceWrench& wrench) override {
    written_ = wrench;
    phantom_.write(wrench);
  }
  void step(double dt) override { phantom_.step(dt); }

  void set_fault(Fault fault) { fault_ = std::move(fault); }
  const DeviceWrench& written() const { return written_; }
  SimulatedPhantom& phantom() { return phantom_; }

 private:
  SimulatedPhantom phantom_;
  Fault fault_;
  DeviceWrench written_;
};

// A box in a light hand that rests on a floor: 100 mm cubes both, the lower one's top at the height at which
// springs push with about a newton.
class FloorLoop {
 public:
  static constexpr double kTick = 1e-3;  // s
  static constexpr double kCutoff = 0.01;

  // Without a cap, so that the floor's stiffness is its own.
  explicit FloorLoop(double stiffness = 200.0);

  void tick(double dt = kTick) { loop_.tick(dt); }
  void tick_until_armed();

  Scene& scene() { return scene_; }
  HapticLoop& loop() { return loop_; }
  FaultyDevice& device() { return *device_; }
  GuardedDevice& guarded() { return *guarded_; }
  DeviceStatus status() { return guarded_->status(); }
  const DVec3& force() const { return device_->written().force; }
  BodyId floor() const { return floor_; }

 private:
  FaultyDevice* device_;
  std::shared_ptr<GuardedDevice> guarded_;
  Scene scene_;
  BodyId floor_ = 0;
  HapticLoop loop_{scene_};
};

}  // namespace palpate::test
