#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/viewer/geometry.h"
#include "samples/viewer/history.h"
#include "samples/viewer/settings.h"

namespace palpate::viewer {

// All that one picture shows of a rig, read once.
struct FrameState {
  std::vector<plp_lmd> lmds;
  plp_contacts contacts;  // its arrays are not to be read: `lmds` is the copy
  Placement tool;
  std::optional<Placement> wanted;  // by the hand
  std::optional<plp_device_state> device;
  std::optional<plp_device_info> device_info;
  plp_servo_state servo;
  plp_recording recording;
  double cutoff;  // metres, as it is set now
  bool runs;      // its servo
  bool paused;
  bool simulated;
  double seconds;
};

}  // namespace palpate::viewer
