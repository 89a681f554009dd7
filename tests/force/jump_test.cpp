// No jump of the smooth law's force is left at any scale: the largest steps of random motions are halved
// until nothing but a jump would remain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "tests/force/wrench_along.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 7;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kMotions = 1;
#else
constexpr int kMotions = 8;
#endif

constexpr int kSteps = 100;
constexpr std::size_t kHalved = 8;  // of the largest steps of a motion

struct Case {
  const char* a;
  const char* b;
  double b_scale;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.a << " - " << c.b;
}

double largest_jump(const Model& a, const Model& b, const Motion& motion, double cutoff, ForceLaw law) {
  const std::vector<Wrench> wrenches = wrenches_along(a, b, motion, kSteps, cutoff, law);
  std::vector<std::size_t> steps(kSteps);
  std::iota(steps.begin(), steps.end(), std::size_t{0});
  const auto change = [&](std::size_t i) {
    return largest_step({wrenches.begin() + static_cast<std::ptrdiff_t>(i),
                         wrenches.begin() + static_cast<std::ptrdiff_t>(i) + 2},
                        1);
  };
  std::sort(steps.begin(), steps.end(),
            [&](std::size_t one, std::size_t other) { return change(one) > change(other); });
  double most = 0.0;
  for (std::size_t i = 0; i < kHalved; ++i) {
    const double from = static_cast<double>(steps[i]) / kSteps;
    most = std::max(most, jump_between(a, b, motion, from, from + 1.0 / kSteps, cutoff, law));
  }
  return most;
}

class Jump : public testing::TestWithParam<Case> {};

TEST_P(Jump, IsNoneLeft) {
  const Case& c = GetParam();
  const auto a = asset_model(c.a), b = asset_model(c.b, c.b_scale);
  const double cutoff = 0.02 * a->bounds().diagonal();
  Random random(kSeed);
  double springs = 0.0, smooth = 0.0;
  for (int i = 0; i < kMotions; ++i) {
    const Motion motion = drift(*a, *b, cutoff, cutoff, random);
    springs = std::max(springs, largest_jump(*a, *b, motion, cutoff, ForceLaw::kSprings));
    const double jump = largest_jump(*a, *b, motion, cutoff, ForceLaw::kSmooth);
    if (jump > 1e-4) std::printf("motion %d: %.5f\n", i, jump);
    smooth = std::max(smooth, jump);
  }
  std::printf("%s - %s, seed %llu: largest jump of springs %.4f, of smooth %.2e of k·c\n", c.a, c.b,
              static_cast<unsigned long long>(kSeed), springs, smooth);
  EXPECT_LT(smooth, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Assets, Jump,
    testing::Values(Case{"gear_6k", "gear_6k", 0.5}, Case{"teapot_5600", "icosphere", 0.3},
                    Case{"organic_2200", "torus", 0.5}, Case{"voxels", "l_bracket", 0.5},
                    Case{"saddle", "fan_200", 0.5}, Case{"box", "tetrahedron", 1.0},
                    Case{"spring_23k", "box", 0.5}, Case{"crankshaft_45k", "cylinder", 0.5},
                    Case{"slivers", "box", 0.3}, Case{"nested_cavities", "box", 0.3},
                    Case{"two_sided_sheet", "cylinder", 0.5}, Case{"open_sheet", "l_bracket", 0.5},
                    Case{"mobius_strip", "tetrahedron", 0.5}, Case{"voxels_nonmanifold", "flush_boxes", 0.3},
                    Case{"plate", "box_tessellated", 0.5}));

}  // namespace
}  // namespace palpate
