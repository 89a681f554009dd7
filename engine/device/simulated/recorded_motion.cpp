#include "engine/device/simulated/recorded_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <utility>

namespace palpate {
namespace {

bool is_usable(const RecordedPose& recorded) {
  const DVec3& p = recorded.pose.position;
  const double length = glm::length(recorded.pose.orientation);
  return std::isfinite(recorded.time) && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
         std::isfinite(length) && length > 0.0;
}

Error error_at(std::size_t row, const char* what) {
  return {ErrorCode::kInvalidArgument, "recorded pose " + std::to_string(row) + ": " + what};
}

}  // namespace

Result<std::shared_ptr<const HandMotion>> RecordedMotion::from(std::vector<RecordedPose> poses) {
  if (poses.empty()) return Error{ErrorCode::kInvalidArgument, "a recorded motion needs at least one pose"};
  for (std::size_t row = 0; row < poses.size(); ++row) {
    if (!is_usable(poses[row])) return error_at(row, "not finite, or a quaternion of no length");
    if (row > 0 && poses[row].time <= poses[row - 1].time) return error_at(row, "its time does not grow");
    poses[row].pose.orientation = glm::normalize(poses[row].pose.orientation);
  }
  return std::shared_ptr<const HandMotion>(new RecordedMotion(std::move(poses)));
}

HandPose RecordedMotion::at(double time) const {
  const double wanted = poses_.front().time + time;
  const auto after = std::upper_bound(poses_.begin(), poses_.end(), wanted,
                                      [](double t, const RecordedPose& pose) { return t < pose.time; });
  if (after == poses_.begin()) return poses_.front().pose;
  if (after == poses_.end()) return poses_.back().pose;
  const RecordedPose& before = *(after - 1);
  const double part = (wanted - before.time) / (after->time - before.time);
  return {glm::mix(before.pose.position, after->pose.position, part),
          glm::normalize(glm::slerp(before.pose.orientation, after->pose.orientation, part))};
}

}  // namespace palpate
