#pragma once

#include <string>
#include <vector>

#include "palpate/palpate.h"
#include "samples/cli/handles.h"
#include "samples/cli/trajectory.h"

namespace palpate::cli {

// One that stands still and a tool, as a scene makes them that is told no more.
std::vector<plp_trace_body> body_and_tool();

// To add a body like that, without model and pose.
plp_body_options body_options(const plp_trace_body& recorded);

// How a tool moves past other bodies: rows of a CSV file, or the steps of a trace.
class Motion {
 public:
  // Tells by its beginning what the file is. Throws Failure.
  explicit Motion(const std::string& path);

  const std::vector<TimedPose>& poses() const { return poses_; }
  bool recorded() const { return trace_.get() != nullptr; }

  // One that stands still and the tool, or those of the trace in its order, one of them the tool.
  const std::vector<plp_trace_body>& bodies() const { return bodies_; }

  // Of a trace: how its scene was made.
  plp_scene_options options() const;

  // Of a trace: brings a scene's bodies, in the order of bodies(), to where they were in that step, bit by
  // bit.
  void place(std::size_t step, plp_scene scene, const std::vector<plp_body>& bodies) const;
  plp_trace_tick tick(std::size_t step) const;

 private:
  void open_trace(const std::string& path);
  void take_bodies(const std::string& path, const plp_trace_info& info);

  OwnedTrace trace_;
  std::vector<plp_trace_body> bodies_;
  std::vector<TimedPose> poses_;
};

}  // namespace palpate::cli
