// A tool pressed into a body: the hand feels a wall and not a kick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "assets/shapes/box.h"
#include "assets/shapes/platonic.h"
#include "assets/shapes/soup_edit.h"
#include "tests/force/pressed_scene.h"
#include "tests/support/allocation_count.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

constexpr double kCutoff = PressedScene::kCutoff, kStiffness = PressedScene::kStiffness;
constexpr double kStep = 1e-4;  // metres: 0.1 m/s
constexpr SearchMode kModes[] = {SearchMode::kGlobal, SearchMode::kDescent, SearchMode::kCertified};

std::shared_ptr<const Model> box_model(const DVec3& size) {
  return make_model(shapes::box(size));
}

Pose raised(double height, const DMat3& rotation = DMat3(1.0)) {
  return {rotation, {0.003, 0.005, height}};
}

DMat3 on_a_corner() {
  return glm::mat3_cast(glm::normalize(DQuat(0.35, 0.2, 0.1, 0.9)));
}

double lowest_corner(const DMat3& rotation, double half) {
  return -half * (std::abs(rotation[0].z) + std::abs(rotation[1].z) + std::abs(rotation[2].z));
}

// A plate whose upper face is z = 0, thick enough that the tool does not come out below, and a box.
const auto& plate() {
  static const auto model = [] {
    TriangleSoup soup = shapes::box({0.4, 0.4, 0.1});
    shapes::translate(soup, {0.0, 0.0, -0.05});
    return make_model(soup);
  }();
  return model;
}

const auto& small_box() {
  static const auto model = box_model({0.04, 0.04, 0.04});
  return model;
}

struct Press {
  SearchMode mode;
  bool on_corner;
};

class WallInAPlate : public testing::TestWithParam<Press> {
 protected:
  Pose at_depth(double depth) const {
    const DMat3 rotation = GetParam().on_corner ? on_a_corner() : DMat3(1.0);
    return raised(-depth - lowest_corner(rotation, 0.02), rotation);
  }
};

// Down to 0.8 of the cutoff below the surface and back: the force is k (cutoff + depth) all the way.
TEST_P(WallInAPlate, PushesByTheDepthAllTheWayInAndOut) {
  PressedScene pressed(plate(), small_box(), at_depth(-0.02), PressedScene::options_with(GetParam().mode));
  int walled = 0;
  const auto force_at = [&](double depth) {
    const Contacts& contacts = pressed.step_to(at_depth(depth));
    EXPECT_EQ(contacts.walled(), contacts.overlap) << "at depth " << depth;
    walled += contacts.walled();
    EXPECT_NEAR(contacts.wrench.force.x, 0.0, 1e-9);
    EXPECT_NEAR(contacts.wrench.force.y, 0.0, 1e-9);
    return contacts.wrench.force.z;
  };
  std::vector<double> depths;
  for (int i = 0; i <= 280; ++i) depths.push_back(-0.02 + 1.0003 * kStep * i);
  for (int i = 280; i >= 0; --i) depths.push_back(-0.02 + 1.0003 * kStep * i);
  for (const double depth : depths)
    EXPECT_NEAR(force_at(depth), kStiffness * std::max(0.0, kCutoff + depth), 1e-6) << "at depth " << depth;
  EXPECT_GT(walled, 150);
}

TEST_P(WallInAPlate, IsBounded) {
  PressedScene pressed(plate(), small_box(), at_depth(-0.02), PressedScene::options_with(GetParam().mode));
  double most = 0.0;
  for (double depth = -0.02; depth < 0.03; depth += kStep) {
    const double force = pressed.step_to(at_depth(depth)).wrench.force.z;
    EXPECT_GE(force, most - 1e-9) << "pressing deeper never pushes less";
    most = std::max(most, force);
  }
  EXPECT_NEAR(most, 2.0 * kStiffness * kCutoff, 1e-9);
}

TEST_P(WallInAPlate, IsDroppedWhenTheToolIsPutElsewhere) {
  PressedScene pressed(plate(), small_box(), at_depth(-0.001), PressedScene::options_with(GetParam().mode));
  for (double depth = -0.001; depth < 0.004; depth += kStep) pressed.step_to(at_depth(depth));
  EXPECT_TRUE(pressed.scene().contacts().walled());
  Pose beside = at_depth(-0.005);
  beside.translation.x += 0.1;
  const Contacts& away = pressed.step_to(beside);
  EXPECT_FALSE(away.walled());
  EXPECT_EQ(away.springs.size(), away.lmds.size());
  EXPECT_NEAR(away.wrench.force.z, kStiffness * 0.005, 1e-6);
  beside.translation.z -= 0.02;  // straight into the plate
  const Contacts& inside = pressed.step_to(beside);
  EXPECT_TRUE(inside.overlap);
  EXPECT_FALSE(inside.walled());
  EXPECT_EQ(inside.wrench.force, DVec3(0.0));
}

TEST_P(WallInAPlate, IsNoneWherePairsOverlapFromTheFirstStepOn) {
  PressedScene pressed(plate(), small_box(), at_depth(0.004), PressedScene::options_with(GetParam().mode));
  for (int i = 0; i < 20; ++i) {
    const Contacts& contacts = pressed.step_to(at_depth(0.004 - 1e-4 * i));
    EXPECT_TRUE(contacts.overlap);
    EXPECT_FALSE(contacts.walled());
    EXPECT_EQ(contacts.wrench.force, DVec3(0.0));
  }
}

// A hand that taps by a tenth of a millimetre across the surface: never more than motion explains.
TEST_P(WallInAPlate, TappingDoesNotKick) {
  PressedScene pressed(plate(), small_box(), at_depth(-0.001), PressedScene::options_with(GetParam().mode));
  double before = pressed.step_to(at_depth(-0.001)).wrench.force.z, depth_before = -0.001;
  for (int i = 0; i < 600; ++i) {
    const double depth = -0.0002 + 0.0004 * std::sin(0.37 * i) - 0.0006 * std::exp(-0.05 * i);
    const double force = pressed.step_to(at_depth(depth)).wrench.force.z;
    EXPECT_LE(std::abs(force - before), kStiffness * std::abs(depth - depth_before) + 1e-6) << "step " << i;
    before = force;
    depth_before = depth;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, WallInAPlate,
                         testing::Values(Press{SearchMode::kGlobal, false}, Press{SearchMode::kGlobal, true},
                                         Press{SearchMode::kDescent, false},
                                         Press{SearchMode::kDescent, true},
                                         Press{SearchMode::kCertified, false},
                                         Press{SearchMode::kCertified, true}));

// Floor z = 0 and wall x = 0 of two models or of one; the tool goes into both.
class WallInAWedge : public testing::TestWithParam<SearchMode> {};

TEST_P(WallInAWedge, HoldsBothWays) {
  TriangleSoup floor = shapes::box({0.4, 0.4, 0.1}), wall = shapes::box({0.1, 0.4, 0.4});
  shapes::translate(floor, {0.2, 0.0, -0.05});
  shapes::translate(wall, {-0.05, 0.0, 0.1});
  shapes::append(floor, wall);
  const DMat3 rotation = on_a_corner();
  const double reach_z = lowest_corner(rotation, 0.02);
  const double reach_x =
      -0.02 * (std::abs(rotation[0].x) + std::abs(rotation[1].x) + std::abs(rotation[2].x));
  const auto at_depths = [&](double x, double z) {
    return Pose{rotation, {-x - reach_x, 0.0, -z - reach_z}};
  };
  PressedScene pressed(make_model(floor), small_box(), at_depths(-0.008, -0.008),
                       PressedScene::options_with(GetParam()));
  const auto expect_held = [&](double x, double z) {
    const Contacts& contacts = pressed.step_to(at_depths(x, z));
    EXPECT_NEAR(contacts.wrench.force.x, kStiffness * (kCutoff + x), 1e-5) << x << ' ' << z;
    EXPECT_NEAR(contacts.wrench.force.z, kStiffness * (kCutoff + z), 1e-5) << x << ' ' << z;
    const bool inside = x >= 0 || z >= 0;
    // Descent learns of the end of an overlap by its next search.
    if (inside || GetParam() != SearchMode::kDescent) {
      EXPECT_EQ(contacts.walled(), inside);
    }
  };
  for (int i = 0; i < 130; ++i) expect_held(-0.008 + 0.97e-4 * i, -0.0079 + 1.01e-4 * i);  // into both
  const double x = -0.008 + 0.97e-4 * 129, z = -0.0079 + 1.01e-4 * 129;
  for (int i = 0; i < 130; ++i) expect_held(x - 1.01e-4 * i, z);  // out of the wall while in the floor
  for (int i = 0; i < 130; ++i) expect_held(x - 1.01e-4 * 129, z - 0.99e-4 * i);
}

INSTANTIATE_TEST_SUITE_P(Modes, WallInAWedge, testing::ValuesIn(kModes));

// Right through a sheet that is thinner than the cutoff: what was a wall fades behind it.
TEST(WallInASheet, EndsBehindIt) {
  for (const SearchMode mode : kModes) {
    const DMat3 rotation = on_a_corner();
    const auto at_depth = [&](double depth) {
      return raised(-depth - lowest_corner(rotation, 0.02), rotation);
    };
    PressedScene pressed(box_model({0.4, 0.4, 0.004}), small_box(), at_depth(-0.014),
                         PressedScene::options_with(mode));
    double before = 0.0, most = 0.0;
    for (double depth = -0.014; depth < 0.1; depth += kStep) {
      const double force = pressed.step_to(at_depth(depth)).wrench.force.z;
      EXPECT_LE(std::abs(force - before), kStiffness * (kStep + 2.0 * 2.0 * kCutoff * 0.05) + 1e-6)
          << "motion, and a twentieth of what fades and of what comes, at depth " << depth;
      before = force;
      most = std::max(most, force);
    }
    EXPECT_NEAR(most, 2.0 * kStiffness * kCutoff, 1e-6);
    EXPECT_FALSE(pressed.scene().contacts().walled());
    EXPECT_EQ(pressed.scene().contacts().wrench.force, DVec3(0.0));
  }
}

// Two bars across each other: edge on edge.
class WallOnAnEdge : public testing::TestWithParam<SearchMode> {};

TEST_P(WallOnAnEdge, PushesByTheDepthAndReturns) {
  const double diagonal = std::sqrt(0.5);
  const DMat3 ridge = glm::mat3_cast(DQuat(std::cos(M_PI / 8), std::sin(M_PI / 8), 0.0, 0.0));   // along x
  const DMat3 across = glm::mat3_cast(DQuat(std::cos(M_PI / 8), 0.0, std::sin(M_PI / 8), 0.0));  // along y
  TriangleSoup bar = shapes::box({0.3, 0.04, 0.04});
  for (DVec3& position : bar.positions) position = ridge * position;
  const auto at_depth = [&](double depth) {
    return Pose{across, {0.003, 0.007, 2 * 0.04 * diagonal - depth}};
  };
  PressedScene pressed(make_model(bar), box_model({0.04, 0.3, 0.04}), at_depth(-0.012),
                       PressedScene::options_with(GetParam()));
  int walled = 0;
  for (int i = 0; i <= 360; ++i) {
    const double depth = -0.012 + 1.0003 * kStep * std::min(i, 360 - i);
    const Contacts& contacts = pressed.step_to(at_depth(depth));
    EXPECT_NEAR(contacts.wrench.force.z, kStiffness * std::max(0.0, kCutoff + depth), 1e-5)
        << "depth " << depth;
    walled += contacts.walled();
  }
  EXPECT_GT(walled, 100);
}

INSTANTIATE_TEST_SUITE_P(Modes, WallOnAnEdge, testing::ValuesIn(kModes));

// Energy that a hand gets back from going in, along and out: the wall of a plane is a spring, and damping and
// friction only take.
TEST(WallAndEnergy, AClosedCycleGivesNothing) {
  const DMat3 rotation = on_a_corner();
  for (const bool lossy : {false, true}) {
    SceneOptions options = PressedScene::options_with(SearchMode::kCertified);
    options.damping = lossy ? 2.0 : 0.0;
    options.friction = lossy ? 0.3 : 0.0;
    const auto at_phase = [&](int i) {
      const double angle = 2.0 * M_PI * i / 1000.0;
      Pose pose = raised(0.002 + 0.006 * std::cos(angle) - lowest_corner(rotation, 0.02), rotation);
      pose.translation.x += 0.02 * std::sin(angle);
      return pose;
    };
    PressedScene pressed(plate(), small_box(), at_phase(0), options);
    double energy = 0.0;
    DVec3 force_before = pressed.step_to(at_phase(0)).wrench.force;
    int walled = 0;
    for (int i = 1; i <= 3000; ++i) {
      const Contacts& contacts = pressed.step_to(at_phase(i));
      const DVec3 moved = at_phase(i).translation - at_phase(i - 1).translation;
      energy += 0.5 * glm::dot(contacts.wrench.force + force_before, moved);
      force_before = contacts.wrench.force;
      walled += contacts.walled();
    }
    std::printf("energy of three cycles into a plate and along: %.2e J%s\n", energy,
                lossy ? " with damping and friction" : "");
    EXPECT_GT(walled, 500);
    if (lossy) {
      EXPECT_LT(energy, -1e-3);
    } else {
      EXPECT_NEAR(energy, 0.0, 1e-9);
    }
  }
}

// A ball in a hollow one, whose inside is concave.
TEST(WallInABowl, HasNoKickAtTheSurface) {
  TriangleSoup bowl = shapes::icosphere(0.1, 8), inside = shapes::icosphere(0.08, 8);
  shapes::turn_inside_out(inside);
  shapes::append(bowl, inside);
  const auto hollow = make_model(bowl), ball = make_model(shapes::icosphere(0.03, 6));
  const DMat3 rotation = on_a_corner();
  const DVec3 down = glm::normalize(DVec3(0.21, 0.13, -1.0));
  const auto reaching = [&](double way) { return Pose{rotation, way * down}; };
  std::vector<DVec3> reference;
  for (const SearchMode mode : {SearchMode::kGlobal, SearchMode::kGlobal, SearchMode::kCertified}) {
    std::vector<DVec3> forces;
    PressedScene pressed(hollow, ball, reaching(0.038), PressedScene::options_with(mode));
    DVec3 before = pressed.step_to(reaching(0.038)).wrench.force;
    double worst = 0.0, most = 0.0;
    int walled = 0;
    // Slower and slower towards the turn; deep enough that many facets have crossed.
    for (int i = 0; i <= 400; ++i) {
      const double way = 0.038 + 0.016 * std::sin(M_PI * i / 400.0);
      const Contacts& contacts = pressed.step_to(reaching(way));
      if (contacts.walled()) {
        worst = std::max(worst, glm::length(contacts.wrench.force - before));
        most = std::max(most, glm::length(contacts.wrench.force));
        EXPECT_GT(glm::dot(contacts.wrench.force, -down), 0.0) << "it pushes out";
      }
      walled += contacts.walled();
      before = contacts.wrench.force;
      forces.push_back(before);
    }
    std::printf("bowl: walled %d steps, up to %.2f N, largest step %.3f N for %.3f N of motion\n", walled,
                most, worst, kStiffness * 0.016 * M_PI / 400.0);
    EXPECT_GT(walled, 50);
    if (reference.empty()) reference = forces;
    EXPECT_EQ(forces, reference) << "to the bit, again and in either mode";
    EXPECT_LT(worst, 2.0 * kStiffness * 0.016 * M_PI / 400.0);
  }
}

// Whatever mode a step has, the wall stays.
TEST(WallAndModes, SwitchingKeepsTheWall) {
  const DMat3 rotation = on_a_corner();
  const auto at_depth = [&](double depth) {
    return raised(-depth - lowest_corner(rotation, 0.02), rotation);
  };
  PressedScene pressed(plate(), small_box(), at_depth(-0.005));
  for (int i = 0; i < 200; ++i) {
    pressed.scene().set_mode(kModes[i / 7 % 3]);
    const double depth = -0.005 + 1.0e-4 * std::min(i, 200 - i);
    EXPECT_NEAR(pressed.step_to(at_depth(depth)).wrench.force.z, kStiffness * (kCutoff + depth), 1e-6)
        << "step " << i;
  }
}

TEST(WallAndFriction, SlidingInsideIsHeldBackAndTakesEnergy) {
  SceneOptions options = PressedScene::options_with(SearchMode::kCertified);
  options.friction = 0.3;
  const DMat3 rotation = on_a_corner();
  const auto at_depth = [&](double depth, double x) {
    Pose pose = raised(-depth - lowest_corner(rotation, 0.02), rotation);
    pose.translation.x += x;
    return pose;
  };
  PressedScene pressed(plate(), small_box(), at_depth(-0.001, 0.0), options);
  for (int i = 0; i < 40; ++i) pressed.step_to(at_depth(-0.001 + 1e-4 * i, 0.0));
  for (int i = 1; i < 40; ++i) {
    const Contacts& contacts = pressed.step_to(at_depth(0.0029, 1e-3 * i));
    EXPECT_NEAR(contacts.wrench.force.z, kStiffness * (kCutoff + 0.0029), 1e-6);
    EXPECT_NEAR(contacts.wrench.force.x, -0.3 * contacts.wrench.force.z, 1e-6);
  }
}

TEST(WallAndMemory, GoingInAgainAllocatesNothing) {
  const DMat3 rotation = on_a_corner();
  PressedScene pressed(plate(), small_box(), raised(0.05, rotation));
  std::uint64_t during_last = 0;
  for (int round = 0; round < 3; ++round) {
    const std::uint64_t before = test::allocation_count();
    for (int i = 0; i < 400; ++i) {
      const double depth = -0.005 + 1.0e-4 * std::min(i, 400 - i) * 0.5;
      pressed.step_to(raised(-depth - lowest_corner(rotation, 0.02), rotation));
    }
    during_last = test::allocation_count() - before;
  }
  EXPECT_EQ(during_last, 0u);
}

}  // namespace
}  // namespace palpate
