#include "samples/viewer/arguments.h"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>

#include "samples/cli/failure.h"
#include "samples/cli/stage.h"
#include "samples/viewer/experiments.h"

namespace palpate::viewer {
namespace {

// What the command line says in words of its own.
struct Words {
  std::string experiment;
  std::string models = PALPATE_ASSETS_DIR;
  std::string device;
  std::string motion;
  std::string replay;
  std::string mode;
  std::string law;
  std::string up;
  std::vector<double> pose;
  std::vector<int> size;
  bool threaded = false;
};

void add_models(CLI::App& app, Arguments& arguments, Words& words) {
  app.add_option("scene", arguments.scene, "A .gltf or .glb file: the model that stands still");
  app.add_option("tool", arguments.tool, "The model that the hand moves");
  app.add_option("--experiment", words.experiment, "A prepared pair: " + experiment_names());
  app.add_option("--models", words.models, "Where the experiments find their models")->capture_default_str();
  app.add_option("--tool-scale", arguments.tool_scale, "How many times as large the tool is made")
      ->check(CLI::PositiveNumber);
  app.add_option("--pose", words.pose, "px py pz qx qy qz qw: where the tool begins, metres")->expected(7);
  app.add_option("--up", words.up, "x, y or z: where up is, from where the tool comes down");
}

void add_hand(CLI::App& app, Words& words) {
  app.add_option("--device", words.device,
                 "Its URI, as palpate devices lists it, or none; without --replay it is sim:premium6dof");
  app.add_option("--motion", words.motion,
                 "hold (keys and mouse lead the simulated hand), tap, press, slide or orbit");
  app.add_option("--replay", words.replay,
                 "CSV of poses, t,px,py,pz,qx,qy,qz,qw, or a trace: the tool goes there, a row a tick; with "
                 "--device its simulated hand follows them");
}

void add_contact(CLI::App& app, Settings& settings, Words& words) {
  app.add_option("--cutoff", settings.cutoff, "Metres; 2 % of the scene's diagonal if left out")
      ->check(CLI::PositiveNumber);
  app.add_option("--stiffness", settings.stiffness, "N/m of the springs")->check(CLI::NonNegativeNumber);
  app.add_option("--damping", settings.damping, "N·s/m that a spring adds while it closes")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--stiffness-cap", settings.stiffness_cap,
                 "N/m of all springs together; 0 for what the device can, negative for no cap");
  app.add_option("--friction", settings.friction, "Coulomb's coefficient")->check(CLI::NonNegativeNumber);
  app.add_option("--mode", words.mode, "global, descent or certified");
  app.add_option("--law", words.law, "smooth or springs");
}

void add_output(CLI::App& app, Arguments& arguments, Words& words) {
  app.add_flag("--headless", arguments.headless, "Without a window or a display; ends by itself");
  app.add_option("--frames", arguments.frames, "How many without a window: all of a replay, else 250")
      ->check(CLI::PositiveNumber);
  app.add_option("--ticks-per-frame", arguments.ticks_per_frame, "Milliseconds of the scene in a frame")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option(
         "--runs", arguments.runs,
         "Make the same film so often, and keep each tick's least times: a busy machine spoils few twice")
      ->check(CLI::Range(1, 100));
  app.add_flag("--stepped", arguments.stepped, "Step the scene in the window's frames instead of a servo");
  app.add_flag("--threaded", words.threaded, "Without a window, too, a servo steps the scene in real time");
  app.add_option("--screenshot", arguments.screenshot, "Write the last frame as PNG");
  app.add_option("--record", arguments.record, "Write a trace of all steps, which --replay takes");
  app.add_option("--log", arguments.log, "Write a CSV row for each tick, as palpate run --out does");
  app.add_option("--graphs", arguments.graphs, "Draw times, pairs and force over time as SVG");
  app.add_option("--size", words.size, "Width and height in pixels")
      ->expected(2)
      ->check(CLI::Range(320, 8192));
}

Vec3 axis_of(const std::string& name) {
  if (name == "x") return {1.0, 0.0, 0.0};
  if (name == "y") return {0.0, 1.0, 0.0};
  if (name == "z") return {0.0, 0.0, 1.0};
  throw cli::Failure("--up " + name + ": it is x, y or z");
}

Placement placement_of(const std::vector<double>& numbers) {
  plp_pose pose{};
  std::copy_n(numbers.begin(), 3, pose.position);
  std::copy_n(numbers.begin() + 3, 4, pose.orientation);
  const double* q = pose.orientation;
  if (!(glm::length(Quat(q[3], q[0], q[1], q[2])) > 0.0))
    throw cli::Failure("--pose: its quaternion is zero");
  return viewer::placement_of(pose);
}

void apply(const Words& words, Arguments& arguments) {
  if (words.device != "none") arguments.device = words.device;
  if (words.device.empty() && !arguments.replay) arguments.device = "sim:premium6dof";
  if (!words.motion.empty()) arguments.motion = motion_of(words.motion);
  if (!words.mode.empty()) arguments.settings.mode = cli::mode_of(words.mode);
  if (!words.law.empty()) arguments.settings.law = cli::law_of(words.law);
  if (!words.up.empty()) arguments.up = axis_of(words.up);
  if (!words.pose.empty()) arguments.pose = placement_of(words.pose);
  if (!words.size.empty()) arguments.width = words.size[0], arguments.height = words.size[1];
  // Without a device nothing but the frames says when the tool moves on.
  arguments.stepped =
      arguments.device.empty() || (!words.threaded && (arguments.stepped || arguments.headless));
  if (arguments.runs > 1 && !(arguments.headless && arguments.stepped))
    throw cli::Failure("--runs needs --headless without --threaded: only then runs are the same");
  if (arguments.headless && (arguments.scene.empty() || arguments.tool.empty()))
    throw cli::Failure("--headless needs a scene and a tool, or an --experiment");
}

// False if all there was to do is done.
bool parse(int argc, char** argv, Arguments& arguments, Words& words) {
  CLI::App app("Shows two triangle models and what a hand feels between them");
  app.name("palpate-viewer");
  app.set_version_flag("--version", plp_version_string());
  add_models(app, arguments, words);
  add_hand(app, words);
  add_contact(app, arguments.settings, words);
  add_output(app, arguments, words);
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::ParseError& error) {
    // Help and version come as errors of code 0.
    if (error.get_exit_code() != 0) throw cli::Failure(error.what());
    app.exit(error);
    return false;
  }
}

// What the words ask for before all else that the command line says.
Arguments prepared(const Words& words) {
  Arguments arguments;
  if (!words.experiment.empty()) arguments = experiment(words.experiment, words.models);
  if (words.replay.empty()) return arguments;
  arguments.replay = std::make_shared<const cli::Motion>(words.replay);
  if (arguments.replay->bodies().size() != 2)
    throw cli::Failure(words.replay + ": is of more bodies than a tool and one other");
  if (arguments.replay->recorded()) arguments.settings = settings_of(arguments.replay->options());
  return arguments;
}

}  // namespace

std::optional<Arguments> parse_arguments(int argc, char** argv) {
  Arguments arguments;
  Words words;
  if (!parse(argc, argv, arguments, words)) return std::nullopt;
  arguments = prepared(words);
  words = Words();
  parse(argc, argv, arguments, words);
  apply(words, arguments);
  return arguments;
}

}  // namespace palpate::viewer
