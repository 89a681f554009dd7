#pragma once

#include <cstdint>

namespace palpate::test {

// What the stand-in for libHD was told about a device, in the numbers in which it was told.
struct StandInRecord {
  bool open = false;
  double force[3] = {};   // N, of the last whole frame
  double torque[3] = {};  // N·mm, of the last whole frame
  double most_force = 0.0;
  std::uint64_t frames = 0;           // ended
  std::uint64_t missed_frames = 0;    // ticks without one while the device was open
  std::uint64_t sets_outside = 0;     // of a frame
  std::uint64_t torques_refused = 0;  // for a device without motors for them
  std::uint64_t pushes = 0;           // frames with force on the motors
  std::uint64_t output_changes = 0;   // amplifiers switched on or off
  bool output = false;
  int updates = 0;              // of the calibration
  int updates_with_output = 0;  // while the amplifiers were on
  int last_style = 0;
  double handle[3] = {};       // m, where it truly is
  double orientation[4] = {};  // x y z w, how it truly is turned
};

// What a device of the stand-in is made to do.
struct StandInFaults {
  bool unplugged = false;        // every frame is an error, and so is opening
  bool swallows_frames = false;  // a frame that is begun is none
  bool sends_nan = false;        // instead of a pose
  bool strides = false;          // the pose jumps to and fro
  unsigned int error = 0;        // in every frame
  unsigned int error_once = 0;   // in the next frame
  unsigned int stray_error = 0;  // of the other device, once, in a frame of this one
  unsigned int opening_error = 0;
  unsigned int calibration = 0x5000;
  bool updating_helps = true;        // an update of the right style calibrates it
  double torque_limits_times = 1.0;  // what it says that its torques may be
  double force_limits_times = 1.0;   // the same of forces
  double temperature = 0.0;
  std::uint32_t buttons = 0;
  bool in_inkwell = false;
  double hand[3] = {};  // m, where the hand that holds it wants to be
  double turn[3] = {};  // the same of its orientation: a rotation vector
};

// How tests reach a stand-in beside its functions. Device 0 is "Default Device", a Premium 1.5/6DOF; device 1
// is "Left", a Touch. Any thread may call.
struct StandInControls {
  static constexpr int kDevices = 2;

  // Everything as at the beginning, with no device open. Without real time the scheduler ticks only by
  // tick().
  void (*reset)(bool real_time);
  void (*tick)(int count);
  void (*stall)(bool stalls);  // the scheduler's thread waits
  StandInRecord (*record)(int device);
  void (*set)(int device, const StandInFaults& faults);
  int (*starts)();  // of the scheduler
};

// Exported under this name.
using StandInEntry = const StandInControls* (*)();
constexpr const char* kStandInEntry = "palpate_stand_in";

}  // namespace palpate::test
