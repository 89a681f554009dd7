// A few cases of every family, judged in 113 bits; run.sh runs as many as there is time for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string>

#include "assets/shapes/platonic.h"
#include "tests/stress/report.h"
#include "tests/stress/shapes.h"
#include "tests/support/models.h"

namespace palpate::stress {

void PrintTo(const Family& family, std::ostream* out) {
  *out << family.name;
}

namespace {

constexpr std::uint64_t kSeed = 2004;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kCases = 1;
#else
constexpr int kCases = 4;
#endif

int cases_of(const Family& family) {
  return std::string(family.name) == "valence 1,000" ? 1 : kCases;  // of seconds each
}

void expect_sound(const FamilyReport& report) {
  for (const std::string& wrong : report.wrong) ADD_FAILURE() << wrong;
  const SearchOutcome& search = report.search;
  for (const Verdict* verdict : {&search.global, &search.certified, &search.descent}) {
    EXPECT_EQ(verdict->missed, 0);
    EXPECT_EQ(verdict->spurious, 0);
    EXPECT_EQ(verdict->wrong_overlap, 0);
    EXPECT_EQ(verdict->not_numbers, 0);
    for (double error : verdict->errors) EXPECT_LE(error, kLargestError);
  }
  EXPECT_EQ(search.endless, 0);
  EXPECT_EQ(report.triangles.palpate.wrong, 0);
  EXPECT_EQ(report.triangles.palpate.false_contacts, 0);
  EXPECT_EQ(report.triangles.palpate.false_gaps, 0);
  EXPECT_EQ(report.triangles.unsafe_bounds, 0);
  EXPECT_EQ(report.force.unsteady, 0);
  EXPECT_EQ(report.force.wild, 0);
  EXPECT_EQ(report.force.not_numbers, 0);
  EXPECT_LE(report.force.largest_jump, kLargestJump);
}

class Stress : public testing::TestWithParam<Family> {};

TEST_P(Stress, FindsWhatTheDefinitionSays) {
  FamilyReport report;
  for (int number = 0; number < cases_of(GetParam()); ++number) run_case(GetParam(), kSeed, number, report);
  std::printf("seed %llu, %d cases: %d minima, %d undecided, %d sets of the searches judged\n",
              static_cast<unsigned long long>(kSeed), report.search.cases, report.search.global.certain,
              report.search.global.undecided, static_cast<int>(report.search.global.errors.size()));
  expect_sound(report);
}

INSTANTIATE_TEST_SUITE_P(Families, Stress, testing::ValuesIn(families().begin(), families().end()),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

// Cases of longer runs that were wrong once.
struct KnownCase {
  const char* family;
  std::uint64_t seed;
  int number;
};

void PrintTo(const KnownCase& known, std::ostream* out) {
  *out << known.family << ", seed " << known.seed << " case " << known.number;
}

class KnownStress : public testing::TestWithParam<KnownCase> {};

TEST_P(KnownStress, IsSound) {
  const auto family = std::find_if(families().begin(), families().end(), [](const Family& one) {
    return std::string(one.name) == GetParam().family;
  });
  ASSERT_NE(family, families().end());
  FamilyReport report;
  run_case(*family, GetParam().seed, GetParam().number, report);
  expect_sound(report);
}

// A cell of which one end alone is there, beside the corner that ends it.
INSTANTIATE_TEST_SUITE_P(EndsOfPlateaus, KnownStress,
                         testing::Values(KnownCase{"parallel edges", 1, 1372},
                                         KnownCase{"parallel edges", 1, 2131},
                                         KnownCase{"parallel edges", 1, 16060}));

// An edge over another at a distance that rounding of corners, but not of directions, is large beside.
INSTANTIATE_TEST_SUITE_P(NearlyTouching, KnownStress, testing::Values(KnownCase{"nearly flat", 1, 1463}));

// A crossing or a foot 10⁻¹² from the end of its edge.
INSTANTIATE_TEST_SUITE_P(BesideEnds, KnownStress,
                         testing::Values(KnownCase{"open surfaces", 100, 764},
                                         KnownCase{"open surfaces", 100, 11810},
                                         KnownCase{"open surfaces", 100, 14085}));

// A near minimum goes over from one piece of a patch or line to the next, or past the end of a line.
INSTANTIATE_TEST_SUITE_P(HandOvers, KnownStress,
                         testing::Values(KnownCase{"coplanar, collinear", 1, 2119},
                                         KnownCase{"nearly flat", 1, 1086}, KnownCase{"slivers", 1, 7427}));

// A corner that passes the end of a row of slivers: beyond their sharp corners their sides' lines are near.
TEST(NearMinima, OfSliversLieOnTheirModel) {
  constexpr double kCutoff = 0.05, kSlack = 1e-4;
  const auto row = make_model(sliver_row(3e-7, 7)), corner = make_model(shapes::tetrahedron(2e-3));
  const Box box = row->bounds();
  const DVec3 own_tip = corner->mesh().frame.metres(corner->mesh().position(0)), up(0, 1, 0);
  const DVec3 axis = glm::normalize(glm::cross(own_tip, up));
  const DMat3 upright =
      glm::mat3_cast(glm::angleAxis(std::acos(glm::dot(glm::normalize(own_tip), up)), axis));
  Random random(kSeed);
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = kCutoff;
  options.near_minima = true;
  std::size_t count = 0;
  for (int i = 0; i < 400; ++i) {
    // The corner's tip points at the row's end, a little below it.
    const DVec3 tip(random.uniform(-1e-5, 1e-5), -random.uniform(0.005, 0.04), random.uniform(-0.52, -0.5));
    const DMat3 turn = glm::mat3_cast(glm::angleAxis(random.uniform(0.0, 0.5), random.direction()));
    const DMat3 rotation = turn * upright;
    search.run(*row, *corner, {rotation, tip - rotation * own_tip}, options, found);
    for (const Lmd& near : found.near_minima) {
      const DVec3 outside = glm::max(near.point_a - box.high, box.low - near.point_a);
      EXPECT_LT(std::max({outside.x, outside.y, outside.z}), kSlack) << "seed " << kSeed << " pose " << i;
      ++count;
    }
  }
  EXPECT_GT(count, 100u);
}

}  // namespace
}  // namespace palpate::stress
