#pragma once

#include <memory>
#include <optional>
#include <string>

#include "samples/cli/motion.h"
#include "samples/viewer/motion.h"
#include "samples/viewer/settings.h"

namespace palpate::viewer {

struct Arguments {
  std::string title = "Palpate";
  std::string scene;  // glTF files; empty: dropped on the window later
  std::string tool;
  double tool_scale = 1.0;
  Placement tool_turn;            // how the tool is turned before it comes near
  Vec3 up{0.0, 1.0, 0.0};         // from where it comes
  double aside = 0.0;             // where along the scene's longest axis: -1 to 1
  std::optional<Placement> pose;  // where the tool begins, instead of near the scene
  std::string device;             // empty: none, the tool goes where poses say
  MotionKind motion = MotionKind::kHold;
  std::shared_ptr<const cli::Motion> replay;  // where the tool goes; null: none
  Settings settings;
  bool headless = false;
  bool stepped = false;            // in the frames: the same ticks are the same bits
  std::optional<unsigned> frames;  // none: as many as a replay has, or a few seconds
  unsigned ticks_per_frame = 16;
  unsigned runs = 1;       // of the same film; each tick's times are the least
  std::string screenshot;  // files to write; empty: none
  std::string record;
  std::string log;
  std::string graphs;
  int width = 1280;
  int height = 800;
};

// Throws cli::Failure; empty if all there was to do is done, such as to print help.
std::optional<Arguments> parse_arguments(int argc, char** argv);

}  // namespace palpate::viewer
