#pragma once

#include <string>
#include <vector>

#include "palpate/palpate.h"
#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/motion.h"
#include "samples/cli/run_models.h"
#include "samples/cli/tick.h"

namespace palpate::cli {

plp_mode mode_of(const std::string& name);  // throws Failure, as the next
plp_law law_of(const std::string& name);

// How the scene of a run is made: as it was asked for. Throws Failure.
plp_scene_options scene_options(const RunArguments& arguments, const Motion& motion);

// A scene of all, which follows a motion pose by pose.
class Stage {
 public:
  Stage(const RunArguments& arguments, const plp_scene_options& options, const RunModels& models,
        const Motion& motion);

  Tick step(std::size_t pose);

  // The same while a servo of so many steps a second runs beside the caller.
  void start(double rate);
  void move(std::size_t pose);
  Tick newest(std::size_t pose) const;
  plp_servo_state stop();

  // A trace of all steps from now on.
  void record(const std::string& path) { check(plp_scene_record(scene_.get(), path.c_str())); }
  plp_recording stop_recording();

  plp_contacts contacts() const;  // of the newest step, valid until the next

 private:
  plp_body add(plp_model model, const plp_trace_body& recorded);
  void follow_settings(const plp_trace_tick& tick);

  const RunArguments& arguments_;
  const Motion& motion_;
  OwnedScene scene_;
  std::vector<plp_body> bodies_;  // in the motion's order
  plp_body tool_ = 0;
};

}  // namespace palpate::cli
