#include "tests/stress/reference.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace palpate::stress {
namespace {

// A minimum is certain this far inside its borders; what is weak by less than the engine's own tolerance is
// undecided. Widths are in A's normalised frame, whose float32 grid is about 1e-7.
constexpr double kClearLean = 1e-12;
constexpr double kEnd = 1e-12;  // nearer to its end than that, a point is not on a feature
constexpr double kClearEnd = 1e-10;
constexpr double kPlateauEnd = 4e-7;

// Of a plateau, rounding may let an end lean outside; up to nearly the angle below which directions count as
// parallel it must be found all the same. Farther outside it is no minimum by the definition, however near.
constexpr double kPlateauLean = 9e-7;

constexpr double kClearOutward = 1e-7;
constexpr double kNearTouch = 1e-12;
constexpr double kEdgesParallel = 2e-9;

std::string text_of(const char* what, const RVec3& p, const RVec3& q, Real distance) {
  std::ostringstream text;
  text.precision(17);
  const DVec3 a(p), b(q);
  text << what << " a(" << a.x << ", " << a.y << ", " << a.z << ") b(" << b.x << ", " << b.y << ", " << b.z
       << ") distance " << static_cast<double>(distance);
  return text.str();
}

bool same_place(const oracle::Place& one, const oracle::Place& other) {
  return one.dimension == other.dimension && one.index == other.index;
}

double size_of(const DVec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// How far a point lies outside the convex hull of points in the plane across `normal`, in the worst of many
// directions.
double outside_hull(const DVec3& point, const std::vector<DVec3>& corners, const DVec3& normal) {
  constexpr int kDirections = 360;
  const DVec3 x =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7 ? DVec3(1, 0, 0) : DVec3(0, 1, 0)));
  const DVec3 y = glm::cross(normal, x);
  double outside = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * M_PI * i / kDirections;
    const DVec3 direction = x * std::cos(angle) + y * std::sin(angle);
    double reach = -1e300;
    for (const DVec3& corner : corners) reach = std::max(reach, glm::dot(corner - point, direction));
    outside = std::max(outside, -reach);
  }
  return outside;
}

bool finite(const Lmd& lmd) {
  return std::isfinite(size_of(lmd.point_a) + size_of(lmd.point_b) + size_of(lmd.normal) + lmd.distance +
                       lmd.weight);
}

}  // namespace

void Verdict::add(const Verdict& other) {
  missed += other.missed;
  spurious += other.spurious;
  wrong_overlap += other.wrong_overlap;
  undecided += other.undecided;
  certain += other.certain;
  not_numbers += other.not_numbers;
  errors.insert(errors.end(), other.errors.begin(), other.errors.end());
  if (first.empty()) first = other.first;
}

ExactTriangle Reference::Side::triangle(std::uint32_t t) const {
  const auto& c = surface.triangles[t];
  return {{vertices[c[0]], vertices[c[1]], vertices[c[2]]}};
}

oracle::Place Reference::Side::place(std::uint32_t t, int code) const {
  if (code == 6) return {2, t};
  return code < 3 ? oracle::Place{0, surface.triangles[t][code]}
                  : oracle::Place{1, surface.edge(t, code - 3)};
}

Real Reference::Side::lean(oracle::Place place, const RVec3& u) const {
  if (place.dimension == 2) return length(cross(u, normals[place.index]));
  Real most = -1;
  for (std::uint32_t t : surface.star(place)) {
    const auto& c = surface.triangles[t];
    if (place.dimension == 0) {
      for (std::uint32_t corner : c)
        if (corner != place.index)
          most = std::max(most, dot(u, unit(vertices[corner] - vertices[place.index])));
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      if (surface.edge(t, k) != place.index) continue;
      const RVec3 along = unit(vertices[c[(k + 1) % 3]] - vertices[c[k]]);
      most = std::max(most, dot(u, cross(normals[t], along)));
    }
  }
  return most;
}

Real Reference::Side::slant(oracle::Place place, const RVec3& u) const {
  if (place.dimension != 1) return 0;
  const std::uint32_t t = surface.star(place).front();
  int side = 0;
  while (surface.edge(t, side) != place.index) ++side;
  return fabsq(dot(u, unit(triangle(t).along(side))));
}

// Angle-weighted as the engine's; the angles themselves need no more than double precision.
Real Reference::Side::outwardness(oracle::Place place, const RVec3& u) const {
  if (surface.skips_outward_test(place)) return 1;
  if (place.dimension == 2) return dot(u, normals[place.index]);
  RVec3 sum;
  for (std::uint32_t t : surface.star(place)) {
    Real weight = 1;
    if (place.dimension == 0) {
      const auto& c = surface.triangles[t];
      const auto k = std::find(c.begin(), c.end(), place.index) - c.begin();
      const RVec3 one = vertices[c[(k + 1) % 3]] - vertices[place.index],
                  other = vertices[c[(k + 2) % 3]] - vertices[place.index];
      weight = atan2q(length(cross(one, other)), dot(one, other));
    }
    sum = sum + normals[t] * weight;
  }
  const Real size = length(sum);
  return size > 0 ? dot(u, sum) / size : Real(0);
}

oracle::Place Reference::Side::lowest_at(oracle::Place place, const RVec3& point, Real near) const {
  if (place.dimension == 0) return place;
  const std::uint32_t t = surface.star(place).front();
  const auto& c = surface.triangles[t];
  for (int k = 0; k < 3; ++k)
    if (length(vertices[c[k]] - point) <= near &&
        (place.dimension == 2 || surface.edge(t, k) == place.index ||
         surface.edge(t, (k + 2) % 3) == place.index))
      return {0, c[k]};
  if (place.dimension == 1) return place;
  for (int k = 0; k < 3; ++k) {
    const RVec3 along = unit(vertices[c[(k + 1) % 3]] - vertices[c[k]]), arm = point - vertices[c[k]];
    if (length(arm - along * dot(arm, along)) <= near) return {1, surface.edge(t, k)};
  }
  return place;
}

Real Reference::Side::distance_to(Feature feature, const RVec3& point) const {
  const oracle::Place place = surface.place_of(feature);
  if (place.dimension == 0) return length(point - vertices[place.index]);
  const std::uint32_t t = surface.star(place).front();
  const ExactTriangle shape = triangle(t);
  if (place.dimension == 2) {
    const RVec3 normal = unit(shape.area());
    Real outside = fabsq(dot(point - shape.corner[0], normal));
    for (int k = 0; k < 3; ++k)
      outside = std::max(outside, -dot(cross(normal, unit(shape.along(k))), point - shape.start(k)));
    return outside;
  }
  int side = 0;
  while (surface.edge(t, side) != place.index) ++side;
  const RVec3 along = shape.along(side), arm = point - shape.start(side);
  const Real s = std::clamp(dot(arm, along) / dot(along, along), Real(0), Real(1));
  return length(arm - along * s);
}

Reference::Side Reference::side_of(const Mesh& mesh) {
  Side side{oracle::Surface(mesh), {}, {}, {}, {}};
  for (const Vec3& position : mesh.positions) side.vertices.emplace_back(position);
  return side;
}

void Reference::finish(Side& side) const {
  for (std::uint32_t t = 0; t < side.surface.triangles.size(); ++t) {
    const ExactTriangle shape = side.triangle(t);
    side.normals.push_back(unit(shape.area()));
    const DVec3 corners[] = {DVec3(shape.corner[0]), DVec3(shape.corner[1]), DVec3(shape.corner[2])};
    const DVec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
    double radius = 0.0;
    for (const DVec3& corner : corners) radius = std::max(radius, glm::length(corner - centre));
    side.centres.push_back(centre);
    side.radii.push_back(radius * (1 + 1e-9) + 1e-12);
  }
}

Reference::Reference(const Mesh& a, const Mesh& b, const Pose& a_from_b, double cutoff)
    : a_(side_of(a)), b_(side_of(b)), frame_(a.frame), cutoff_(cutoff / a.frame.scale) {
  const Real scale = a.frame.scale, ratio = Real(b.frame.scale) / scale;
  const RVec3 x(a_from_b.rotation[0]), y(a_from_b.rotation[1]), z(a_from_b.rotation[2]);
  const auto turned = [&](const RVec3& v) { return x * v.x + y * v.y + z * v.z; };
  const RVec3 shift =
      (turned(RVec3(b.frame.origin)) + RVec3(a_from_b.translation) - RVec3(a.frame.origin)) / scale;
  for (RVec3& vertex : b_.vertices) vertex = turned(vertex) * ratio + shift;
  finish(a_);
  finish(b_);
  const double far = size_of(a.frame.origin) + size_of(b.frame.origin) + size_of(a_from_b.translation);
  rounding_ = 1e-15 * (1.0 + static_cast<double>(ratio)) + 4.5e-16 * far / a.frame.scale;
  for (std::uint32_t in_b = 0; in_b < b_.centres.size(); ++in_b)
    for (std::uint32_t in_a = 0; in_a < a_.centres.size(); ++in_a)
      if (glm::length(b_.centres[in_b] - a_.centres[in_a]) <= a_.radii[in_a] + b_.radii[in_b] + cutoff_)
        measure(in_a, in_b);
}

void Reference::measure(std::uint32_t in_a, std::uint32_t in_b) {
  const ExactClosest at = exact_closest(a_.triangle(in_a), b_.triangle(in_b));
  const double near_touch = kNearTouch + 16 * rounding_;
  if (at.distance == 0) overlap_ = true;
  if (at.distance < near_touch) overlap_certain_ = false;
  if (at.distance < near_touch || at.distance > cutoff_ * (1 - 1e-9)) return;
  Wanted wanted{at.distance, at.on_a, at.on_b, a_.place(in_a, at.place_a), b_.place(in_b, at.place_b), false};
  for (const Wanted& other : wanted_)
    if (same_place(other.place_a, wanted.place_a) && same_place(other.place_b, wanted.place_b)) return;
  const RVec3 u = (at.on_b - at.on_a) / at.distance;
  const Real tolerance = 2e-6 + 16 * rounding_ / at.distance;
  const Real lean_a = a_.lean(wanted.place_a, u), lean_b = b_.lean(wanted.place_b, -u);
  if (lean_a > tolerance || lean_b > tolerance) return;
  if (a_.outwardness(wanted.place_a, u) < kClearOutward || b_.outwardness(wanted.place_b, -u) < kClearOutward)
    return;
  const Real noise = kClearLean + 4 * rounding_ / at.distance;
  const bool face_a = wanted.place_a.dimension == 2, face_b = wanted.place_b.dimension == 2;
  const Real lean = std::max(face_a ? Real(-1) : lean_a, face_b ? Real(-1) : lean_b);
  wanted.certain = lean < -noise && at.margin > kClearEnd + 4 * rounding_;
  if (wanted.certain && wanted.place_a.dimension == 1 && wanted.place_b.dimension == 1) {
    const auto along = [](const Side& side, std::uint32_t t, int code) {
      return unit(side.triangle(t).along(code - 3));
    };
    wanted.certain = length(cross(along(a_, in_a, at.place_a), along(b_, in_b, at.place_b))) > kEdgesParallel;
  }
  const Real plateau_lean = std::min(1e-15 + rounding_ / at.distance, Real(kPlateauLean));
  const bool plateau = lean < plateau_lean && at.margin > kPlateauEnd;
  wanted.certain = wanted.certain || plateau;
  wanted_.push_back(wanted);
}

RVec3 Reference::normalised(const DVec3& metres) const {
  return (RVec3(metres) - RVec3(frame_.origin)) / frame_.scale;
}

Real Reference::feature_size(oracle::Place place_a, oracle::Place place_b) const {
  Real size_a = 0, size_b = 0;
  for (std::uint32_t t : a_.surface.star(place_a)) size_a = std::max(size_a, a_.triangle(t).longest_side());
  for (std::uint32_t t : b_.surface.star(place_b)) size_b = std::max(size_b, b_.triangle(t).longest_side());
  return std::min(size_a, size_b);
}

bool Reference::covered(const Wanted& wanted, const LmdSet& found, double tolerance) const {
  const double distance = static_cast<double>(wanted.distance);
  const DVec3 on_a(wanted.on_a), on_b(wanted.on_b), normal = (on_b - on_a) / distance;
  const double near = 5e-6 * distance + 1e-9 + 64 * rounding_;
  for (std::size_t i = 0, end; i < found.lmds.size(); i = end) {
    std::vector<DVec3> corners;
    double extent = 0.0;
    for (end = i; end < found.lmds.size() && found.lmds[end].set == found.lmds[i].set; ++end) {
      corners.push_back(DVec3(normalised(found.lmds[end].point_a)));
      const DVec3 other(normalised(found.lmds[end].point_b));
      if (glm::length(corners.back() - on_a) < near && glm::length(other - on_b) < near) return true;
      extent = std::max(extent, glm::length(corners.back() - corners.front()));
    }
    const double gap = found.lmds[i].distance / frame_.scale - distance;
    if (std::abs(gap) > 4 * tolerance * (extent + distance) + near) continue;
    if (glm::length(found.lmds[i].normal - normal) > 8 * tolerance + 64 * rounding_ / distance) continue;
    const double slack = near + 4e-7 + 1e-4 * extent + (corners.size() == 8 ? 0.15 * extent : 0.0);
    if (outside_hull(on_a, corners, normal) <= slack) return true;
  }
  return false;
}

// There is one on these very features, be it as near to their ends as it may: no lower one decides.
bool Reference::has_weak_minimum(oracle::Place place_a, oracle::Place place_b) const {
  return std::any_of(wanted_.begin(), wanted_.end(), [&](const Wanted& wanted) {
    return same_place(wanted.place_a, place_a) && same_place(wanted.place_b, place_b);
  });
}

std::string Reference::fault_of(const Lmd& lmd, double tolerance) const {
  const RVec3 p = normalised(lmd.point_a), q = normalised(lmd.point_b), u(lmd.normal);
  const double distance = lmd.distance / frame_.scale;
  const double noise = 64 * rounding_ + 1e-13, allowed = 1.5 * tolerance + noise / distance;
  if (!(distance > 0) || distance > cutoff_ * (1 + 1e-9)) return "distance outside (0, cutoff]";
  if (length(q - p - u * distance) > noise) return "normal does not lead from one point to the other";
  auto place_a = a_.surface.place_of(lmd.feature_a), place_b = b_.surface.place_of(lmd.feature_b);
  if (!has_weak_minimum(place_a, place_b)) {
    place_a = a_.lowest_at(place_a, p, kEnd + noise);
    place_b = b_.lowest_at(place_b, q, kEnd + noise);
  }
  const auto lean_a = static_cast<double>(std::max(a_.lean(place_a, u), a_.slant(place_a, u))),
             lean_b = static_cast<double>(std::max(b_.lean(place_b, -u), b_.slant(place_b, u)));
  if (lean_a > allowed) return "outside A's polar cone by " + std::to_string(1e6 * lean_a) + " urad";
  if (lean_b > allowed) return "outside B's polar cone by " + std::to_string(1e6 * lean_b) + " urad";
  if (a_.outwardness(place_a, u) < -kClearOutward) return "into A";
  if (b_.outwardness(place_b, -u) < -kClearOutward) return "into B";
  return "";
}

// How far the points are off their features and the distance off that of the points.
double Reference::error_of(const Lmd& lmd) const {
  const RVec3 p = normalised(lmd.point_a), q = normalised(lmd.point_b);
  const Real off = std::max({a_.distance_to(lmd.feature_a, p), b_.distance_to(lmd.feature_b, q),
                             fabsq(length(q - p) - lmd.distance / Real(frame_.scale))});
  return static_cast<double>(
      off / feature_size(a_.surface.place_of(lmd.feature_a), b_.surface.place_of(lmd.feature_b)));
}

Verdict Reference::judge(const LmdSet& found, double tolerance, bool complete) const {
  Verdict verdict;
  const auto fault = [&verdict](int Verdict::*count, const std::string& what) {
    ++(verdict.*count);
    if (verdict.first.empty()) verdict.first = what;
  };
  for (const Lmd& lmd : found.lmds) {
    if (!finite(lmd)) {
      fault(&Verdict::not_numbers, "not a number");
      continue;
    }
    verdict.errors.push_back(error_of(lmd));
    const std::string what = fault_of(lmd, tolerance);
    if (what.empty()) continue;
    fault(&Verdict::spurious,
          text_of("spurious", normalised(lmd.point_a), normalised(lmd.point_b), lmd.distance / frame_.scale) +
              " dimensions " + std::to_string(2 - static_cast<int>(lmd.feature_a.kind)) +
              std::to_string(2 - static_cast<int>(lmd.feature_b.kind)) + ": " + what);
  }
  if (!complete) return verdict;
  const bool nearly = std::any_of(found.lmds.begin(), found.lmds.end(), [this](const Lmd& lmd) {
    return lmd.distance / frame_.scale < 64 * rounding_;
  });
  if (overlap_ && !nearly && !found.overlapping()) fault(&Verdict::wrong_overlap, "overlap not reported");
  if (!overlap_ && overlap_certain_ && found.overlapping())
    fault(&Verdict::wrong_overlap, "overlap reported, there is none");
  for (const Wanted& wanted : wanted_) {
    verdict.certain += wanted.certain;
    verdict.undecided += !wanted.certain;
    if (!wanted.certain || covered(wanted, found, tolerance)) continue;
    fault(&Verdict::missed, text_of("missed", wanted.on_a, wanted.on_b, wanted.distance) + " dimensions " +
                                std::to_string(wanted.place_a.dimension) +
                                std::to_string(wanted.place_b.dimension));
  }
  return verdict;
}

}  // namespace palpate::stress
