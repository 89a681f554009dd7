#include "tests/oracle/oracle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace palpate::oracle {
namespace {

// Margins. A certain minimum is this far inside its polar cones and its features; one that the engine gives
// may lean outside by its stated parallel tolerance and the rounding of its points.
constexpr double kClearLean = -1e-8;
constexpr double kRoundingLean = 1e-7;
constexpr double kClearOutward = 1e-8;
constexpr double kClearParallel = 1e-5;  // sine
constexpr double kClearEnd = 1e-9;       // of the diagonal
constexpr double kAllowedLean = 1.5e-6;
constexpr double kSamePlace = 1e-9;   // of the diagonal
constexpr double kNearTouch = 1e-12;  // of the diagonal

constexpr std::size_t kBlockSize = 32;

Corners corners_of(const Surface& surface, TriangleIndex t) {
  const auto& c = surface.triangles[t];
  return {{surface.positions[c[0]], surface.positions[c[1]], surface.positions[c[2]]}};
}

Corners moved(const Corners& corners, const Pose& pose) {
  return {{pose * corners.at[0], pose * corners.at[1], pose * corners.at[2]}};
}

std::string text_of(const char* what, const DVec3& p, const DVec3& q, double distance) {
  std::ostringstream text;
  text.precision(17);
  text << what << " a(" << p.x << ", " << p.y << ", " << p.z << ") b(" << q.x << ", " << q.y << ", " << q.z
       << ") distance " << distance;
  return text.str();
}

}  // namespace

void Oracle::Verdict::add(int Verdict::*count, const std::string& what) {
  if (first.empty()) first = what;
  ++(this->*count);
}

Oracle::Oracle(const Surface& a, const Surface& b)
    : a_(a),
      b_(b),
      balls_a_(balls_of(a)),
      balls_b_(balls_of(b)),
      blocks_a_(blocks_of(balls_a_)),
      blocks_b_(blocks_of(balls_b_)),
      diagonal_(std::max(a.diagonal, b.diagonal)) {}

std::vector<Oracle::Ball> Oracle::balls_of(const Surface& surface) {
  std::vector<Ball> balls;
  for (TriangleIndex t = 0; t < surface.triangles.size(); ++t) {
    const Corners c = corners_of(surface, t);
    const DVec3 centre = (c.at[0] + c.at[1] + c.at[2]) / 3.0;
    double radius = 0.0;
    for (const DVec3& corner : c.at) radius = std::max(radius, glm::length(corner - centre));
    balls.push_back({centre, radius * (1 + 1e-9)});
  }
  return balls;
}

std::vector<Oracle::Block> Oracle::blocks_of(const std::vector<Ball>& balls) {
  std::vector<TriangleIndex> order(balls.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Block> blocks;
  const auto split = [&](const auto& self, std::size_t begin, std::size_t end) -> void {
    DVec3 low(1e300), high(-1e300);
    for (std::size_t i = begin; i < end; ++i) {
      low = glm::min(low, balls[order[i]].centre);
      high = glm::max(high, balls[order[i]].centre);
    }
    if (end - begin <= kBlockSize) {
      Block block{0.5 * (low + high), 0.0, {order.begin() + begin, order.begin() + end}};
      for (TriangleIndex t : block.triangles)
        block.radius = std::max(block.radius, glm::length(balls[t].centre - block.centre) + balls[t].radius);
      blocks.push_back(std::move(block));
      return;
    }
    const DVec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = (begin + end) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                     [&](auto s, auto t) { return balls[s].centre[axis] < balls[t].centre[axis]; });
    self(self, begin, middle);
    self(self, middle, end);
  };
  split(split, 0, order.size());
  return blocks;
}

template <class Visit>
void Oracle::for_near_pairs(const Pose& a_from_b, double cutoff, const Visit& visit) const {
  std::vector<DVec3> centres_b;
  for (const Ball& ball : balls_b_) centres_b.push_back(a_from_b * ball.centre);
  for (const Block& block_b : blocks_b_) {
    const DVec3 centre_b = a_from_b * block_b.centre;
    for (const Block& block_a : blocks_a_) {
      if (glm::length(centre_b - block_a.centre) > block_a.radius + block_b.radius + cutoff) continue;
      for (TriangleIndex in_b : block_b.triangles)
        for (TriangleIndex in_a : block_a.triangles) {
          const DVec3 between = centres_b[in_b] - balls_a_[in_a].centre;
          const double reach = balls_a_[in_a].radius + balls_b_[in_b].radius + cutoff;
          if (glm::dot(between, between) <= reach * reach) visit(in_a, in_b);
        }
    }
  }
}

Truth Oracle::search(const Pose& a_from_b, double cutoff) const {
  Truth truth;
  for_near_pairs(a_from_b, cutoff, [&](TriangleIndex in_a, TriangleIndex in_b) {
    measure(in_a, in_b, a_from_b, cutoff, truth);
  });
  return truth;
}

std::vector<Closest> Oracle::weak_minima(const Pose& a_from_b, double cutoff) const {
  std::vector<Closest> minima;
  for_near_pairs(a_from_b, cutoff, [&](TriangleIndex in_a, TriangleIndex in_b) {
    const Corners corners_a = corners_of(a_, in_a), corners_b = moved(corners_of(b_, in_b), a_from_b);
    if (crossing(corners_a, corners_b)) return;
    const Closest at = closest(a_, in_a, corners_a, b_, in_b, corners_b);
    if (at.distance > 1e-9 * diagonal_ && at.distance < cutoff * (1 - 1e-9) && weak(at, a_from_b))
      minima.push_back(at);
  });
  return minima;
}

bool Oracle::weak(const Closest& at, const Pose& a_from_b) const {
  if (at.margin < kClearEnd * diagonal_) return false;
  const DVec3 u = (at.on_b - at.on_a) / at.distance;
  const DVec3 back = glm::transpose(a_from_b.rotation) * -u;
  return a_.lean(at.place_a, u) <= kRoundingLean && b_.lean(at.place_b, back) <= kRoundingLean &&
         a_.outwardness(at.place_a, u) > kClearOutward && b_.outwardness(at.place_b, back) > kClearOutward;
}

void Oracle::measure(TriangleIndex in_a, TriangleIndex in_b, const Pose& a_from_b, double cutoff,
                     Truth& truth) const {
  const Corners corners_a = corners_of(a_, in_a);
  const Corners corners_b = moved(corners_of(b_, in_b), a_from_b);
  const Closest at = closest(a_, in_a, corners_a, b_, in_b, corners_b);
  if (crossing(corners_a, corners_b)) {
    truth.overlap = true;
    return;
  }
  if (at.distance < kNearTouch * diagonal_) truth.overlap_certain = false;
  if (at.distance > cutoff * (1 - 1e-9) || at.distance < kNearTouch * diagonal_) return;
  const bool seen = std::any_of(truth.certain.begin(), truth.certain.end(), [&](const Closest& c) {
    return c.place_a.dimension == at.place_a.dimension && c.place_a.index == at.place_a.index &&
           c.place_b.dimension == at.place_b.dimension && c.place_b.index == at.place_b.index;
  });
  if (!seen && certain(at, (at.on_b - at.on_a) / at.distance, a_from_b)) truth.certain.push_back(at);
}

// A face's own lean is 0 by construction and its points have no margin but that of the ends.
bool Oracle::certain(const Closest& at, const DVec3& u, const Pose& a_from_b) const {
  if (at.margin < kClearEnd * diagonal_) return false;
  const DVec3 back = glm::transpose(a_from_b.rotation) * -u;
  if (at.place_a.dimension == 1 &&
      at.place_b.dimension == 1) {  // parallel edges: any point between is as good
    const DVec3 along_b = a_from_b.rotation * b_.direction(at.place_b);
    if (glm::length(glm::cross(a_.direction(at.place_a), along_b)) < kClearParallel) return false;
  }
  if (at.place_a.dimension < 2 && a_.lean(at.place_a, u) > kClearLean) return false;
  if (at.place_b.dimension < 2 && b_.lean(at.place_b, back) > kClearLean) return false;
  return a_.outwardness(at.place_a, u) > kClearOutward && b_.outwardness(at.place_b, back) > kClearOutward;
}

bool Oracle::is_missed(const Closest& wanted, const LmdSet& found) const {
  return std::none_of(found.lmds.begin(), found.lmds.end(), [&](const Lmd& lmd) {
    return glm::length(lmd.point_a - wanted.on_a) + glm::length(lmd.point_b - wanted.on_b) < 1e-7 * diagonal_;
  });
}

// Checks one LMD of the engine against every clause of the definition.
std::string Oracle::fault_of(const Lmd& lmd, const Pose& a_from_b, double cutoff) const {
  if (!(lmd.distance > 0) || lmd.distance > cutoff * (1 + 1e-9)) return "distance outside (0, cutoff]";
  if (std::abs(glm::length(lmd.point_b - lmd.point_a) - lmd.distance) > kSamePlace * diagonal_)
    return "distance is not that of the points";
  if (glm::length(lmd.point_b - lmd.point_a - lmd.normal * lmd.distance) > kSamePlace * diagonal_)
    return "normal does not point from one to the other";
  // Where the points are, whatever the engine calls it.
  const double near = 1e-11 * diagonal_;
  const Place place_a = a_.lowest_at(a_.place_of(lmd.feature_a), lmd.point_a, near);
  const Place place_b = b_.lowest_at(b_.place_of(lmd.feature_b), inverse(a_from_b) * lmd.point_b, near);
  const double rounding = 1e-13 * diagonal_ / lmd.distance;
  const DVec3 back = glm::transpose(a_from_b.rotation) * -lmd.normal;
  if (a_.lean(place_a, lmd.normal) > kAllowedLean + rounding)
    return "outside A's polar cone by " + std::to_string(a_.lean(place_a, lmd.normal));
  if (b_.lean(place_b, back) > kAllowedLean + rounding)
    return "outside B's polar cone by " + std::to_string(b_.lean(place_b, back));
  if (a_.outwardness(place_a, lmd.normal) < -kClearOutward) return "into A";
  if (b_.outwardness(place_b, back) < -kClearOutward) return "into B";
  for (TriangleIndex in_a : a_.star(place_a))
    for (TriangleIndex in_b : b_.star(place_b)) {
      const Corners corners_a = corners_of(a_, in_a), corners_b = moved(corners_of(b_, in_b), a_from_b);
      const double distance =
          crossing(corners_a, corners_b) ? 0.0 : closest(a_, in_a, corners_a, b_, in_b, corners_b).distance;
      if (distance < lmd.distance - 4 * kAllowedLean * diagonal_)
        return "not minimal on a pair of its triangles";
      if (distance > lmd.distance + kSamePlace * diagonal_) return "points are not on their features";
    }
  return "";
}

Oracle::Verdict Oracle::compare(const LmdSet& found, const Truth& truth, const Pose& a_from_b,
                                double cutoff) const {
  Verdict verdict;
  if (truth.overlap_certain && truth.overlap != found.overlapping())
    verdict.add(&Verdict::wrong_overlap,
                truth.overlap ? "overlap not reported" : "overlap reported, there is none");
  for (const Closest& wanted : truth.certain)
    if (wanted.distance < cutoff * (1 - 1e-9) && is_missed(wanted, found))
      verdict.add(&Verdict::missed, text_of("missed", wanted.on_a, wanted.on_b, wanted.distance) +
                                        " places " + std::to_string(wanted.place_a.dimension) + " " +
                                        std::to_string(wanted.place_b.dimension));
  for (const Lmd& lmd : found.lmds) {
    const std::string fault = fault_of(lmd, a_from_b, cutoff);
    if (!fault.empty())
      verdict.add(&Verdict::spurious, text_of("spurious", lmd.point_a, lmd.point_b, lmd.distance) +
                                          " places " + std::to_string(a_.place_of(lmd.feature_a).dimension) +
                                          " " + std::to_string(b_.place_of(lmd.feature_b).dimension) + ": " +
                                          fault);
  }
  return verdict;
}

}  // namespace palpate::oracle
