#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/viewer/content.h"

namespace palpate::viewer {

using OwnedDevice = cli::Owned<plp_device, plp_device_release>;

// A scene with its tool in a device's handle, or without a device.
class Rig {
 public:
  // Throws cli::Failure. The content must outlive the rig.
  explicit Rig(const Content& content);

  void apply(const Settings& settings);

  const Settings& settings() const { return settings_; }

  // A thousand ticks a second beside the caller, or one by the caller.
  void start();
  void stop();
  bool runs() const { return runs_; }
  void step();

  // A trace of all steps from now on.
  void record(const std::string& path);
  plp_recording stop_recording();
  plp_recording recording() const;

  bool has_device() const { return device_.get() != nullptr; }
  bool has_simulated_hand() const { return simulated_; }
  void arm(bool on);
  void set_grip(plp_grip grip);

  // Without a device: where the tool goes.
  void place_tool(const plp_pose& tool);
  // Without a device: as that row of poses or step of a trace has it, bit by bit, with the settings that
  // changed.
  void follow(const cli::Motion& motion, std::size_t row);
  // With a simulated hand: where it goes with the tool in `seconds` from now, or along a list.
  void lead_hand(const Placement& from, const Placement& to, double seconds);
  void lead_hand(const std::vector<cli::TimedPose>& poses);

  // Of the newest tick. The arrays last until the next step or reading.
  plp_contacts contacts() const;
  Placement tool() const;
  plp_device_state device_state() const;
  plp_device_info device_info() const;
  plp_servo_state servo() const;
  double seconds() const;                      // simulated, since the beginning
  double step_us() const { return step_us_; }  // of the last step by the caller

 private:
  plp_body add(const ModelFile& file, plp_body_options options, const Placement& placement);
  void give_to_device(const Content& content);
  Placement base_from_tool(const Placement& tool) const;  // the handle that holds it so

  cli::OwnedScene scene_;
  OwnedDevice device_;
  std::vector<plp_body> bodies_;  // in the order of a replay
  plp_body tool_ = 0;
  plp_device_mapping mapping_{};
  plp_hand_options hand_{};
  Settings settings_;
  Settings recorded_;  // of the step of a trace that was followed last
  bool simulated_ = false;
  bool runs_ = false;
  std::uint64_t steps_ = 0;
  double step_us_ = 0.0;
};

}  // namespace palpate::viewer
