#pragma once

#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/device/simulated/hand_motion.h"

namespace palpate {

struct RecordedPose {
  double time;  // s
  HandPose pose;
};

// Poses that were recorded: between two the position goes straight and the orientation along the shortest
// turn; before the first and after the last they hold.
class RecordedMotion final : public HandMotion {
 public:
  // Times must grow; a quaternion need not have unit length. The error names the row.
  static Result<std::shared_ptr<const HandMotion>> from(std::vector<RecordedPose> poses);

  // The recording's first pose is at time 0, whatever its own time.
  HandPose at(double time) const override;

 private:
  explicit RecordedMotion(std::vector<RecordedPose> poses) : poses_(std::move(poses)) {}

  std::vector<RecordedPose> poses_;
};

}  // namespace palpate
