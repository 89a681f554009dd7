#include "tests/stress/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assets/shapes/box.h"
#include "assets/shapes/platonic.h"
#include "assets/shapes/round_solids.h"
#include "assets/shapes/soup_edit.h"
#include "tests/stress/shapes.h"
#include "tests/support/models.h"

namespace palpate::stress {
namespace {

double power(Random& random, double low, double high) {
  return std::pow(10.0, random.uniform(low, high));
}

Pose turn(const DVec3& axis, double angle) {
  return {glm::mat3_cast(glm::angleAxis(angle, glm::normalize(axis))), DVec3(0.0)};
}

DVec3 random_point(Random& random, double half) {
  return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

shapes::Divisions random_divisions(Random& random, std::uint32_t most) {
  return {1 + static_cast<int>(random.below(most)), 1 + static_cast<int>(random.below(most)),
          1 + static_cast<int>(random.below(most))};
}

// Blocks in a corner: convex and reflex edges, and minima on many sides of what comes near.
TriangleSoup corner_block(Random& random) {
  auto soup = shapes::box({1, 1, 0.2}, random_divisions(random, 2));
  const DVec3 places[] = {{0.4, 0, 0.35}, {0, 0.4, 0.35}};
  for (const DVec3& place : places) {
    auto part =
        shapes::box(place.x > 0 ? DVec3(0.2, 0.9, 0.5) : DVec3(0.6, 0.2, 0.4), random_divisions(random, 2));
    for (DVec3& position : part.positions) position += place;
    shapes::append(soup, part);
  }
  return soup;
}

// Above the top of a box of size 1: the lowest point of `b`, turned, is `gap` over it.
Pose above_unit_box(const TriangleSoup& b, const DMat3& rotation, double gap, Random& random) {
  double lowest = 1e300;
  for (const DVec3& position : b.positions) lowest = std::min(lowest, (rotation * position).z);
  return {rotation, {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 0.5 - lowest + gap}};
}

// Somewhere near each other, at any rotation.
Case somewhere(TriangleSoup a, TriangleSoup b, double gap, double cutoff, Random& random) {
  const auto model_a = make_model(a), model_b = make_model(b);
  const Pose pose = place_near(*model_a, *model_b, gap, random);
  return {std::move(a), std::move(b), pose, cutoff};
}

Case parallel_faces(Random& random) {
  const auto a = shapes::box({1, 1, 1}, random_divisions(random, 3));
  const auto b = shapes::box({power(random, -2, 0), power(random, -2, 0), power(random, -1, 0)},
                             random_divisions(random, 3));
  const DMat3 yaw = turn({0, 0, 1}, random.below(2) ? random.uniform(0, 6) : 0.0).rotation;
  const DVec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), 0.0);
  const DMat3 tilt = turn(axis, power(random, -12, -2)).rotation;
  const Pose pose = above_unit_box(b, tilt * yaw, power(random, -9, -2), random);
  return {a, b, pose, 0.02};
}

Case parallel_edges(Random& random) {
  const auto a = prism(1.0, power(random, -2, 0), power(random, -2, 0));
  const auto b = prism(random.uniform(0.3, 1.5), power(random, -2, 0), power(random, -2, 0));
  // Their sharp edges run along x, one up, one down.
  const DMat3 over = turn({1, 0, 0}, std::numbers::pi).rotation;
  const DMat3 yaw = turn({0, 0, 1}, power(random, -12, -2)).rotation;
  const DMat3 pitch = turn({0, 1, 0}, random.below(2) ? power(random, -12, -2) : 0.0).rotation;
  return {a,
          b,
          {pitch * yaw * over,
           {random.uniform(-0.3, 0.3), random.below(2) ? power(random, -9, -3) : 0.0, power(random, -9, -2)}},
          0.02};
}

Case edge_over_face(Random& random) {
  const auto a = shapes::box({1, 1, 1}, random_divisions(random, 3));
  const auto b = prism(random.uniform(0.1, 0.7), power(random, -2, 0), power(random, -2, 0));
  const DMat3 over = turn({1, 0, 0}, std::numbers::pi + random.uniform(-0.2, 0.2)).rotation;
  const DMat3 pitch = turn({0, 1, 0}, power(random, -12, -2)).rotation;
  const DMat3 yaw = turn({0, 0, 1}, random.below(2) ? random.uniform(0, 6) : 0.0).rotation;
  return {a, b, above_unit_box(b, yaw * pitch * over, power(random, -9, -2), random), 0.02};
}

// Boxes on one grid: coplanar faces and collinear edges.
Case coplanar(Random& random) {
  const auto grid = [&random] { return 0.125 * (1 + random.below(8)); };
  const auto a = shapes::box({grid(), grid(), grid()}, random_divisions(random, 2));
  auto b = shapes::box({grid(), grid(), grid()}, random_divisions(random, 2));
  if (random.below(2)) {
    auto other = shapes::box({grid(), grid(), grid()}, random_divisions(random, 2));
    for (DVec3& position : other.positions) position.x += 1.0;
    shapes::append(b, other);
  }
  DVec3 shift;
  for (int axis = 0; axis < 3; ++axis) shift[axis] = 0.0625 * random.below(32) - 1.0;
  DMat3 rotation(1.0);
  if (random.below(2)) rotation = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  return {a, b, {rotation, shift}, 0.4};
}

Case slivers(Random& random) {
  const auto b = random.below(2) ? fin(1.0, power(random, -8, 0)) : shapes::tetrahedron(0.3);
  return somewhere(fin(power(random, -1, 0), power(random, -8, 0)), b, power(random, -9, -2),
                   power(random, -2, 0.3), random);
}

Case needles(Random& random) {
  const auto b = random.below(2) ? needle(1.0, power(random, -8, -1)) : shapes::icosphere(0.3, 1);
  return somewhere(needle(1.0, power(random, -8, -1)), b, power(random, -9, -2), power(random, -2, 0.3),
                   random);
}

// A pyramid over a finely cut strip of slivers.
Case sliver_rows(Random& random) {
  return somewhere(sliver_row(power(random, -7, -1), 3 + static_cast<int>(random.below(6))),
                   shapes::tetrahedron(power(random, -3, 0)), power(random, -9, -2), power(random, -2, 0.3),
                   random);
}

Case zero_area(Random& random) {
  auto a = corner_block(random);
  add_zero_area(a, random);
  auto b = shapes::icosphere(0.3, 1);
  add_zero_area(b, random);
  return somewhere(a, b, power(random, -9, -2), power(random, -2, 0.3), random);
}

Case duplicated(Random& random) {
  auto a = corner_block(random);
  add_duplicates(a, random);
  auto b = shapes::icosphere(0.3, 1);
  add_duplicates(b, random);
  return somewhere(a, b, power(random, -9, -2), power(random, -2, 0.3), random);
}

Case t_junctions(Random& random) {
  auto a = corner_block(random);
  add_t_junctions(a, random);
  auto b = shapes::tetrahedron(0.4);
  add_t_junctions(b, random);
  return somewhere(a, b, power(random, -9, -2), power(random, -2, 0.3), random);
}

// Solids that meet themselves in a vertex or along an edge.
Case shared_vertices(Random& random) {
  const auto pair_of = [&random] {
    auto soup = shapes::box({0.5, 0.5, 0.5});
    auto other = shapes::box({0.5, 0.5, 0.5}, random_divisions(random, 2));
    const double along = random.below(2) ? 0.5 : 0.0;
    for (DVec3& position : other.positions) position += DVec3(0.5, 0.5, along);
    shapes::append(soup, other);
    return soup;
  };
  return somewhere(pair_of(), pair_of(), power(random, -9, -2), power(random, -2, 0.3), random);
}

// A corner of each on the line of the other, apart by as little as nothing.
Case touching(Random& random) {
  const auto a =
      random.below(2) ? shapes::box({1, 1, 1}, random_divisions(random, 2)) : shapes::icosphere(0.7, 1);
  const auto b = random.below(2) ? shapes::tetrahedron(0.3) : shapes::icosphere(0.3, 2);
  const DVec3 on_a = a.positions[random.below(a.positions.size())],
              on_b = b.positions[random.below(b.positions.size())];
  const DVec3 out = glm::normalize(on_a + random_point(random, 0.3)), back = glm::normalize(on_b);
  // The rotation that takes `back` to −out, and any turn about it.
  const DVec3 across = glm::normalize(glm::cross(back, -out) + 1e-9 * random.direction());
  const double angle = std::acos(std::clamp(-glm::dot(back, out), -1.0, 1.0));
  const DMat3 rotation = turn(out, random.uniform(0, 6)).rotation * turn(across, angle).rotation;
  const double gap = random.below(4) ? power(random, -16, -6) : 0.0;
  return {a, b, {rotation, on_a - rotation * on_b + out * gap}, 0.05};
}

Case interlocked(Random& random) {
  const auto a = shapes::torus(1.0, 0.3, 10, 5), b = shapes::torus(1.0, 0.3, 9, 5);
  const DMat3 upright = turn({1, 0, 0}, std::numbers::pi / 2 + random.uniform(-0.3, 0.3)).rotation;
  return {a, b, {upright, DVec3(1.0, 0, 0) + random_point(random, 0.2)}, 0.3};
}

Case valence(Random& random) {
  const int count = static_cast<int>(power(random, std::log10(3.0), 2.5));
  const double height = random.below(2) ? power(random, -6, 0) : -power(random, -6, -0.4);
  return somewhere(spike(count, height), shapes::tetrahedron(power(random, -2, 0)), power(random, -9, -2),
                   power(random, -2, 0), random);
}

Case valence_of_thousand(Random& random) {
  const double height = random.below(2) ? power(random, -6, 0) : -power(random, -6, -0.4);
  const auto a = spike(1000, height), b = shapes::tetrahedron(power(random, -2, 0));
  const DMat3 rotation = random.rotation();
  return {a, b, {rotation, DVec3(0, 0, height + power(random, -9, -2)) - rotation * b.positions[0]}, 0.05};
}

Case plain(Random& random) {
  return somewhere(corner_block(random), shapes::box({0.3, 0.5, 0.7}, random_divisions(random, 3)),
                   power(random, -6, -1.5), power(random, -1.5, 0), random);
}

Case scales(Random& random) {
  Case c = plain(random);
  const double scale = power(random, -6, 6);
  for (TriangleSoup* soup : {&c.a, &c.b})
    for (DVec3& position : soup->positions) position *= scale;
  c.a_from_b.translation *= scale;
  c.cutoff *= scale;
  c.step *= scale;
  return c;
}

Case unequal_scales(Random& random) {
  const double scale = power(random, -6, 0);
  auto a = shapes::box({1, 1, 1}, random_divisions(random, 3));
  auto b = scaled(shapes::icosphere(0.5, 1), scale);
  const Pose pose = above_unit_box(b, random.rotation(), scale * power(random, -6, -1), random);
  Case c{a, b, pose, scale * 0.3, 1e-3 * scale};
  if (random.below(2)) return c;
  return {b, a, inverse(pose), c.cutoff, c.step};
}

Case offsets(Random& random) {
  Case c = plain(random);
  const auto moved = [&random](TriangleSoup& soup) {
    // On the float32 grid, which at a million is 1/16: whatever is left is the model.
    DVec3 by = random_point(random, power(random, 0, 6));
    for (int axis = 0; axis < 3; ++axis) by[axis] = std::round(by[axis] * 1024) / 1024;
    for (DVec3& position : soup.positions) {
      for (int axis = 0; axis < 3; ++axis) position[axis] = std::round(position[axis] * 0x1p23) / 0x1p23;
      position += by;
    }
    return by;
  };
  const DVec3 by_a = random.below(2) ? moved(c.a) : DVec3(0.0),
              by_b = random.below(2) ? moved(c.b) : DVec3(0.0);
  c.a_from_b.translation += by_a - c.a_from_b.rotation * by_b;
  return c;
}

Case small_cutoffs(Random& random) {
  const double cutoff = power(random, -6, -2);
  return somewhere(shapes::icosphere(0.5, 2), shapes::box({0.3, 0.5, 0.7}, random_divisions(random, 3)),
                   cutoff * power(random, -3, 0), cutoff, random);
}

Case large_cutoffs(Random& random) {
  return somewhere(shapes::icosphere(0.5, 1), shapes::box({0.3, 0.5, 0.7}), power(random, -3, 1),
                   power(random, -1, 3), random);
}

// A pose, and before it some that differ from it by a few units in the last place.
Case few_ulps(Random& random) {
  Case c = random.below(2) ? parallel_faces(random) : plain(random);
  c.step = power(random, -17, -14);
  return c;
}

// Small motions composed a million times: a full turn, normalised once at the end.
Case composed(Random& random) {
  constexpr int kTimes = 1'000'000;
  Case c = plain(random);
  const DQuat small = glm::angleAxis(2 * std::numbers::pi / kTimes, random.direction());
  DQuat rotation = glm::quat_cast(c.a_from_b.rotation);
  for (int i = 0; i < kTimes; ++i) rotation = small * rotation;
  c.a_from_b = pose_from(c.a_from_b.translation, rotation);
  return c;
}

Case fast(Random& random) {
  Case c = plain(random);
  c.step = power(random, 0, 3);
  return c;
}

// Faces that are flat but for the noise of their coordinates.
Case nearly_flat(Random& random) {
  auto a = shapes::box({1, 1, 1}, {2 + static_cast<int>(random.below(3)), 3, 1});
  auto b = shapes::box({0.4, 0.3, 0.2}, {2, 2, 1});
  add_noise(a, power(random, -8, -3), random);
  add_noise(b, power(random, -8, -3), random);
  const DMat3 rotation = turn({0, 0, 1}, random.uniform(0, 6)).rotation;
  const DMat3 tilt = turn(random.direction(), power(random, -9, -2)).rotation;
  return {a, b, above_unit_box(b, tilt * rotation, power(random, -7, -2), random), 0.02};
}

Case open_surfaces(Random& random) {
  auto a = strip_of_triangles(3, random), b = strip_of_triangles(3, random);
  return somewhere(a, b, power(random, -9, -2), 0.2, random);
}

constexpr auto kFamilies = std::to_array<Family>({
    {"plain", plain},
    {"parallel faces", parallel_faces},
    {"parallel edges", parallel_edges},
    {"edge along a face", edge_over_face},
    {"coplanar, collinear", coplanar},
    {"nearly flat", nearly_flat},
    {"slivers", slivers},
    {"rows of slivers", sliver_rows},
    {"needles", needles},
    {"zero area", zero_area},
    {"duplicated", duplicated},
    {"T-junctions", t_junctions},
    {"shared vertices", shared_vertices},
    {"open surfaces", open_surfaces},
    {"touching", touching},
    {"interlocked", interlocked},
    {"valence 3 to 300", valence},
    {"valence 1,000", valence_of_thousand},
    {"scales 1e-6 to 1e6", scales},
    {"unequal scales", unequal_scales},
    {"offsets to 1e6", offsets},
    {"cutoffs from 1e-6", small_cutoffs},
    {"cutoffs to 1e3", large_cutoffs},
    {"a few ulps apart", few_ulps},
    {"composed 1e6 times", composed},
    {"fast motions", fast},
});

}  // namespace

std::span<const Family> families() {
  return kFamilies;
}

}  // namespace palpate::stress
