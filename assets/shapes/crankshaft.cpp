#include "assets/shapes/crankshaft.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

constexpr double kPi = std::numbers::pi;

// Metres. A web's own frame is y along its throw, z across.
constexpr double kThrow = 0.022;
constexpr double kMainRadius = 0.013;
constexpr double kMainLength = 0.022;
constexpr double kPinRadius = 0.011;
constexpr double kPinLength = 0.018;
constexpr double kFillet = 0.002;
constexpr double kWebThickness = 0.009;
constexpr double kWebChamfer = 0.0008;
constexpr double kWebShrink = 0.97;  // of the outline where the chamfer meets the face
constexpr double kPinEndRadius = 0.017;
constexpr double kWaist = 0.021;
constexpr double kCounterweightY = -0.020;  // corner of the counterweight
constexpr double kCounterweightZ = 0.033;
constexpr double kSnoutRadius = 0.0085;
constexpr double kSnoutLength = 0.025;
constexpr double kFlangeRadius = 0.028;
constexpr double kFlangeThickness = 0.008;
constexpr double kFlangeBore = 0.010;
constexpr double kEdgeChamfer = 0.001;
constexpr int kFilletSteps = 4;
constexpr int kWebs = 8;

using Angles = std::vector<double>;

void add_arc(Ring& ring, double centre_y, double radius, double from, double to, int steps) {
  for (int i = 0; i < steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    ring.emplace_back(0.0, centre_y + radius * std::cos(angle), radius * std::sin(angle));
  }
}

void add_line(Ring& ring, const DVec3& from, const DVec3& to, int steps) {
  for (int i = 0; i < steps; ++i) ring.push_back(from + (to - from) * (static_cast<double>(i) / steps));
}

// Pin end, flank, waist (a concave edge), shoulder, counterweight. Every ray from the main axis or from the
// pin's axis leaves it once, which keeps the web's faces free of folds.
Ring web_outline(int segments) {
  const int tenth = segments / 20;
  const DVec3 pin_end(0.0, kThrow, kPinEndRadius);
  const DVec3 waist(0.0, 0.0, kWaist);
  const DVec3 corner(0.0, kCounterweightY, kCounterweightZ);
  Ring half;
  add_arc(half, kThrow, kPinEndRadius, 0.0, 0.5 * kPi, 3 * tenth);
  add_line(half, pin_end, waist, 2 * tenth);
  add_line(half, waist, corner, tenth);
  add_arc(half, 0.0, glm::length(corner), std::atan2(corner.z, corner.y), kPi, 4 * tenth);

  Ring ring = half;
  ring.emplace_back(0.0, -glm::length(corner), 0.0);
  for (auto point = half.rbegin(); point + 1 != half.rend(); ++point)
    ring.emplace_back(0.0, point->y, -point->z);
  return ring;
}

// Half a turn about x that also keeps point 0 on the +y side, so that rings of opposite throws join without a
// twist.
Ring opposite(Ring ring) {
  for (DVec3& point : ring) point = {point.x, -point.y, -point.z};
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2), ring.end());
  return ring;
}

// Directions in which the points of an outline are seen from a centre, ascending.
Angles angles_from(const Ring& outline, double centre_y) {
  Angles angles;
  for (const DVec3& point : outline) {
    double angle = std::atan2(point.z, point.y - centre_y);
    while (!angles.empty() && angle < angles.back()) angle += 2.0 * kPi;
    angles.push_back(angle);
  }
  return angles;
}

Angles mean(const Angles& a, const Angles& b) {
  Angles result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(0.5 * (a[i] + b[i]));
  return result;
}

Ring at_x(Ring ring, double x) {
  for (DVec3& point : ring) point.x = x;
  return ring;
}

Ring round_ring(double x, double centre_y, double radius, const Angles& angles) {
  Ring ring;
  for (const double angle : angles) {
    ring.emplace_back(x, centre_y + radius * std::cos(angle), radius * std::sin(angle));
  }
  return ring;
}

// Throws at 0, 180, 180 and 0 degrees, two webs to a throw.
bool points_down(int web) {
  return web / 2 == 1 || web / 2 == 2;
}

double pin_y(bool down) {
  return down ? -kThrow : kThrow;
}

// Lays ring after ring from the snout to the flange.
class ShaftLoft {
 public:
  explicit ShaftLoft(int segments) : outline_(web_outline(segments)) {
    for (const DVec3& point : outline_) shrunk_.push_back(kWebShrink * point);
    for (int i = 0; i < segments; ++i) even_.push_back(turn(i, segments));
  }

  TriangleSoup build() {
    add_snout();
    for (int web = 0; web < kWebs; ++web) {
      add_web(web);
      if (web + 1 < kWebs) add_inner_journal(web);
    }
    add_flange();
    TriangleSoup soup = capped_loft(rings_);
    translate(soup, {-0.5 * x_, 0.0, 0.0});
    return rounded_to_float32(std::move(soup));
  }

 private:
  struct Journal {
    double centre_y;
    double radius;
    double length;
  };

  static Journal journal_after(int web) {
    if (web % 2 == 0) return {pin_y(points_down(web)), kPinRadius, kPinLength};
    return {0.0, kMainRadius, kMainLength};
  }

  static Ring oriented(const Ring& outline, int web) {
    return points_down(web) ? opposite(outline) : outline;
  }
  Angles web_angles(int web, double centre_y) const { return angles_from(oriented(shrunk_, web), centre_y); }

  void add_round(double x, double centre_y, double radius, const Angles& angles) {
    rings_.push_back(round_ring(x, centre_y, radius, angles));
  }
  void add_even(double x, double radius) { add_round(x, 0.0, radius, even_); }

  // Concave quarter circle from a journal to the face that it stands on. `towards` is +1 if the face lies
  // ahead.
  void add_fillet(double face_x, double centre_y, double radius, const Angles& angles, int towards) {
    for (int i = 0; i <= kFilletSteps; ++i) {
      const int step = towards > 0 ? i : kFilletSteps - i;
      const double angle = 0.5 * kPi * step / kFilletSteps;
      const double away = kFillet * (1.0 - std::sin(angle));
      add_round(face_x - towards * away, centre_y, radius + kFillet * (1.0 - std::cos(angle)), angles);
    }
  }

  // What lies between two rings of one plane.
  void add_face(const Ring& from, const Ring& to) {
    for (int i = 1; i <= 3; ++i) {
      Ring ring;
      for (std::size_t k = 0; k < from.size(); ++k) ring.push_back(from[k] + (to[k] - from[k]) * (i / 4.0));
      rings_.push_back(std::move(ring));
    }
  }

  void add_web(int web) {
    const Ring outline = oriented(outline_, web);
    const Ring shrunk = oriented(shrunk_, web);
    const double end = x_ + kWebThickness;
    const Ring last = rings_.back();
    add_face(last, at_x(shrunk, x_));
    rings_.push_back(at_x(shrunk, x_));
    for (int i = 0; i <= 4; ++i) {
      const double depth = kWebChamfer + (kWebThickness - 2.0 * kWebChamfer) * i / 4.0;
      rings_.push_back(at_x(outline, x_ + depth));
    }
    rings_.push_back(at_x(shrunk, end));
    const Journal next = journal_after(web);
    add_face(at_x(shrunk, end),
             round_ring(end, next.centre_y, next.radius + kFillet, web_angles(web, next.centre_y)));
    x_ = end;
  }

  void add_inner_journal(int web) {
    const auto [centre_y, radius, length] = journal_after(web);
    const Angles start = web_angles(web, centre_y);
    const Angles end = web_angles(web + 1, centre_y);
    add_fillet(x_, centre_y, radius, start, -1);
    add_round(x_ + 0.3 * length, centre_y, radius, mean(start, even_));
    add_round(x_ + 0.5 * length, centre_y, radius, even_);
    add_round(x_ + 0.7 * length, centre_y, radius, mean(end, even_));
    add_fillet(x_ + length, centre_y, radius, end, +1);
    x_ += length;
  }

  void add_snout() {
    add_even(0.0, kSnoutRadius - kEdgeChamfer);
    add_even(kEdgeChamfer, kSnoutRadius);
    for (const double part : {0.25, 0.5, 0.75}) add_even(part * kSnoutLength, kSnoutRadius);
    add_even(kSnoutLength - kFillet, kSnoutRadius);
    add_even(kSnoutLength - 0.4 * kFillet, kSnoutRadius + 0.4 * kFillet);
    add_even(kSnoutLength, kSnoutRadius + kFillet);
    add_even(kSnoutLength, kMainRadius);
    x_ = kSnoutLength + kMainLength;
    const Angles end = web_angles(0, 0.0);
    add_round(kSnoutLength + 0.5 * kMainLength, 0.0, kMainRadius, mean(even_, end));
    add_fillet(x_, 0.0, kMainRadius, end, +1);
  }

  void add_flange() {
    const Angles start = web_angles(kWebs - 1, 0.0);
    add_fillet(x_, 0.0, kMainRadius, start, -1);
    add_round(x_ + 0.5 * kMainLength, 0.0, kMainRadius, mean(start, even_));
    x_ += kMainLength;
    add_even(x_ - kFillet, kMainRadius);
    add_even(x_ - 0.4 * kFillet, kMainRadius + 0.4 * kFillet);
    add_even(x_, kMainRadius + kFillet);
    add_even(x_, kFlangeRadius - kEdgeChamfer);
    add_even(x_ + kEdgeChamfer, kFlangeRadius);
    x_ += kFlangeThickness;
    add_even(x_ - kEdgeChamfer, kFlangeRadius);
    add_even(x_, kFlangeRadius - kEdgeChamfer);
    add_even(x_, kFlangeBore);
    add_even(x_ - 0.5 * kFlangeThickness, 0.9 * kFlangeBore);
  }

  Ring outline_;
  Ring shrunk_;  // of a web's face, inside the chamfer
  Angles even_;
  std::vector<Ring> rings_;
  double x_ = 0.0;  // where the next web or journal begins
};

}  // namespace

TriangleSoup crankshaft(int segments) {
  return ShaftLoft(segments).build();
}

}  // namespace palpate::shapes
