#pragma once

#include <memory>
#include <string>

#include "engine/device/guarded_device.h"
#include "tests/device/openhaptics/stand_in_library.h"

namespace palpate::test {

// A device of the stand-in behind its limits, and a servo on its loop that wants one wrench.
class PhantomLoop final : public ServoTask {
 public:
  explicit PhantomLoop(StandInLibrary& library, const std::string& name = "Default Device");
  ~PhantomLoop() override;

  GuardedDevice& device() { return *device_; }
  DeviceStatus status() { return device_->status(); }
  void want(const DeviceWrench& wrench) { wanted_ = wrench; }
  void tick(double dt) noexcept override;

  // Lets the scheduler tick until `holds`, or for a few seconds of its time and of ours. True if it held.
  template <class Holds>
  bool until(Holds holds) {
    for (int i = 0; i < kMostTicks; ++i) {
      if (holds()) return true;
      next();
    }
    return false;
  }

  // Arms and waits until nothing is held back.
  bool engage();

 private:
  static constexpr int kMostTicks = 20'000;

  void next();

  StandInLibrary& library_;
  std::unique_ptr<GuardedDevice> device_;
  DeviceWrench wanted_;
};

}  // namespace palpate::test
