#include "assets/shapes/helicopter.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

// One station of a body along x [m].
struct Station {
  double x;
  double half_width;
  double half_height;
  double z;
};

constexpr Station kFuselage[] = {
    {-0.060, 0.006, 0.007, 0.012}, {-0.050, 0.016, 0.016, 0.008}, {-0.030, 0.025, 0.026, 0.002},
    {0.000, 0.029, 0.031, 0.000},  {0.030, 0.029, 0.031, 0.000},  {0.055, 0.026, 0.026, -0.004},
    {0.075, 0.019, 0.018, -0.010}, {0.086, 0.010, 0.010, -0.014}, {0.090, 0.003, 0.003, -0.015},
};
constexpr Station kTailBoom[] = {{-0.190, 0.003, 0.004, 0.020},
                                 {-0.150, 0.005, 0.006, 0.018},
                                 {-0.090, 0.008, 0.009, 0.015},
                                 {-0.040, 0.011, 0.013, 0.010}};
constexpr Station kCowling[] = {
    {-0.045, 0.004, 0.003, 0.028}, {-0.038, 0.012, 0.008, 0.030}, {-0.010, 0.016, 0.011, 0.032},
    {0.015, 0.014, 0.009, 0.032},  {0.028, 0.006, 0.004, 0.030},  {0.030, 0.002, 0.002, 0.029},
};

// Catmull-Rom weights of four stations.
Station blend(const Station& a, const Station& b, const Station& c, const Station& d, double t) {
  const double wa = 0.5 * t * (-1.0 + t * (2.0 - t));
  const double wb = 0.5 * (2.0 + t * t * (3.0 * t - 5.0));
  const double wc = 0.5 * t * (1.0 + t * (4.0 - 3.0 * t));
  const double wd = 0.5 * t * t * (t - 1.0);
  const auto mix = [&](double Station::*m) { return wa * a.*m + wb * b.*m + wc * c.*m + wd * d.*m; };
  return {mix(&Station::x), mix(&Station::half_width), mix(&Station::half_height), mix(&Station::z)};
}

Station station_at(std::span<const Station> stations, double along) {
  const double scaled = along * static_cast<double>(stations.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(scaled), stations.size() - 2);
  const Station& before = stations[i == 0 ? 0 : i - 1];
  const Station& after = stations[std::min(i + 2, stations.size() - 1)];
  return blend(before, stations[i], stations[i + 1], after, scaled - static_cast<double>(i));
}

// `power` bends the cross-sections from ellipses (2) towards rectangles.
TriangleSoup body(std::span<const Station> stations, int around, int rings, double power) {
  std::vector<Ring> sections;
  for (int i = 0; i < rings; ++i) {
    const Station s = station_at(stations, static_cast<double>(i) / (rings - 1));
    sections.push_back(oval_ring(around, {s.x, 0, s.z}, {0, s.half_width, 0}, {0, 0, s.half_height}, power));
  }
  return capped_loft(sections);
}

// A flat oval that runs from root to tip and tapers; `chord` and `thickness` are half axes at the root, at
// right angles to the way and to one another, chord × thickness pointing from root to tip.
struct Foil {
  DVec3 root;
  DVec3 tip;
  DVec3 chord;
  DVec3 thickness;
  double taper;  // size of the tip over that of the root
};

TriangleSoup blade(const Foil& foil, int around, int rings) {
  std::vector<Ring> sections;
  for (int i = 0; i < rings; ++i) {
    const double along = static_cast<double>(i) / (rings - 1);
    const double size = 1.0 + (foil.taper - 1.0) * along;
    const DVec3 centre = foil.root + (foil.tip - foil.root) * along;
    sections.push_back(oval_ring(around, centre, foil.chord * size, foil.thickness * size));
  }
  return capped_loft(sections);
}

// A round bar along a plane curve; `side` is the normal of the plane.
TriangleSoup bar(const std::vector<DVec3>& path, const DVec3& side, double radius, int around) {
  std::vector<Ring> sections;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const DVec3& before = path[i == 0 ? 0 : i - 1];
    const DVec3& after = path[std::min(i + 1, path.size() - 1)];
    sections.push_back(circle_ring(around, path[i], glm::normalize(after - before), side, radius));
  }
  return capped_loft(sections);
}

// A drum along `axis` with a rounded rim; `side` is any direction across the axis.
TriangleSoup drum(const DVec3& centre, const DVec3& axis, const DVec3& side, double radius,
                  double half_height, int around, int rings) {
  std::vector<Ring> sections;
  for (int i = 0; i < rings; ++i) {
    const double along = 2.0 * i / (rings - 1) - 1.0;
    const double bulge = radius * std::sqrt(1.0 - 0.75 * std::pow(std::abs(along), 4.0));
    sections.push_back(circle_ring(around, centre + axis * (along * half_height), axis, side, bulge));
  }
  return capped_loft(sections);
}

void add_main_rotor(TriangleSoup& soup) {
  constexpr double kHeight = 0.056;
  const DVec3 up(0, 0, 1);
  append(soup, drum({0.0, 0.0, 0.045}, up, {1, 0, 0}, 0.004, 0.015, 40, 30));
  append(soup, drum({0.0, 0.0, kHeight}, up, {1, 0, 0}, 0.010, 0.003, 64, 24));
  for (int i = 0; i < 4; ++i) {
    const double angle = turn(2 * i + 1, 8);
    const DVec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const DVec3 across = glm::cross(up, outward);
    constexpr double kPitch = 0.12;  // [rad]
    const DVec3 chord = across * std::cos(kPitch) + up * std::sin(kPitch);
    const DVec3 thickness = glm::cross(outward, chord);
    const DVec3 root = outward * 0.006 + up * kHeight;
    const DVec3 tip = outward * 0.145 + up * (kHeight - 0.004);
    append(soup, blade({root, tip, 0.0055 * chord, 0.0009 * thickness, 0.85}, 40, 80));
  }
}

void add_tail(TriangleSoup& soup) {
  append(soup, blade({{-0.178, 0, 0.010}, {-0.196, 0, 0.062}, {0.015, 0, 0}, {0, 0.0018, 0}, 0.55}, 48, 40));
  append(soup, blade({{-0.150, -0.036, 0.019}, {-0.150, 0.036, 0.019}, {0, 0, 0.0014}, {0.009, 0, 0}, 1.0},
                     48, 40));
  const DVec3 hub(-0.188, 0.006, 0.040);
  append(soup, drum(hub, {0, 1, 0}, {1, 0, 0}, 0.003, 0.005, 36, 9));
  for (const double sense : {1.0, -1.0}) {
    const DVec3 outward = sense * glm::normalize(DVec3(0.5, 0, 1));
    const DVec3 chord = glm::cross(DVec3(0, 1, 0), outward);
    const DVec3 thickness = glm::cross(outward, chord);
    const DVec3 middle = hub + DVec3(0, 0.003, 0);
    append(soup, blade({middle + 0.001 * outward, middle + 0.026 * outward, 0.0028 * chord,
                        0.0006 * thickness, 0.8},
                       24, 30));
  }
}

// A runner whose front curls up.
std::vector<DVec3> skid_path(double y, int points) {
  std::vector<DVec3> path;
  for (int i = 0; i < points; ++i) {
    const double along = static_cast<double>(i) / (points - 1);
    const double curl = std::max(0.0, along - 0.8) / 0.2;
    path.emplace_back(-0.055 + 0.14 * along - 0.006 * curl * curl, y, -0.056 + 0.016 * curl * curl);
  }
  return path;
}

// An arch from runner to runner through the belly.
std::vector<DVec3> arch_path(double x, int points) {
  std::vector<DVec3> path;
  for (int i = 0; i < points; ++i) {
    const double across = 2.0 * i / (points - 1) - 1.0;
    path.emplace_back(x, 0.036 * across, -0.018 - 0.038 * across * across);
  }
  return path;
}

void add_landing_gear(TriangleSoup& soup) {
  for (const double y : {-0.036, 0.036}) append(soup, bar(skid_path(y, 80), {0, 1, 0}, 0.0022, 24));
  for (const double x : {-0.025, 0.035}) append(soup, bar(arch_path(x, 30), {1, 0, 0}, 0.0018, 24));
}

}  // namespace

TriangleSoup helicopter() {
  TriangleSoup soup;
  append(soup, body(kFuselage, 160, 140, 2.4));
  append(soup, body(kTailBoom, 64, 100, 2.0));
  append(soup, body(kCowling, 64, 20, 2.5));
  add_main_rotor(soup);
  add_tail(soup);
  add_landing_gear(soup);
  translate(soup, {0.05, 0.0, 0.0});
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes
