#pragma once

#include <string>

#include "tests/device/openhaptics/stand_in.h"

namespace palpate::test {

// The stand-in that devices of a test open, reset.
class StandInLibrary {
 public:
  explicit StandInLibrary(bool real_time = false);

  void tick(int count = 1) const { controls_.tick(count); }
  void stall(bool stalls) const { controls_.stall(stalls); }
  StandInRecord record(int device = 0) const { return controls_.record(device); }
  int starts() const { return controls_.starts(); }

  // Changes what is planted into a device.
  template <class Change>
  void plant(Change change, int device = 0) {
    change(faults_[device]);
    controls_.set(device, faults_[device]);
  }

  static std::string uri(const std::string& name) { return "openhaptics:" + in_library(name); }
  static std::string in_library(const std::string& name) { return name + "?library=" + PALPATE_STAND_IN; }

 private:
  const StandInControls& controls_;
  StandInFaults faults_[StandInControls::kDevices];
};

// The length of what a device was told last.
double sent_force(const StandInRecord& record);

}  // namespace palpate::test
