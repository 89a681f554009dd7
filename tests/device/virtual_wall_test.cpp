#include "tests/device/virtual_wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace palpate {
namespace {

struct WallCase {
  const PhantomSpec& (*spec)();
  int delay;
  const char* name;
};

class VirtualWallTest : public testing::TestWithParam<WallCase> {
 protected:
  static VirtualWall wall(double stiffness) {
    return {GetParam().spec(), impedance_of(Grip::kLight), 1e-3, GetParam().delay, stiffness};
  }
};

TEST_P(VirtualWallTest, ComesToRestBelowTheBoundAndShakesFarAbove) {
  const double bound = damping_bound(wall(0.0));
  EXPECT_LT(residual_speed(wall(0.5 * bound), 1.0), 1e-3);
  EXPECT_GT(residual_speed(wall(20.0 * bound), 1.0), 1e-2);
}

TEST_P(VirtualWallTest, IsStableUpToAboutItsTheoreticalBound) {
  const double measured = largest_stable_stiffness(wall(0.0));
  const double damping = damping_bound(wall(0.0)), friction = friction_bound(wall(0.0));
  std::printf("%-14s largest stable stiffness %6.0f N/m; damping bound %6.0f, friction bound %6.0f\n",
              GetParam().name, measured, damping, friction);
  // Passivity is sufficient, not necessary, and friction helps on top: never much below, a few times above.
  EXPECT_GE(measured, std::min(damping, friction));
  EXPECT_LE(measured, 3.0 * damping);
}

INSTANTIATE_TEST_SUITE_P(Phantoms, VirtualWallTest,
                         testing::Values(WallCase{premium6dof_spec, 0, "Premium"},
                                         WallCase{premium6dof_spec, 1, "PremiumDelayed"},
                                         WallCase{touch_spec, 0, "Touch"},
                                         WallCase{touch_spec, 1, "TouchDelayed"}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace palpate
