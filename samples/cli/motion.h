#pragma once

#include <string>
#include <vector>

#include "palpate/palpate.h"
#include "samples/cli/handles.h"
#include "samples/cli/trajectory.h"

namespace palpate::cli {

// How a model moves past another: rows of a CSV file, or the steps of a trace with a tool and one other body.
class Motion {
 public:
  Motion() = default;  // none: no poses, and bodies as any
  // Tells by its beginning what the file is. Throws Failure.
  explicit Motion(const std::string& path);

  const std::vector<TimedPose>& poses() const { return poses_; }
  bool recorded() const { return trace_.get() != nullptr; }

  // Of a trace: how its scene was made and what its bodies were.
  plp_scene_options options() const;
  // Whatever it is: a tool, or the other body, without model and pose.
  plp_body_options body_options(plp_body_kind kind) const;

  // Of a trace: brings a scene's bodies to where they were in that step, bit by bit.
  void place(std::size_t step, plp_scene scene, plp_body body, plp_body tool) const;
  plp_trace_tick tick(std::size_t step) const;

 private:
  void open_trace(const std::string& path);
  void take_bodies(const std::string& path, const plp_trace_info& info);

  OwnedTrace trace_;
  plp_trace_body body_{};
  plp_trace_body tool_{};
  std::vector<TimedPose> poses_;
};

}  // namespace palpate::cli
