#include "samples/viewer/experiments.h"

#include <cstdlib>

#include "samples/cli/failure.h"

namespace palpate::viewer {
namespace {

struct Experiment {
  const char* name;
  const char* scene;
  const char* tool;
  double tool_scale;
  bool from_data;  // a file of PALPATE_DATA; otherwise one that the build has made
  Vec3 up;
  Vec3 turn;  // of the tool, axis times angle
  double aside;
  MotionKind motion;
};

constexpr double kQuarter = 1.5707963267948966;  // rad

constexpr Experiment kExperiments[] = {
    {"crankshaft-gear",
     "crankshaft_45k",
     "gear_6k",
     1.0,
     false,
     {0, 1, 0},
     {-1.047, 0, 0},
     0.06,
     MotionKind::kSlide},
    {"spring-teapot",
     "spring_23k",
     "teapot_5600",
     0.3,
     false,
     {0, 1, 0},
     {0.4, 0.6, 0},
     0.1,
     MotionKind::kSlide},
    {"organic", "organic_97k", "organic_2200", 0.4, false, {0, 1, 0}, {0.3, 0, 0.5}, 0.0, MotionKind::kSlide},
    {"helicopter",
     "helicopter_113k",
     "gear_6k",
     0.5,
     false,
     {0, 0, 1},
     {0.5, 0, 0},
     -0.35,
     MotionKind::kSlide},
    {"horse-bunny",
     "horse_outward",
     "bunny_2200",
     0.004,
     true,
     {0, 0, 1},
     {kQuarter, 0, 0},
     0.0,
     MotionKind::kSlide},
};

std::string folder_of(const Experiment& experiment, const std::string& models) {
  if (!experiment.from_data) return models;
  const char* data = std::getenv("PALPATE_DATA");
  if (data && *data) return data;
  throw cli::Failure(
      "--experiment " + std::string(experiment.name) +
      ": its models are in the folder that PALPATE_DATA names, which is not set; organic is like it");
}

Quat turned(const Vec3& turn) {
  const double angle = glm::length(turn);
  return angle > 0.0 ? glm::angleAxis(angle, turn / angle) : Quat(1.0, 0.0, 0.0, 0.0);
}

}  // namespace

Arguments experiment(const std::string& name, const std::string& models) {
  for (const Experiment& experiment : kExperiments) {
    if (name != experiment.name) continue;
    const std::string folder = folder_of(experiment, models) + "/";
    Arguments arguments;
    arguments.title = name;
    arguments.scene = folder + experiment.scene + ".glb";
    arguments.tool = folder + experiment.tool + ".glb";
    arguments.tool_scale = experiment.tool_scale;
    arguments.tool_turn.orientation = turned(experiment.turn);
    arguments.up = experiment.up;
    arguments.aside = experiment.aside;
    arguments.motion = experiment.motion;
    arguments.settings.mode = PLP_MODE_DESCENT;
    arguments.settings.law = PLP_LAW_SPRINGS;
    return arguments;
  }
  throw cli::Failure("--experiment " + name + ": it is " + experiment_names());
}

std::string experiment_names() {
  std::string names;
  for (const Experiment& experiment : kExperiments)
    names += (names.empty() ? "" : ", ") + std::string(experiment.name);
  return names;
}

}  // namespace palpate::viewer
