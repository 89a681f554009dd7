#pragma once

#include <array>
#include <optional>
#include <string>

namespace palpate::cli {

struct InfoArguments {
  std::string model;
  double scale = 1.0;
  bool json = false;
};

struct SceneArguments {
  std::string file;
  std::string tool;  // node; empty: none
  bool json = false;
};

struct QueryArguments {
  std::string a;
  std::string b;
  double scale_a = 1.0;  // of the models, before anything else
  double scale_b = 1.0;
  std::array<double, 7> pose{};  // px py pz qx qy qz qw: B's frame in A's, metres
  double cutoff = 0.0;           // metres
  double stiffness = 1000.0;     // N/m
  bool json = false;
};

// What is not given is as in the trace that is followed, or else as usual.
struct RunArguments {
  std::string a;
  std::string b;         // empty: a trace's tool is a node of the scene
  double scale_a = 1.0;  // of the models, before anything else
  double scale_b = 1.0;
  std::string trajectory;
  std::optional<double> cutoff;         // metres
  std::optional<double> stiffness;      // N/m
  std::optional<double> damping;        // N·s/m
  std::optional<double> friction;       // Coulomb's coefficient
  std::optional<double> stiffness_cap;  // N/m; 0: none
  std::optional<std::string> mode;
  std::optional<std::string> law;
  std::optional<unsigned> global_every;  // ticks, while descending
  bool compare = false;                  // with the complete set of every tick
  bool threaded = false;                 // a servo runs at the trajectory's own rate
  std::string out;                       // empty: no file
  std::string record;                    // a trace of the run; empty: none
  bool json = false;
};

struct DevicesArguments {
  bool json = false;
};

// Each prints to standard output and throws Failure.
void run_info(const InfoArguments& arguments);
void run_scene(const SceneArguments& arguments);
void run_query(const QueryArguments& arguments);
void run_devices(const DevicesArguments& arguments);
void run_trajectory(const RunArguments& arguments);

}  // namespace palpate::cli
