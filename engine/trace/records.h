#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>

namespace palpate {

// What a trace holds, in Palpate's own space: metres, seconds, newtons. Numbers are kept bit by bit.

using TraceVector = std::array<double, 3>;

struct TracePose {
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  // its columns one after another
  TraceVector translation{};
};

// The caller's space, which a reader converts to.
struct TraceSpace {
  std::array<std::int32_t, 3> axes{1, 2, 3};
  double metres_per_unit = 1.0;
};

// What a scene may change between steps.
struct TraceSettings {
  double cutoff = 0.0;
  double stiffness = 0.0;
  double damping = 0.0;
  double stiffness_cap = 0.0;
  double friction = 0.0;
  std::uint32_t mode = 0;  // 0 global, 1 descent, 2 certified
  std::uint32_t law = 0;   // 0 springs, 1 smooth

  friend bool operator==(const TraceSettings&, const TraceSettings&) = default;
};

// What a scene keeps for its life.
struct TraceHeader {
  TraceSpace space;
  TraceSettings settings;  // as the recording began
  std::uint32_t global_every = 0;
  std::uint32_t tick_budget = 0;
  std::uint64_t max_overlaps = 0;
  double fade_time = 0.0;
  double time_step = 0.0;  // of steps that a caller makes
};

struct TraceBody {
  std::uint64_t id = 0;
  std::uint32_t kind = 0;        // 0 static, 1 moving, 2 tool
  std::uint32_t intangible = 0;  // 1: the tool passes through it
  std::uint64_t triangles = 0;
  std::uint64_t hash = 0;  // of the model's geometry
  double stiffness = 0.0;
  double damping = 0.0;
  double friction = 0.0;
  TraceVector reference_point{};
  std::string name;  // of the model, for people
};

struct TraceWork {
  std::uint64_t bodies = 0;
  std::uint64_t body_pairs = 0;
  std::uint64_t node_pairs = 0;
  std::uint64_t triangle_pairs = 0;
  std::uint64_t descents = 0;
  std::uint64_t descent_steps = 0;
  std::uint64_t front_entries = 0;
  std::uint64_t front_expired = 0;
  std::uint64_t age = 0;
  std::uint64_t rebuilds = 0;
  double global_us = 0.0;
};

// One step. What is counted last follows it, in that order.
struct TraceTick {
  std::uint64_t step = 0;  // of its scene, from 1
  double clock = 0.0;      // seconds since the recording began
  double time_step = 0.0;  // seconds
  std::uint64_t lost = 0;  // ticks just before that found no room
  std::uint64_t tool = 0;  // 0: none
  TracePose tool_pose;
  TraceVector force{};
  TraceVector torque{};
  double min_distance = 0.0;
  double step_us = 0.0;
  TraceWork work;
  std::uint32_t status = 0;
  std::uint32_t overlap = 0;  // 1: surfaces touch or cross
  std::uint32_t overlap_count = 0;
  std::uint32_t set_count = 0;
  std::uint32_t settings_count = 0;  // 1: they are others than in the tick before
  std::uint32_t removed_count = 0;   // bodies removed since
  std::uint32_t pose_count = 0;      // bodies moved since, but for the tool
  std::uint32_t contact_count = 0;

  std::uint64_t parts() const {
    return std::uint64_t{settings_count} + removed_count + pose_count + contact_count;
  }
};

struct TraceRemoval {
  std::uint64_t body = 0;
};

struct TraceMove {
  std::uint64_t body = 0;
  TracePose pose;
};

struct TraceContact {
  TraceVector point_a{};
  TraceVector point_b{};
  TraceVector normal{};
  double distance = 0.0;
  double weight = 0.0;
  TraceVector force{};
  std::uint64_t body_a = 0;
  std::uint64_t body_b = 0;
  std::uint32_t set = 0;
  std::array<std::uint8_t, 2> feature{};  // of a and of b: 0 face, 1 edge, 2 vertex
  std::array<std::uint8_t, 2> corner{};
  std::array<std::uint32_t, 2> triangle{};
};

// What a recorder hands on, a tick after another: the tick, then its parts.
using TraceCell = std::variant<TraceTick, TraceSettings, TraceRemoval, TraceMove, TraceContact>;

// How a recording ended.
struct TraceEnd {
  std::uint64_t ticks = 0;
  std::uint64_t lost = 0;
};

}  // namespace palpate
