// What the smooth law's force must be whatever the shapes: that of the springs where a minimum is by itself,
// and the same for both sides, in any frame, at any size and in any order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "assets/shapes/box.h"
#include "assets/shapes/gear.h"
#include "assets/shapes/organic.h"
#include "engine/contact/smooth_law.h"
#include "engine/scene/query.h"
#include "engine/scene/scene.h"
#include "tests/force/shapes.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kPoses = 5;
#else
constexpr int kPoses = 40;
#endif

using ModelPtr = std::shared_ptr<const Model>;

// Two shapes that meet at random near poses with a spring of 1 N/m.
struct Pair {
  const char* name;
  TriangleSoup a;
  TriangleSoup b;
  double cutoff;
};

std::vector<Pair> pairs() {
  return {
      {"boxes", shapes::box({1, 0.8, 0.6}), shapes::box({0.5, 0.4, 0.3}, {2, 3, 1}), 0.1},
      {"gears", shapes::gear(12), scaled(shapes::gear(12), 0.8), 0.003},
      {"bumpy", shapes::organic({40, 36, 28}), scaled(shapes::organic(shapes::kOrganicCoarse), 0.5), 0.01}};
}

Random seeded(std::uint64_t seed) {
  std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  return Random(seed);
}

Wrench wrench_on_b(const Model& a, const Model& b, const Pose& a_from_b, double cutoff,
                   ForceLaw law = ForceLaw::kSmooth, const DVec3& reference = DVec3(0.0)) {
  Query query;
  QueryOptions options;
  options.law = {1.0, cutoff};
  options.force_law = law;
  options.reference_point = reference;
  query.run(a, b, a_from_b, options);
  return query.contacts().wrench;
}

Wrench turned(const Wrench& wrench, const DMat3& rotation, double sign = 1.0) {
  return {sign * (rotation * wrench.force), sign * (rotation * wrench.torque)};
}

// In terms of what one spring can push, and of that at the tool's radius.
double difference(const Wrench& one, const Wrench& other, double cutoff, double radius) {
  return std::max(glm::length(one.force - other.force) / cutoff,
                  glm::length(one.torque - other.torque) / (cutoff * radius));
}

Pose random_motion(Random& random, double reach) {
  return {random.rotation(), random.uniform(0.0, reach) * random.direction()};
}

// Largest differences of a pair, and what was pushed, so that no comparison is of nothing.
class Comparison {
 public:
  Comparison(const Pair& pair, const Model& b) : pair_(pair), radius_(b.radius()) {}
  ~Comparison() {
    std::printf("%-6s largest difference %.2e of k·c, largest force %.3f\n", pair_.name, largest_, pushed_);
  }
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  void add(const Wrench& one, const Wrench& other) {
    largest_ = std::max(largest_, difference(one, other, pair_.cutoff, radius_));
    pushed_ = std::max(pushed_, glm::length(one.force) / pair_.cutoff);
  }
  double largest() const { return largest_; }
  double pushed() const { return pushed_; }

 private:
  const Pair& pair_;
  double radius_;
  double largest_ = 0.0;
  double pushed_ = 0.0;
};

void expect_same(const Comparison& comparison, double tolerance) {
  EXPECT_LE(comparison.largest(), tolerance);
  EXPECT_GT(comparison.pushed(), 0.1);
}

// A tip over a face, over an edge and over a tip, and edges that cross: away from all ends, at any distance
// and in any frame.
TEST(SmoothLawProperty, AMinimumByItselfIsASpring) {
  constexpr double kCutoff = 0.1;
  Random random = seeded(41);
  const ModelPtr tip = make_model(shapes::stylus(2.0, 0.5)), plate = make_model(shapes::box({4, 4, 1}));
  const ModelPtr ridge = make_model(shapes::ridge(4.0, 2.0, 1.0));
  const DMat3 over = glm::mat3_cast(glm::angleAxis(M_PI, DVec3(1, 0, 0)));
  for (int i = 0; i < 10 * kPoses; ++i) {
    const double distance = random.uniform(0.05, 0.95) * kCutoff, aside = random.uniform(-0.5, 0.5);
    const double angle = random.uniform(0.5, 2.5);
    const DMat3 tilt = glm::mat3_cast(glm::angleAxis(0.1, random.direction()));
    const DMat3 crossing = glm::mat3_cast(glm::angleAxis(angle, DVec3(0, 0, 1)));
    const struct {
      const Model& a;
      const Model& b;
      Pose a_from_b;
    } cases[] = {{*plate, *tip, {tilt, {aside, 0.3, 0.5 + distance}}},
                 {*ridge, *tip, {tilt, {aside, 0.0, distance}}},
                 {*ridge, *ridge, {crossing * over, {aside, 0.0, distance}}},
                 {*tip, *tip, {over * tilt, {0.0, 0.0, -distance}}}};
    for (const auto& [a, b, a_from_b] : cases) {
      const Wrench springs = wrench_on_b(a, b, a_from_b, kCutoff, ForceLaw::kSprings);
      const Wrench smooth = wrench_on_b(a, b, a_from_b, kCutoff);
      EXPECT_NEAR(glm::length(springs.force), kCutoff - distance, 1e-6 * kCutoff) << i;
      EXPECT_LE(difference(springs, smooth, kCutoff, b.radius()), 1e-12) << i;
    }
  }
}

TEST(SmoothLawProperty, BothSidesFeelTheSame) {
  Random random = seeded(42);
  for (const Pair& pair : pairs()) {
    const ModelPtr a = make_model(pair.a), b = make_model(pair.b);
    Comparison comparison(pair, *b);
    for (int i = 0; i < kPoses; ++i) {
      const Pose a_from_b = place_near(*a, *b, 0.4 * pair.cutoff, random);
      const Wrench on_a =
          wrench_on_b(*b, *a, inverse(a_from_b), pair.cutoff, ForceLaw::kSmooth, a_from_b.translation);
      comparison.add(wrench_on_b(*a, *b, a_from_b, pair.cutoff), turned(on_a, a_from_b.rotation, -1.0));
    }
    expect_same(comparison, 1e-9);
  }
}

TEST(SmoothLawProperty, TurnsAlongWithBothModels) {
  Random random = seeded(43);
  for (const Pair& pair : pairs()) {
    const ModelPtr a = make_model(pair.a), b = make_model(pair.b);
    Comparison comparison(pair, *b);
    for (int i = 0; i < kPoses; ++i) {
      const Pose a_from_b = place_near(*a, *b, 0.4 * pair.cutoff, random);
      const Pose world_from_a = random_motion(random, 10.0 * a->radius());
      Scene scene({.cutoff = pair.cutoff, .stiffness = 1.0});
      scene.add({.model = a, .pose = world_from_a});
      scene.add({.kind = BodyKind::kTool, .model = b, .pose = world_from_a * a_from_b});
      scene.step();
      comparison.add(turned(wrench_on_b(*a, *b, a_from_b, pair.cutoff), world_from_a.rotation),
                     scene.contacts().wrench);
    }
    expect_same(comparison, 1e-9);
  }
}

// A power of two scales exactly; with another factor corners are rounded otherwise.
TEST(SmoothLawProperty, ScalesWithEverything) {
  Random random = seeded(44);
  for (const Pair& pair : pairs()) {
    const ModelPtr a = make_model(pair.a), b = make_model(pair.b);
    for (const double scale : {0x1p-10, 0x1p8, 37.0}) {
      const bool exact = scale != 37.0;
      const ModelPtr large_a = make_model(scaled(pair.a, scale)), large_b = make_model(scaled(pair.b, scale));
      Comparison comparison(pair, *b);
      for (int i = 0; i < kPoses; ++i) {
        const Pose a_from_b = place_near(*a, *b, 0.4 * pair.cutoff, random);
        const Pose large{a_from_b.rotation, scale * a_from_b.translation};
        const Wrench wrench = wrench_on_b(*large_a, *large_b, large, scale * pair.cutoff);
        comparison.add(wrench_on_b(*a, *b, a_from_b, pair.cutoff),
                       {wrench.force / scale, wrench.torque / (scale * scale)});
      }
      expect_same(comparison, exact ? 1e-12 : 1e-3);
    }
  }
}

// The same triangles in another order, each beginning at another corner, with their vertices renamed.
TriangleSoup shuffled(const TriangleSoup& soup, Random& random) {
  TriangleSoup other = soup;
  std::vector<std::uint32_t> name(soup.positions.size());
  for (std::uint32_t i = 0; i < name.size(); ++i) name[i] = i;
  for (std::size_t i = name.size(); i > 1; --i) std::swap(name[i - 1], name[random.below(i)]);
  for (std::size_t i = 0; i < name.size(); ++i) other.positions[name[i]] = soup.positions[i];
  for (TriangleIndices& triangle : other.triangles) {
    for (std::uint32_t& corner : triangle) corner = name[corner];
    std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
  }
  for (std::size_t i = other.triangles.size(); i > 1; --i)
    std::swap(other.triangles[i - 1], other.triangles[random.below(i)]);
  return other;
}

TEST(SmoothLawProperty, DoesNotDependOnTheOrderOfTriangles) {
  Random random = seeded(45);
  for (const Pair& pair : pairs()) {
    const ModelPtr a = make_model(pair.a), b = make_model(pair.b);
    const ModelPtr other_a = make_model(shuffled(pair.a, random));
    const ModelPtr other_b = make_model(shuffled(pair.b, random));
    Comparison comparison(pair, *b);
    for (int i = 0; i < kPoses; ++i) {
      const Pose a_from_b = place_near(*a, *b, 0.4 * pair.cutoff, random);
      comparison.add(wrench_on_b(*a, *b, a_from_b, pair.cutoff),
                     wrench_on_b(*other_a, *other_b, a_from_b, pair.cutoff));
    }
    expect_same(comparison, 1e-9);
  }
}

TEST(SmoothLawProperty, SharesDoNotDependOnTheOrderOfContacts) {
  Random random = seeded(46);
  SmoothLaw one, other;
  for (int i = 0; i < 50 * kPoses; ++i) {
    std::vector<NearContact> contacts;
    const DVec3 axis = random.direction();
    for (std::uint32_t k = 0, count = 1 + random.below(30); k < count; ++k) {
      const DVec3 point = random.uniform(0.0, 2.0) * random.direction();
      const DVec3 direction = glm::normalize(axis + 0.2 * random.direction());
      const double distance = random.uniform(0.01, 1.0);
      contacts.push_back(
          {point, point + distance * direction, direction, distance, random.uniform(0.0, 1.0)});
    }
    const std::span<const double> shares = one.share(contacts, 1.0);
    std::reverse(contacts.begin(), contacts.end());
    const std::span<const double> reversed = other.share(contacts, 1.0);
    for (std::size_t k = 0; k < contacts.size(); ++k)
      EXPECT_NEAR(shares[k], reversed[contacts.size() - 1 - k], 1e-14) << i;
  }
}

}  // namespace
}  // namespace palpate
