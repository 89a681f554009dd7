#pragma once

#include "samples/viewer/rig.h"

namespace palpate::viewer {

// Who leads the tool: poses of a file, a script, or keys and mouse.
class Hand {
 public:
  Hand(const Content& content, Rig& rig);

  // Before the step that is `tick`th: without a device the tool goes to its pose.
  void before_step(std::uint64_t tick);

  // Keys and mouse have moved the wish within the last `seconds`.
  void move(const Vec3& by, const Vec3& turn, double seconds);

  // A scripted hand begins anew, from where it is now.
  void begin(MotionKind kind);

  Placement wanted() const;  // now
  bool scripted() const { return !poses_.empty(); }
  MotionKind kind() const { return kind_; }

 private:
  void follow(std::vector<cli::TimedPose> poses);

  const Content& content_;
  Rig& rig_;
  MotionKind kind_;
  std::vector<cli::TimedPose> poses_;  // empty: keys and mouse lead
  double began_ = 0.0;                 // s
  Placement held_;                     // by keys and mouse
};

}  // namespace palpate::viewer
