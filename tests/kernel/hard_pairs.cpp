#include "tests/kernel/hard_pairs.h"

#include <cmath>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

DVec3 in_box(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

Triangle triangle_in_box(Random& random) {
  return {{in_box(random), in_box(random), in_box(random)}};
}

void move(Triangle& triangle, const DVec3& by) {
  for (DVec3& corner : triangle.corner) corner += by;
}

double power_of_ten(double low, double high, Random& random) {
  return std::pow(10.0, random.uniform(low, high));
}

// A long side and a corner hardly beside it.
Triangle sliver(Random& random) {
  Triangle t = triangle_in_box(random);
  const DVec3 on_side = t.corner[0] + random.uniform(-0.2, 1.2) * t.along(0);
  t.corner[2] = on_side + power_of_ten(-9, -1, random) * random.direction();
  return t;
}

// The other triangle, a little turned about each of its own points, and lifted.
Triangle nearly_parallel_to(const Triangle& other, Random& random) {
  Triangle t = other;
  const double turn = power_of_ten(-17, -3, random);
  for (DVec3& corner : t.corner) corner += turn * random.direction();
  const DVec3 slide = random.uniform(0, 1.2) * other.along(static_cast<int>(random.below(3)));
  move(t, slide + power_of_ten(-6, 0, random) * glm::normalize(other.area_vector()));
  return t;
}

// Half of a square of a grid, each coordinate off by a few units in the last place.
Triangle on_grid(Random& random) {
  const int up = static_cast<int>(random.below(3)), x = (up + 1) % 3, y = (up + 2) % 3;
  DVec3 base;
  for (int axis = 0; axis < 3; ++axis) base[axis] = 0.25 * random.below(8);
  Triangle t{{base, base, base}};
  t.corner[1][x] += 0.25;
  t.corner[2][y] += 0.25;
  for (DVec3& corner : t.corner)
    for (int axis = 0; axis < 3; ++axis) corner[axis] += 0x1p-52 * (static_cast<int>(random.below(7)) - 3);
  return t;
}

HardPair make(Difficulty difficulty, Random& random) {
  const DVec3 away = random.uniform(0, 3) * random.direction();
  HardPair pair{triangle_in_box(random), triangle_in_box(random)};
  switch (difficulty) {
    case Difficulty::kRandom:
      break;
    case Difficulty::kNearParallel:
      pair.second = nearly_parallel_to(pair.first, random);
      return pair;
    case Difficulty::kSlivers:
      pair = {sliver(random), random.below(2) ? sliver(random) : pair.second};
      break;
    case Difficulty::kAxisAligned:
      return {on_grid(random), on_grid(random)};
    case Difficulty::kSegments:
      pair.first.corner[2] = pair.first.corner[0] + random.uniform(-0.2, 1.2) * pair.first.along(0);
      if (random.below(2)) pair.second.corner[1] = pair.second.corner[random.below(2) * 2];
      break;
    case Difficulty::kPoints:
      pair.first.corner[1] = pair.first.corner[2] = pair.first.corner[0];
      if (random.below(2)) pair.second.corner[1] = pair.second.corner[2] = pair.second.corner[0];
      break;
    case Difficulty::kNear: {
      // From a point of the one to a point of the other it is next to nothing.
      const auto inside = [&](const Triangle& t) {
        const double x = random.uniform(0, 1), y = random.uniform(0, 1 - x);
        return t.corner[0] + x * t.along(0) + y * (t.corner[2] - t.corner[0]);
      };
      const DVec3 together = pair.first.corner[0] - inside(pair.second);
      move(pair.second, together + power_of_ten(-12, -3, random) * random.direction());
      return pair;
    }
    case Difficulty::kFar: {
      const DVec3 far = 1e6 * random.direction();
      move(pair.first, far);
      move(pair.second, far);
      break;
    }
  }
  move(pair.second, away);
  return pair;
}

}  // namespace

const char* name_of(Difficulty difficulty) {
  constexpr const char* kNames[] = {"random",   "near-parallel", "slivers", "axis-aligned",
                                    "segments", "points",        "near",    "far from the origin"};
  return kNames[static_cast<int>(difficulty)];
}

std::vector<HardPair> hard_pairs(Difficulty difficulty, double scale, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<HardPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    HardPair pair = make(difficulty, random);
    for (Triangle* triangle : {&pair.first, &pair.second})
      for (DVec3& corner : triangle->corner) corner *= scale;
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace palpate
