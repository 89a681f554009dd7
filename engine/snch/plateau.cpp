#include "engine/snch/plateau.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace palpate {
namespace {

// Minima this close are one place: the rounding of a direction at their distance.
constexpr double kMergeAngle = 4e-6;

// Corners of a hull this close to a straight side, relative to the hull, are on it. It is more than cells are
// inset.
constexpr double kStraight = 3e-5;

// A minimum on more pairs of triangles than this is linked by looking at the others rather than by listing
// its pairs.
constexpr std::size_t kManyPairs = 64;

bool holds_feature(const Mesh& mesh, std::uint32_t triangle, const Feature& feature) {
  if (feature.kind == FeatureKind::kFace) return feature.index == triangle;
  const auto& parts =
      feature.kind == FeatureKind::kEdge ? mesh.triangle_edges[triangle] : mesh.triangles[triangle];
  return std::find(parts.begin(), parts.end(), feature.index) != parts.end();
}

// The better of two minima at one place: less lean, then the lower features.
auto merit(const Minimum& m) {
  const int dimensions = 4 - static_cast<int>(m.feature_a.kind) - static_cast<int>(m.feature_b.kind);
  return std::tuple(std::max(m.violation, 0.0), dimensions, m.feature_a, m.feature_b);
}

double apart(const Minimum& one, const Minimum& other) {
  return std::max(glm::length(one.point_a - other.point_a), glm::length(one.point_b - other.point_b));
}

Lmd lmd_of(const Minimum& m, double weight, std::uint32_t set) {
  return {m.point_a, m.point_b, m.normal, m.distance, weight, set, m.feature_a, m.feature_b};
}

// The axis of the plane at right angles to `normal` that is nearest to a coordinate axis far from it.
DVec3 plane_axis(const DVec3& normal) {
  const DVec3 size = glm::abs(normal);
  const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  DVec3 axis(0.0);
  axis[least] = 1.0;
  return glm::normalize(axis - normal * normal[least]);
}

}  // namespace

double PlateauGrouper::distance_between(const PlanePoint& one, const PlanePoint& other) {
  return std::hypot(other.x - one.x, other.y - one.y);
}

// Twice the area of a triangle, positive if it turns left.
double PlateauGrouper::turn(const PlanePoint& from, const PlanePoint& middle, const PlanePoint& to) {
  return (middle.x - from.x) * (to.y - from.y) - (middle.y - from.y) * (to.x - from.x);
}

double PlateauGrouper::extent_of(const std::vector<PlanePoint>& points) {
  double extent = 0.0;
  for (const PlanePoint& point : points) extent = std::max(extent, distance_between(points.front(), point));
  return extent;
}

double PlateauGrouper::distance_to_segment(const PlanePoint& point, const PlanePoint& from,
                                           const PlanePoint& to) {
  const double x = to.x - from.x, y = to.y - from.y, length_squared = x * x + y * y;
  const double along = ((point.x - from.x) * x + (point.y - from.y) * y) / std::max(length_squared, 1e-300);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(point.x - from.x - t * x, point.y - from.y - t * y);
}

void PlateauGrouper::group(const Mesh& a, const Mesh& b, double touch, std::vector<Minimum>& minima,
                           LmdSet& found) {
  std::sort(minima.begin(), minima.end(), precedes);
  parents_.resize(minima.size());
  std::iota(parents_.begin(), parents_.end(), 0u);
  link_by_triangle_pairs(a, b, minima);
  sort_into_groups();

  found.lmds.clear();
  found.set_count = 0;
  for (std::size_t i = 0, end; i < grouped_.size(); i = end) {
    for (end = i + 1; end < grouped_.size() && parents_[grouped_[end]] == parents_[grouped_[i]];) ++end;
    emit_group(grouped_.data() + i, grouped_.data() + end, minima, touch, found);
  }
}

void PlateauGrouper::fix(std::size_t minima) {
  fixed_ = minima > 0;
  if (!fixed_) return;
  parents_.reserve(minima);
  grouped_.reserve(minima);
  hubs_.reserve(minima);
  keys_.reserve(8 * minima);  // whoever finds no room becomes a hub
  points_.reserve(minima);
  inset_points_.reserve(minima);
  hull_.reserve(2 * minima + 2);
  weights_.reserve(minima);
}

void PlateauGrouper::link_by_triangle_pairs(const Mesh& a, const Mesh& b,
                                            const std::vector<Minimum>& minima) {
  keys_.clear();
  hubs_.clear();
  for (std::uint32_t i = 0; i < minima.size(); ++i) {
    if (minima[i].alone) continue;
    const auto of_a = triangles_at(a, minima[i].feature_a), of_b = triangles_at(b, minima[i].feature_b);
    const std::size_t pairs = of_a.size() * of_b.size();
    if (pairs > kManyPairs || (fixed_ && !has_room(keys_, pairs))) {
      hubs_.push_back(i);
      continue;
    }
    for (std::uint32_t in_a : of_a)
      for (std::uint32_t in_b : of_b) keys_.push_back({in_a, in_b, i});
  }
  std::sort(keys_.begin(), keys_.end());
  for (std::size_t i = 1; i < keys_.size(); ++i)
    if (keys_[i].a == keys_[i - 1].a && keys_[i].b == keys_[i - 1].b)
      unite(keys_[i].minimum, keys_[i - 1].minimum);
  for (std::uint32_t hub : hubs_) link_hub(a, b, minima, hub);
}

// Two hubs share a pair of triangles if they share a triangle on either side.
void PlateauGrouper::link_hub(const Mesh& a, const Mesh& b, const std::vector<Minimum>& minima,
                              std::uint32_t hub) {
  for (const PairKey& key : keys_)
    if (holds_feature(a, key.a, minima[hub].feature_a) && holds_feature(b, key.b, minima[hub].feature_b))
      unite(hub, key.minimum);
  const auto share = [](const Mesh& mesh, const Feature& one, const Feature& other) {
    const auto triangles = triangles_at(mesh, one);
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](std::uint32_t triangle) { return holds_feature(mesh, triangle, other); });
  };
  for (std::uint32_t other : hubs_)
    if (other < hub && share(a, minima[hub].feature_a, minima[other].feature_a) &&
        share(b, minima[hub].feature_b, minima[other].feature_b))
      unite(hub, other);
}

void PlateauGrouper::unite(std::uint32_t one, std::uint32_t other) {
  one = root_of(one);
  other = root_of(other);
  parents_[std::max(one, other)] = std::min(one, other);
}

std::uint32_t PlateauGrouper::root_of(std::uint32_t minimum) {
  while (parents_[minimum] != minimum) minimum = parents_[minimum] = parents_[parents_[minimum]];
  return minimum;
}

void PlateauGrouper::sort_into_groups() {
  grouped_.resize(parents_.size());
  std::iota(grouped_.begin(), grouped_.end(), 0u);
  for (std::uint32_t i = 0; i < parents_.size(); ++i) parents_[i] = root_of(i);
  std::sort(grouped_.begin(), grouped_.end(), [this](std::uint32_t one, std::uint32_t other) {
    return std::tie(parents_[one], one) < std::tie(parents_[other], other);
  });
}

void PlateauGrouper::emit_group(const std::uint32_t* begin, const std::uint32_t* end,
                                const std::vector<Minimum>& minima, double touch, LmdSet& found) {
  const std::uint32_t set = found.set_count++;
  const auto better = [&](std::uint32_t one, std::uint32_t other) {
    return merit(minima[one]) < merit(minima[other]);
  };
  const Minimum& best = minima[*std::min_element(begin, end, better)];
  const double merge = kMergeAngle * best.distance + 16 * touch;
  if (std::all_of(begin, end, [&](std::uint32_t i) { return apart(minima[i], best) <= merge; })) {
    found.lmds.push_back(lmd_of(best, 1.0, set));
    return;
  }
  project(begin, end, minima);
  find_hull(merge);
  const PlanePoint middle = middle_of_rim();
  thin_hull();
  weigh_hull(middle);
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    std::uint32_t chosen = hull_[i].minimum;
    for (const std::uint32_t* other = begin; other != end; ++other)
      if (apart(minima[*other], minima[hull_[i].minimum]) <= merge && better(*other, chosen)) chosen = *other;
    found.lmds.push_back(lmd_of(minima[chosen], weights_[i], set));
  }
}

// Splits a group into its points in the plane of the plateau, those of cells apart.
void PlateauGrouper::project(const std::uint32_t* begin, const std::uint32_t* end,
                             const std::vector<Minimum>& minima) {
  const DVec3 x_axis = plane_axis(minima[*begin].normal);
  const DVec3 y_axis = glm::cross(minima[*begin].normal, x_axis);
  points_.clear();
  inset_points_.clear();
  for (const std::uint32_t* i = begin; i != end; ++i) {
    const Minimum& minimum = minima[*i];
    (minimum.inset ? inset_points_ : points_)
        .push_back({glm::dot(minimum.point_a, x_axis), glm::dot(minimum.point_a, y_axis), *i});
  }
}

// The hull of the minima; corners of cells widen it where they are farther out than their inset.
void PlateauGrouper::find_hull(double merge) {
  wrap_points();
  straighten_hull(merge);
  // Of a cell one end alone may be there, where the other touches or is beyond the cutoff.
  const double extent = std::max(extent_of(hull_), extent_of(inset_points_));
  const double near = std::max(merge, kStraight * extent);
  points_ = hull_;
  for (const PlanePoint& point : inset_points_)
    if (hull_.empty() || distance_outside(point) > near) points_.push_back(point);
  if (points_.size() == hull_.size()) return;
  wrap_points();
  straighten_hull(merge);
}

// The convex hull of `points_` (Andrew 1979).
void PlateauGrouper::wrap_points() {
  hull_.clear();
  if (points_.empty()) return;
  std::sort(points_.begin(), points_.end(), [](const PlanePoint& one, const PlanePoint& other) {
    return std::tie(one.x, one.y, one.minimum) < std::tie(other.x, other.y, other.minimum);
  });
  if (points_.size() == 1) return hull_.push_back(points_.front());
  const auto extend = [&](const PlanePoint& point, std::size_t floor) {
    while (hull_.size() >= floor && !(turn(hull_[hull_.size() - 2], hull_.back(), point) > 0))
      hull_.pop_back();
    hull_.push_back(point);
  };
  for (const PlanePoint& point : points_) extend(point, 2);
  const std::size_t upper = hull_.size() + 1;
  for (std::size_t i = points_.size() - 1; i-- > 0;) extend(points_[i], upper);
  hull_.pop_back();
}

// How far a point lies outside the hull, measured from its sides.
double PlateauGrouper::distance_outside(const PlanePoint& point) const {
  if (hull_.size() < 3) return distance_to_segment(point, hull_.front(), hull_.back());
  double outside = 0.0;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const PlanePoint &from = hull_[i], &to = hull_[(i + 1) % hull_.size()];
    outside = std::max(outside, -turn(from, to, point) / distance_between(from, to));
  }
  return outside;
}

// Leaves out corners within `merge` of the side that their neighbours would make. Together with find_hull
// rather than inside it: a tolerance in the hull's own test loses corners where many points share their first
// coordinate.
void PlateauGrouper::straighten_hull(double merge) {
  for (const PlanePoint& corner : hull_)
    merge = std::max(merge, kStraight * distance_between(hull_.front(), corner));
  for (std::size_t kept = 0, i = 0; hull_.size() > 2 && kept < hull_.size();) {
    const PlanePoint& before = hull_[(i + hull_.size() - 1) % hull_.size()];
    const PlanePoint& after = hull_[(i + 1) % hull_.size()];
    if (distance_to_segment(hull_[i], before, after) <= merge) {
      hull_.erase(hull_.begin() + static_cast<std::ptrdiff_t>(i));
      kept = 0;
    } else {
      ++i, ++kept;
    }
    i %= hull_.size();
  }
}

// The middle of the hull's rim, which does not depend on how finely the rim is cut.
PlateauGrouper::PlanePoint PlateauGrouper::middle_of_rim() const {
  PlanePoint middle{0.0, 0.0, 0};
  double rim = 0.0;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const PlanePoint &from = hull_[i], &to = hull_[(i + 1) % hull_.size()];
    const double side = distance_between(from, to);
    middle.x += 0.5 * side * (from.x + to.x);
    middle.y += 0.5 * side * (from.y + to.y);
    rim += side;
  }
  return rim > 0 ? PlanePoint{middle.x / rim, middle.y / rim, 0} : hull_.front();
}

// Half the length of the sides beside each corner, then corrected by as little as puts their balance at
// `middle`.
void PlateauGrouper::weigh_hull(const PlanePoint& middle) {
  const std::size_t count = hull_.size();
  weights_.assign(count, 0.0);
  double rim = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double side = distance_between(hull_[i], hull_[(i + 1) % count]);
    weights_[i] += 0.5 * side;
    weights_[(i + 1) % count] += 0.5 * side;
    rim += side;
  }
  if (!(rim > 0)) return weights_.assign(count, 1.0 / static_cast<double>(count));
  double xx = 0, xy = 0, yy = 0, off_x = middle.x, off_y = middle.y, mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < count; ++i) {
    weights_[i] /= rim;
    off_x -= weights_[i] * hull_[i].x;
    off_y -= weights_[i] * hull_[i].y;
    mean_x += hull_[i].x / static_cast<double>(count);
    mean_y += hull_[i].y / static_cast<double>(count);
  }
  for (const PlanePoint& corner : hull_) {
    xx += (corner.x - mean_x) * (corner.x - mean_x);
    xy += (corner.x - mean_x) * (corner.y - mean_y);
    yy += (corner.y - mean_y) * (corner.y - mean_y);
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return;  // a segment balances as it is
  const double lean_x = (yy * off_x - xy * off_y) / determinant,
               lean_y = (xx * off_y - xy * off_x) / determinant;
  const auto correction = [&](std::size_t i) {
    return lean_x * (hull_[i].x - mean_x) + lean_y * (hull_[i].y - mean_y);
  };
  for (std::size_t i = 0; i < count; ++i)
    if (weights_[i] + correction(i) <= 0) return;
  for (std::size_t i = 0; i < count; ++i) weights_[i] += correction(i);
}

// Leaves at most kMaxPoints corners, each the farthest from those already chosen, in their order around the
// hull.
void PlateauGrouper::thin_hull() {
  if (hull_.size() <= kMaxPoints) return;
  std::array<std::size_t, kMaxPoints> chosen{};  // the first is the hull's first corner, of least x
  for (std::size_t count = 1; count < kMaxPoints; ++count) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < count; ++k)
        nearest = std::min(nearest, distance_between(hull_[chosen[k]], hull_[i]));
      if (nearest > farthest) farthest = nearest, chosen[count] = i;
    }
  }
  std::sort(chosen.begin(), chosen.end());
  for (std::size_t k = 0; k < kMaxPoints; ++k) hull_[k] = hull_[chosen[k]];
  hull_.resize(kMaxPoints);
}

}  // namespace palpate
