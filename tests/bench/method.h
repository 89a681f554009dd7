#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "engine/contact/spring.h"
#include "engine/math/pose.h"
#include "engine/snch/lmd.h"

namespace palpate::bench {

inline constexpr double kStiffness = 1000.0;  // N/m

// What a method found at one pose.
struct Outcome {
  std::size_t lmds = 0;  // a plateau counts once
  double min_distance = std::numeric_limits<double>::infinity();
  Wrench wrench;  // on the tool about the centre of its bounding sphere, frame of the other model
  bool overlap = false;
  std::size_t followed = 0;  // LMDs that a descent followed, whose time is also told for each
  SearchWork work;           // of the engine's methods
  double aside_us = 0.0;     // of the time, what belongs to another thread than the servo's
};

// One way to find how two models touch, measured pose by pose.
class Method {
 public:
  virtual ~Method() = default;

  virtual std::string name() const = 0;
  virtual std::string returns() const = 0;

  // A method without memory that is slow needs to see only every so-manyth pose.
  virtual std::size_t every() const { return 1; }

  // Another motion begins.
  virtual void restart() {}

  // What comes before an update and is not measured.
  virtual void prepare(const Pose& a_from_b) { static_cast<void>(a_from_b); }
  virtual void update(const Pose& a_from_b) = 0;

  // Of the last update.
  virtual Outcome outcome() const = 0;
};

// The outcome of a method that finds single contacts: springs push there, torques are about `reference`.
Outcome outcome_of(const std::vector<SpringContact>& contacts, double cutoff, const DVec3& reference);

}  // namespace palpate::bench
