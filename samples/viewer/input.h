#pragma once

#include <string>
#include <vector>

#include "samples/viewer/command.h"
#include "samples/viewer/geometry.h"

namespace palpate::viewer {

// What keyboard and mouse did since the last frame.
struct Input {
  Vec3 move{0.0};         // keys for the hand, -1 to 1: right, above and towards the viewer
  Vec3 turn{0.0};         // the same about these directions
  glm::dvec2 mouse{0.0};  // pixels to the right and downwards
  double wheel = 0.0;
  bool orbit = false;  // what the mouse does: go around, shift the picture, or lead the hand
  bool pan = false;
  bool lead = false;
  bool lead_turn = false;
  std::vector<Command> commands;
  std::vector<std::string> dropped;  // paths
};

}  // namespace palpate::viewer
