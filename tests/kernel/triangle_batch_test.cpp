// Wide distances of triangles: as exact as promised on whatever is hard, and the same bits everywhere.
#include "engine/kernel/triangle_batch.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/kernel/exact_pair.h"
#include "tests/kernel/hard_pairs.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 977;
constexpr std::size_t kMost = TriangleBatch::kMost;

// One measured pair, in the frame of its triangles.
struct Measured {
  double distance;
  double least;
  DVec3 on_first;
  DVec3 on_second;
  TrianglePlace first_place;
  TrianglePlace second_place;
};

// What rounding is measured by: the largest coordinate about the pair's origin.
double size_of(const HardPair& pair, const DVec3& origin) {
  double size = 0.0;
  for (const Triangle* triangle : {&pair.first, &pair.second})
    for (const DVec3& corner : triangle->corner)
      for (int axis = 0; axis < 3; ++axis) size = std::max(size, std::abs(corner[axis] - origin[axis]));
  return size;
}

Measured measured_at(const TriangleBatch::Closest& closest, std::size_t i, const DVec3& origin) {
  const auto point = [&](const TriangleBatch::Row<float>(&rows)[3]) {
    return origin + DVec3(rows[0][i], rows[1][i], rows[2][i]);
  };
  const auto place = [&](std::int32_t code) { return TrianglePlace{static_cast<std::uint8_t>(code)}; };
  return {std::sqrt(static_cast<double>(closest.squared_distance[i])),
          closest.least_distance[i],
          point(closest.on_first),
          point(closest.on_second),
          place(closest.first_place[i]),
          place(closest.second_place[i])};
}

// All pairs, `count` at a time.
std::vector<Measured> measure(const std::vector<HardPair>& pairs, std::size_t count = kMost) {
  std::vector<Measured> all;
  TriangleBatch batch{};
  TriangleBatch::Closest closest;
  for (std::size_t first = 0; first < pairs.size(); first += count) {
    const std::size_t here = std::min(count, pairs.size() - first);
    for (std::size_t i = 0; i < here; ++i) {
      const HardPair& pair = pairs[first + i];
      batch.first.set(i, pair.first, pair.first.corner[0]);
      batch.second.set(i, pair.second, pair.first.corner[0]);
    }
    batch.measure(here, closest);
    for (std::size_t i = 0; i < here; ++i)
      all.push_back(measured_at(closest, i, pairs[first + i].first.corner[0]));
  }
  return all;
}

// How far `point` is from the place that it is said to be on.
double off_place(const DVec3& point, const Triangle& triangle, TrianglePlace place) {
  const exact::Real3 at = exact::real(point);
  if (place.is_corner()) return glm::length(point - triangle.corner[place.code]);
  if (!place.is_side()) return static_cast<double>(exact::distance_to_triangle(at, triangle));
  const int side = place.side();
  return static_cast<double>(
      exact::distance_to_segment(at, exact::real(triangle.start(side)), exact::real(triangle.end(side))));
}

// Errors relative to the size of the pair.
struct Errors {
  double distance = 0.0;
  double place = 0.0;
  double points = 0.0;  // their distance
  double twin = 0.0;    // closest_points()
};

Errors larger(const Errors& one, const Errors& other) {
  return {std::max(one.distance, other.distance), std::max(one.place, other.place),
          std::max(one.points, other.points), std::max(one.twin, other.twin)};
}

Errors errors_of(const HardPair& pair, const Measured& measured, double truth) {
  const double size = size_of(pair, pair.first.corner[0]);
  const double twin = std::sqrt(closest_points(pair.first, pair.second).squared_distance);
  return {std::abs(measured.distance - truth) / size,
          std::max(off_place(measured.on_first, pair.first, measured.first_place),
                   off_place(measured.on_second, pair.second, measured.second_place)) /
              size,
          std::abs(glm::length(measured.on_second - measured.on_first) - truth) / size,
          std::abs(twin - truth) / size_of(pair, DVec3(0.0))};
}

// Planes between the triangles prove a distance, as far as rounding leaves the direction of its points, which
// is the square root of what it leaves of the distance. Where they do not, nothing
// separates the triangles.
bool is_proven(const exact::Distance& distance, double size) {
  return distance.value > 0 &&
         distance.value - distance.gap <= 1e-9L * size * std::sqrt(size / distance.value);
}

class TriangleBatchTest : public testing::Test {
 protected:
  ~TriangleBatchTest() override { hwy::SetSupportedTargetsForTest(0); }
};

Errors worst_errors(const std::vector<HardPair>& pairs, std::size_t& proven) {
  const std::vector<Measured> measured = measure(pairs);
  Errors worst;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const exact::Distance truth = exact::distance(pairs[i].first, pairs[i].second);
    const double size = size_of(pairs[i], pairs[i].first.corner[0]);
    if (!is_proven(truth, size)) {
      EXPECT_LE(truth.gap, 1e-9 * size) << i;
      continue;
    }
    ++proven;
    EXPECT_LE(measured[i].least, static_cast<double>(truth.value)) << i;
    worst = larger(worst, errors_of(pairs[i], measured[i], static_cast<double>(truth.value)));
  }
  return worst;
}

TEST_F(TriangleBatchTest, IsAsExactAsItPromises) {
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const Difficulty difficulty : kDifficulties) {
      std::size_t proven = 0;
      const Errors worst = worst_errors(hard_pairs(difficulty, scale, 4000, kSeed), proven);
      std::printf(
          "seed %llu, scale %g, %s: %zu pairs; distance off by %.2g, places %.2g, points %.2g, twin %.2g\n",
          static_cast<unsigned long long>(kSeed), scale, name_of(difficulty), proven, worst.distance,
          worst.place, worst.points, worst.twin);
      EXPECT_GT(proven, 1000u);
      EXPECT_LE(worst.distance, TriangleBatch::kRounding);
      EXPECT_LE(worst.place, TriangleBatch::kRounding);
      EXPECT_LE(worst.points, TriangleBatch::kRounding);
      EXPECT_LE(worst.twin, 4e-15);
    }
}

Triangle permuted(const Triangle& triangle, int permutation) {
  Triangle t = triangle;
  std::rotate(t.corner, t.corner + permutation % 3, t.corner + 3);
  if (permutation >= 3) std::swap(t.corner[1], t.corner[2]);
  return t;
}

// Whichever corner comes first, and whichever triangle.
TEST_F(TriangleBatchTest, DoesNotCareForOrder) {
  for (const Difficulty difficulty : kDifficulties) {
    const std::vector<HardPair> pairs = hard_pairs(difficulty, 1.0, 200, kSeed + 1);
    const std::vector<Measured> reference = measure(pairs);
    for (int order = 0; order < 72; ++order) {
      std::vector<HardPair> reordered;
      for (const HardPair& pair : pairs) {
        reordered.push_back({permuted(pair.first, order % 6), permuted(pair.second, order / 6 % 6)});
        if (order >= 36) std::swap(reordered.back().first, reordered.back().second);
      }
      const std::vector<Measured> measured = measure(reordered);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        EXPECT_NEAR(measured[i].distance, reference[i].distance,
                    4 * TriangleBatch::kRounding * size_of(pairs[i], pairs[i].first.corner[0]))
            << name_of(difficulty) << " " << i << ", order " << order;
    }
  }
}

std::vector<HardPair> pairs_of_every_difficulty() {
  std::vector<HardPair> pairs;
  for (const Difficulty difficulty : kDifficulties)
    for (const HardPair& pair : hard_pairs(difficulty, 1.0, 501, kSeed + 2)) pairs.push_back(pair);
  return pairs;
}

bool same_bits(const Measured& one, const Measured& other) {
  return one.distance == other.distance && one.least == other.least && one.on_first == other.on_first &&
         one.on_second == other.on_second && one.first_place == other.first_place &&
         one.second_place == other.second_place;
}

TEST_F(TriangleBatchTest, EveryInstructionSetGivesTheSameBits) {
  const std::vector<HardPair> pairs = pairs_of_every_difficulty();
  const std::vector<Measured> reference = measure(pairs);
  int tested = 0;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    const std::vector<Measured> measured = measure(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      EXPECT_TRUE(same_bits(measured[i], reference[i])) << hwy::TargetName(target) << " " << i;
    std::printf("%s\n", hwy::TargetName(target));
    ++tested;
  }
  EXPECT_GE(tested, 1);
}

TEST_F(TriangleBatchTest, ALaneKnowsNothingOfTheOthers) {
  const std::vector<HardPair> pairs = pairs_of_every_difficulty();
  const std::vector<Measured> reference = measure(pairs);
  for (const std::size_t count : {1, 5, 13}) {
    const std::vector<Measured> measured = measure(pairs, count);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      EXPECT_TRUE(same_bits(measured[i], reference[i])) << i << ", " << count << " at a time";
  }
}

}  // namespace
}  // namespace palpate
