#include "engine/snch/plateau.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace palpate {
namespace {

constexpr std::size_t kMaxPoints = 8;

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

double PlateauGrouper::distance_to_segment(const PlanePoint& point, const PlanePoint& from,
                                           const PlanePoint& to) {
  const double x = to.x - from.x, y = to.y - from.y, length_squared = x * x + y * y;
  const double along = ((point.x - from.x) * x + (point.y - from.y) * y) / std::max(length_squared, 1e-300);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(point.x - from.x - t * x, point.y - from.y - t * y);
}

void PlateauGrouper::group(const Mesh& a, const Mesh& b, const Limits& limits, std::vector<Minimum>& minima,
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
    emit_group(grouped_.data() + i, grouped_.data() + end, minima, limits, found);
  }
}

void PlateauGrouper::link_by_triangle_pairs(const Mesh& a, const Mesh& b,
                                            const std::vector<Minimum>& minima) {
  keys_.clear();
  for (std::uint32_t i = 0; i < minima.size(); ++i) {
    if (minima[i].alone) continue;
    for (std::uint32_t of_a : triangles_at(a, minima[i].feature_a))
      for (std::uint32_t of_b : triangles_at(b, minima[i].feature_b)) keys_.push_back({of_a, of_b, i});
  }
  std::sort(keys_.begin(), keys_.end());
  for (std::size_t i = 1; i < keys_.size(); ++i) {
    if (keys_[i].a != keys_[i - 1].a || keys_[i].b != keys_[i - 1].b) continue;
    const std::uint32_t one = root_of(keys_[i].minimum), other = root_of(keys_[i - 1].minimum);
    parents_[std::max(one, other)] = std::min(one, other);
  }
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
                                const std::vector<Minimum>& minima, const Limits& limits, LmdSet& found) {
  const std::uint32_t set = found.set_count++;
  const auto better = [&](std::uint32_t one, std::uint32_t other) {
    return merit(minima[one]) < merit(minima[other]);
  };
  const Minimum& best = minima[*std::min_element(begin, end, better)];
  const double merge = 4 * limits.parallel_tolerance * best.distance + 16 * limits.touch;
  if (std::all_of(begin, end, [&](std::uint32_t i) { return apart(minima[i], best) <= merge; })) {
    found.lmds.push_back(lmd_of(best, 1.0, set));
    return;
  }
  find_hull(begin, end, minima);
  straighten_hull(merge);
  thin_hull();
  // A hull of two points has two sides between them, so this holds for segments as well.
  std::array<double, kMaxPoints> weights{};
  double perimeter = 0.0;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const std::size_t next = (i + 1) % hull_.size();
    const double side = distance_between(hull_[i], hull_[next]);
    weights[i] += 0.5 * side;
    weights[next] += 0.5 * side;
    perimeter += side;
  }
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    std::uint32_t chosen = hull_[i].minimum;
    for (const std::uint32_t* other = begin; other != end; ++other)
      if (apart(minima[*other], minima[hull_[i].minimum]) <= merge && better(*other, chosen)) chosen = *other;
    found.lmds.push_back(lmd_of(minima[chosen], hull_.size() == 1 ? 1.0 : weights[i] / perimeter, set));
  }
}

// The convex hull in the plane of the plateau (Andrew 1979).
void PlateauGrouper::find_hull(const std::uint32_t* begin, const std::uint32_t* end,
                               const std::vector<Minimum>& minima) {
  const DVec3 x_axis = plane_axis(minima[*begin].normal);
  const DVec3 y_axis = glm::cross(minima[*begin].normal, x_axis);
  points_.clear();
  for (const std::uint32_t* i = begin; i != end; ++i)
    points_.push_back({glm::dot(minima[*i].point_a, x_axis), glm::dot(minima[*i].point_a, y_axis), *i});
  std::sort(points_.begin(), points_.end(), [](const PlanePoint& one, const PlanePoint& other) {
    return std::tie(one.x, one.y, one.minimum) < std::tie(other.x, other.y, other.minimum);
  });
  const auto turns_left = [](const PlanePoint& from, const PlanePoint& middle, const PlanePoint& to) {
    return (middle.x - from.x) * (to.y - from.y) - (middle.y - from.y) * (to.x - from.x) > 0;
  };
  hull_.clear();
  const auto extend = [&](const PlanePoint& point, std::size_t floor) {
    while (hull_.size() >= floor && !turns_left(hull_[hull_.size() - 2], hull_.back(), point))
      hull_.pop_back();
    hull_.push_back(point);
  };
  for (const PlanePoint& point : points_) extend(point, 2);
  const std::size_t upper = hull_.size() + 1;
  for (std::size_t i = points_.size() - 1; i-- > 0;) extend(points_[i], upper);
  hull_.pop_back();
}

// Leaves out corners within `merge` of the side that their neighbours would make. Together with find_hull
// rather than inside it: a tolerance in the hull's own test loses corners where many points share their first
// coordinate.
void PlateauGrouper::straighten_hull(double merge) {
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
