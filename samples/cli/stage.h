#pragma once

#include <string>

#include "palpate/palpate.h"
#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/tick.h"
#include "samples/cli/trajectory.h"

namespace palpate::cli {

plp_mode mode_of(const std::string& name);  // throws Failure, as the next
plp_law law_of(const std::string& name);

// The models of a run: one that stands still and one that moves.
struct RunModels {
  OwnedModel body;
  OwnedModel tool;

  explicit RunModels(const RunArguments& arguments)
      : body(load_model(arguments.a, arguments.scale_a)), tool(load_model(arguments.b, arguments.scale_b)) {}
};

// A scene of both.
class Stage {
 public:
  Stage(const RunArguments& arguments, plp_mode mode, const RunModels& models);

  Tick step(const TimedPose& at);

  // The same while a servo of so many steps a second runs beside the caller.
  void start(double rate);
  void move(const TimedPose& at) { check(plp_scene_set_pose(scene_.get(), tool_, &at.pose)); }
  Tick newest(const TimedPose& at) const;
  plp_servo_state stop();

  plp_contacts contacts() const;  // of the newest step, valid until the next

 private:
  plp_body add(const OwnedModel& model, plp_body_kind kind);

  OwnedScene scene_;
  plp_body tool_ = 0;
};

}  // namespace palpate::cli
