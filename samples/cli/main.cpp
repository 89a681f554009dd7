#include <algorithm>
#include <cstdio>
#include <iostream>

#include <CLI/CLI.hpp>

#include "palpate/palpate.h"
#include "samples/cli/commands.h"
#include "samples/cli/failure.h"

namespace palpate::cli {
namespace {

void add_scale(CLI::App& command, const char* name, double& scale) {
  command.add_option(name, scale, "What the model's positions are multiplied by before anything else")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

void add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App* command = app.add_subcommand("info", "Describe a model and what was repaired in it");
  command->add_option("model", arguments.model, "A .gltf or .glb file")->required();
  add_scale(*command, "--scale", arguments.scale);
  command->add_flag("--json", arguments.json, "Print JSON");
  command->callback([&] { run_info(arguments); });
}

void add_scene(CLI::App& app, SceneArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("scene", "List the bodies of a glTF scene, a node and its mesh each");
  command->add_option("file", arguments.file, "A .gltf or .glb file")->required();
  command->add_option(
      "--tool", arguments.tool,
      "Name of the node that is the tool, with all that is below it; or /nodes/5 for its index");
  command->add_flag("--json", arguments.json, "Print JSON");
  command->callback([&] { run_scene(arguments); });
}

void add_query(CLI::App& app, QueryArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("query", "Find all local minimum distances between two models at one pose");
  command->add_option("a", arguments.a, "The model that stands still")->required();
  command->add_option("b", arguments.b, "The model that is placed by --pose")->required();
  add_scale(*command, "--scale-a", arguments.scale_a);
  add_scale(*command, "--scale-b", arguments.scale_b);
  command->add_option("--pose", arguments.pose, "px py pz qx qy qz qw: B's frame in A's, metres")->required();
  command->add_option("--cutoff", arguments.cutoff, "Metres: what is farther apart is not searched")
      ->required()
      ->check(CLI::PositiveNumber);
  command->add_option("--stiffness", arguments.stiffness, "N/m of the springs")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", arguments.json, "Print JSON");
  command->callback([&] { run_query(arguments); });
}

void add_run(CLI::App& app, RunArguments& arguments) {
  CLI::App* command = app.add_subcommand("run", "Move one model along a trajectory past another");
  command->add_option("a", arguments.a, "The model that stands still, or the glTF scene of a trace")
      ->required();
  command->add_option("b", arguments.b, "The model that moves; not if a trace has it from a scene");
  add_scale(*command, "--scale-a", arguments.scale_a);
  add_scale(*command, "--scale-b", arguments.scale_b);
  command->add_option("--trajectory", arguments.trajectory, "CSV: t,px,py,pz,qx,qy,qz,qw; or a trace")
      ->required();
  command->add_option("--cutoff", arguments.cutoff, "Metres: what is farther apart is not searched")
      ->check(CLI::PositiveNumber);
  command->add_option("--stiffness", arguments.stiffness, "N/m of the springs")
      ->default_str("1000")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--mode", arguments.mode,
                   "global: the complete set from scratch every tick; certified: the complete set kept up to "
                   "date; descent: local descent from the last search")
      ->default_str("certified");
  command
      ->add_option("--global-every", arguments.global_every,
                   "While descending, ticks from one search to the next")
      ->default_str("10");
  command->add_option("--damping", arguments.damping, "N·s/m that a spring adds while it closes")
      ->default_str("0")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--friction", arguments.friction, "Coulomb's coefficient")
      ->default_str("0")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--stiffness-cap", arguments.stiffness_cap,
                   "N/m that all springs together do not exceed; 0 for no cap")
      ->default_str("0")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--law", arguments.law,
                   "smooth: continuous in the pose; springs: one for every local minimum distance")
      ->default_str("smooth");
  command->add_flag("--threaded", arguments.threaded,
                    "Follow the trajectory at its own rate while a servo thread steps the scene, rather than "
                    "as fast as it can");
  command->add_flag(
      "--compare", arguments.compare,
      "Search every tick from scratch, too, and tell what the mode missed and how far its force is off");
  command->add_option("--record", arguments.record, "Write a trace, which --trajectory takes");
  command->add_option("--out", arguments.out, "Write a CSV row for each tick");
  command->add_flag("--json", arguments.json, "Print the summary as JSON");
  command->callback([&] { run_trajectory(arguments); });
}

void add_devices(CLI::App& app, DevicesArguments& arguments) {
  CLI::App* command = app.add_subcommand("devices", "List the haptic devices that could be opened");
  command->add_flag("--json", arguments.json, "Print JSON");
  command->callback([&] { run_devices(arguments); });
}

int complain(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  std::cerr << "palpate: " << sentence << '\n';
  return 1;
}

int run(int argc, char** argv) {
  CLI::App app("Finds every contact between triangle models");
  app.name("palpate");
  app.set_version_flag("--version", plp_version_string());
  app.require_subcommand(1);
  InfoArguments info;
  SceneArguments scene;
  QueryArguments query;
  RunArguments trajectory;
  DevicesArguments devices;
  add_info(app, info);
  add_scene(app, scene);
  add_query(app, query);
  add_run(app, trajectory);
  add_devices(app, devices);
  try {
    app.parse(argc, argv);
    std::cout.flush();
    if (!std::cout) throw Failure("standard output: cannot be written");
    return 0;
  } catch (const CLI::ParseError& error) {
    // Help and version come as errors of code 0.
    return error.get_exit_code() == 0 ? app.exit(error) : complain(error.what());
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace
}  // namespace palpate::cli

int main(int argc, char** argv) {
  try {
    return palpate::cli::run(argc, argv);
  } catch (...) {
    // Nothing but a lack of memory comes as far.
    std::fputs("palpate: out of memory\n", stderr);
    return 1;
  }
}
