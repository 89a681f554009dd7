#pragma once

#include <deque>
#include <memory>

#include "engine/device/openhaptics/hd_abi.h"
#include "engine/device/simulated/simulated_phantom.h"
#include "tests/device/openhaptics/stand_in.h"

namespace palpate::test {

// One device of the stand-in: a simulated PHANToM that speaks in the library's numbers. Its lock is its
// library's.
class StandInDevice {
 public:
  StandInDevice(const char* name, const char* model, const PhantomSpec& spec, int styles);

  const char* name() const { return name_; }
  const char* model() const { return model_; }
  bool is_open() const { return record_.open; }
  bool in_frame() const { return in_frame_; }

  void open();
  void close();
  void set(const StandInFaults& faults);
  StandInRecord record() const;

  // Lets a millisecond pass: what the last frame left is on the motors.
  void step();

  // These give an error, or 0.
  hd::ErrorCode begin_frame();
  hd::ErrorCode end_frame();
  hd::ErrorCode set_output(bool on);
  hd::ErrorCode set_doubles(hd::Enum what, const double* numbers);
  hd::ErrorCode get_doubles(hd::Enum what, double* numbers) const;
  hd::ErrorCode get_integer(hd::Enum what, int* number) const;
  hd::ErrorCode get_boolean(hd::Enum what, hd::Boolean* truth) const;
  void update_calibration(int style);

  StandInFaults faults;

 private:
  bool has_torque() const;
  void get_transform(double* numbers) const;
  hd::ErrorCode get_limit(hd::Enum what, double* number) const;

  const char* const name_;
  const char* const model_;
  const PhantomSpec& spec_;
  const int styles_;
  SimulatedPhantom phantom_;
  StandInRecord record_;
  bool in_frame_ = false;
  double force_[3] = {};  // of this frame
  double torque_[3] = {};
  std::uint64_t frames_before_ = 0;
  std::uint64_t steps_ = 0;
};

}  // namespace palpate::test
