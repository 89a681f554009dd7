#pragma once

#include <array>
#include <string>
#include <vector>

#include "samples/viewer/command.h"
#include "samples/viewer/content.h"
#include "samples/viewer/frame_state.h"

namespace palpate::viewer {

// What a person has changed in the panels.
struct PanelChoices {
  Settings settings;
  std::vector<Command> commands;
  MotionKind motion;
  bool motion_chosen = false;
  std::string device;  // another URI, if one was chosen
  bool drop_is_tool = false;
  std::array<char, 1024> typed_path{};
  std::string opened;  // a path, once it is typed
};

struct PanelView {
  const Content& content;
  const FrameState* state;  // null while nothing runs
  const History& history;
  const std::string& loading;  // what is being done; empty if nothing is
  const std::string& message;  // an error or what was written
  bool message_is_error;
};

// Draws the panels around the picture of the scene.
void draw_panels(const PanelView& view, PanelChoices& choices);

inline constexpr float kLeftPanel = 272.0f;  // pixels
inline constexpr float kRightPanel = 268.0f;

}  // namespace palpate::viewer
