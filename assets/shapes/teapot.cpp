// Based on: M. E. Newell, "The Utilization of Procedure Models in Digital Image Synthesis", University of
// Utah, 1975. His 306 control points are redundant: body and lid are profiles turned through four quarters,
// handle and spout are mirrored in y = 0. Here each number is given once.
#include "assets/shapes/teapot.h"

#include <array>

#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

using Curve = std::array<DVec3, 4>;  // control points of a cubic
using Patch = std::array<Curve, 4>;  // rows along u

// A control point of a profile. `handle` is the tangent length of its quarter circle: Newell used 0.56 of the
// radius, but 0.45 for 0.8 at the pole of the lid.
struct ProfilePoint {
  double radius;
  double z;
  double handle;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr ProfilePoint turned(double radius, double z) {
  return {radius, z, 0.56 * radius};
}

constexpr std::array<Profile, 5> kProfiles = {{
    {turned(1.4, 2.4), turned(1.3375, 2.53125), turned(1.4375, 2.53125), turned(1.5, 2.4)},   // rim
    {turned(1.5, 2.4), turned(1.75, 1.875), turned(2.0, 1.35), turned(2.0, 0.9)},             // body
    {turned(2.0, 0.9), turned(2.0, 0.45), turned(1.5, 0.225), turned(1.5, 0.15)},             // foot
    {turned(0.0, 3.15), ProfilePoint{0.8, 3.15, 0.45}, turned(0.0, 2.85), turned(0.2, 2.7)},  // knob
    {turned(0.2, 2.7), turned(0.4, 2.55), turned(1.3, 2.55), turned(1.3, 2.4)},               // lid
}};

// Half of a handle or spout cross-section: it leaves the symmetry plane at `inner`, swings out to y = −width,
// and returns at `outer`.
struct Section {
  double inner_x, inner_z;
  double outer_x, outer_z;
  double width;
};
using Limb = std::array<Section, 4>;

constexpr std::array<Limb, 4> kLimbs = {{
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3.0, 2.25, 0.3},
      {-2.7, 1.8, -3.0, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3.0, 1.8, 0.3},
      {-2.7, 1.575, -3.0, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2.0, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

// Exact: swaps and signs only, so that neighbours agree to the last bit.
DVec3 quarter_turned(const DVec3& p, int quarters) {
  DVec3 q = p;
  for (int i = 0; i < quarters; ++i) q = {q.y, -q.x, q.z};
  return q;
}

Patch turned_patch(const Profile& profile, int quarters) {
  Patch patch;
  for (int i = 0; i < 4; ++i) {
    const auto& [radius, z, handle] = profile[i];
    patch[i] = {DVec3(radius, 0, z), {radius, -handle, z}, {handle, -radius, z}, {0, -radius, z}};
    for (DVec3& point : patch[i]) point = quarter_turned(point, quarters);
  }
  return patch;
}

Patch limb_patch(const Limb& limb, bool mirrored) {
  Patch patch;
  for (int i = 0; i < 4; ++i) {
    const Section& s = limb[i];
    const double y = mirrored ? s.width : -s.width;
    patch[i] = {DVec3(s.inner_x, 0, s.inner_z),
                {s.inner_x, y, s.inner_z},
                {s.outer_x, y, s.outer_z},
                {s.outer_x, 0, s.outer_z}};
  }
  return patch;
}

DVec3 evaluate(const Curve& c, double t) {
  const double s = 1.0 - t;
  return c[0] * (s * s * s) + c[1] * (3.0 * s * s * t) + c[2] * (3.0 * s * t * t) + c[3] * (t * t * t);
}

DVec3 evaluate(const Patch& patch, double u, double v) {
  return evaluate(
      {evaluate(patch[0], v), evaluate(patch[1], v), evaluate(patch[2], v), evaluate(patch[3], v)}, u);
}

void add_patch(TriangleSoup& soup, const Patch& patch, int n, bool reversed) {
  const auto base = static_cast<std::uint32_t>(soup.positions.size());
  const auto row = static_cast<std::uint32_t>(n) + 1;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const DVec3 point = evaluate(patch, static_cast<double>(i) / n, static_cast<double>(j) / n);
      soup.positions.push_back(kTeapotMetresPerUnit * (point - kTeapotCentre));
    }
  }
  TriangleSoup cells;
  for (std::uint32_t i = 0; i + 1 < row; ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = base + i * row + j;
      cells.triangles.push_back({a, a + 1, a + row + 1});
      cells.triangles.push_back({a, a + row + 1, a + row});
    }
  }
  if (reversed) turn_inside_out(cells);
  soup.triangles.insert(soup.triangles.end(), cells.triangles.begin(), cells.triangles.end());
}

}  // namespace

TriangleSoup teapot(int divisions) {
  TriangleSoup soup;
  for (const Profile& profile : kProfiles) {
    for (int quarters = 0; quarters < 4; ++quarters)
      add_patch(soup, turned_patch(profile, quarters), divisions, false);
  }
  for (const Limb& limb : kLimbs) {
    for (const bool mirrored : {false, true})
      add_patch(soup, limb_patch(limb, mirrored), divisions, mirrored);
  }
  return welded(soup);
}

}  // namespace palpate::shapes
