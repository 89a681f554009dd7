#include "tests/support/motion.h"

#include <algorithm>
#include <cmath>

namespace palpate {
namespace {

constexpr double kTick = 1e-3;
constexpr double kWander = 0.05;  // how much the direction of motion turns in a tick

struct Nearest {
  bool overlap;
  double distance;
  DVec3 normal;
};

Nearest nearest(LmdSearch& search, LmdSet& found, const Model& a, const Model& b, const Pose& pose,
                double cutoff) {
  SearchOptions options;
  options.cutoff = cutoff;
  search.run(a, b, pose, options, found);
  Nearest result{found.overlapping(), cutoff, DVec3(0.0)};
  for (const Lmd& lmd : found.lmds)
    if (lmd.distance < result.distance) result = {found.overlapping(), lmd.distance, lmd.normal};
  return result;
}

}  // namespace

std::vector<Pose> sliding_motion(const Model& a, const Model& b, double cutoff, double speed, int ticks,
                                 Random& random) {
  LmdSearch search;
  LmdSet found;
  Pose pose = place_near(a, b, 0.3 * cutoff, random);
  DVec3 along = random.direction(), turning = random.direction();
  const double step = speed * kTick;
  std::vector<Pose> motion;
  Nearest now = nearest(search, found, a, b, pose, cutoff);
  while (static_cast<int>(motion.size()) < ticks) {
    motion.push_back(pose);
    along = glm::normalize(along + kWander * random.direction());
    turning = glm::normalize(turning + kWander * random.direction());
    const DVec3 centre = pose * b.centre();
    DVec3 move = along * step;
    if (now.distance < cutoff) {
      along = glm::normalize(along - now.normal * glm::dot(along, now.normal) + 1e-9 * random.direction());
      const double wanted = cutoff * (0.375 + 0.325 * std::sin(0.01 * static_cast<double>(motion.size())));
      move = 0.7 * step * along + now.normal * std::clamp(0.3 * (wanted - now.distance), -step, step);
    } else {
      move = 0.7 * step * along + glm::normalize(a.centre() - centre) * (0.7 * step);
    }
    const DMat3 turn = glm::mat3_cast(glm::angleAxis(step / b.radius() * 0.5, turning));
    Pose next{turn * pose.rotation, DVec3(0.0)};
    next.translation = centre + move - next.rotation * b.centre();
    Nearest then = nearest(search, found, a, b, next, cutoff);
    for (int tries = 0; then.overlap && tries < 60; ++tries) {
      next = Pose{pose.rotation, pose.translation + now.normal * step * static_cast<double>(tries)};
      then = nearest(search, found, a, b, next, cutoff);
    }
    pose = next;
    now = then;
  }
  return motion;
}

}  // namespace palpate
