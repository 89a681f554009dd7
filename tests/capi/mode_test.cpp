// The three ways to find LMDs: the certified one gives the same bits as the search from scratch, at any
// moment.
#include <vector>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr int kSteps = 400;

// A box that wobbles around a ring.
plp_pose wobble(int step) {
  const double angle = 0.01 * step, tilt = 0.3 * std::sin(0.05 * step);
  return {{1.7 * std::cos(angle), 1.7 * std::sin(angle), 0.1 * std::sin(0.03 * step)},
          {std::sin(0.5 * tilt), 0.0, 0.2 * std::sin(0.5 * angle), std::cos(0.5 * tilt)}};
}

class ModeTest : public testing::Test {
 protected:
  struct Stage {
    explicit Stage(const ModeTest& test, plp_mode mode) : scene(options_with(mode)) {
      scene.add(test.ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
      tool = scene.add(test.box_.handle, PLP_BODY_TOOL, wobble(0));
    }
    static plp_scene_options options_with(plp_mode mode) {
      plp_scene_options options = TestScene::options_with(0.3);
      options.mode = mode;
      return options;
    }
    plp_contacts step_to(const plp_pose& pose) {
      EXPECT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      return scene.step();
    }

    TestScene scene;
    plp_body tool = 0;
  };

  TestModel ring_{torus(1.0, 0.25, 48, 24)};
  TestModel box_{box(0.2f, 0.3f, 0.25f)};
};

void expect_equal(const plp_contacts& one, const plp_contacts& other) {
  ASSERT_EQ(one.lmd_count, other.lmd_count);
  EXPECT_EQ(one.set_count, other.set_count);
  EXPECT_EQ(one.overlap, other.overlap);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(one.wrench.force[k], other.wrench.force[k]);
    EXPECT_EQ(one.wrench.torque[k], other.wrench.torque[k]);
  }
}

TEST_F(ModeTest, CertifiedEqualsGlobalBitForBit) {
  Stage global(*this, PLP_MODE_GLOBAL), certified(*this, PLP_MODE_CERTIFIED);
  std::uint64_t entries = 0, expired = 0;
  for (int step = 0; step < kSteps; ++step) {
    const plp_contacts reference = global.step_to(wobble(step));
    const plp_contacts contacts = certified.step_to(wobble(step));
    expect_equal(reference, contacts);
    if (step > 0) {
      entries += contacts.work.front_entries;
      expired += contacts.work.front_expired;
    }
    EXPECT_EQ(contacts.work.global_us, 0.0);
  }
  EXPECT_GT(entries, 0u);
  EXPECT_LT(expired, entries / 2) << "most certificates hold from step to step";
}

TEST_F(ModeTest, DescentFindsNothingThatIsNotThere) {
  Stage global(*this, PLP_MODE_GLOBAL), descent(*this, PLP_MODE_DESCENT);
  std::size_t wanted = 0, found = 0;
  for (int step = 0; step < kSteps; ++step) {
    const plp_contacts reference = global.step_to(wobble(step));
    const plp_contacts contacts = descent.step_to(wobble(step));
    EXPECT_EQ(contacts.work.age, static_cast<std::uint64_t>(step % 10));
    wanted += reference.lmd_count;
    for (std::size_t i = 0; i < contacts.lmd_count; ++i) {
      bool known = false;
      for (std::size_t k = 0; k < reference.lmd_count; ++k)
        known |= std::abs(reference.lmds[k].distance - contacts.lmds[i].distance) < 1e-12;
      EXPECT_TRUE(known) << "step " << step;
      found += known;
    }
  }
  EXPECT_GT(found, wanted * 3 / 4);
}

TEST_F(ModeTest, DescentGoesOnReportingAnOverlap) {
  Stage descent(*this, PLP_MODE_DESCENT);
  bool overlapped = false;
  for (int step = 0; step < 60; ++step) {  // from outside the ring into its tube, sideways
    const plp_contacts contacts = descent.step_to({{1.7 - 0.01 * step, 0.02, 0.03}, {0.1, 0.0, 0.05, 1.0}});
    if (contacts.overlap) overlapped = true;
    if (overlapped) {
      EXPECT_EQ(contacts.overlap, 1) << "step " << step;
    }
  }
  EXPECT_TRUE(overlapped);
}

TEST_F(ModeTest, CanBeSwitchedBetweenSteps) {
  Stage global(*this, PLP_MODE_GLOBAL), switched(*this, PLP_MODE_GLOBAL);
  const plp_mode modes[] = {PLP_MODE_CERTIFIED, PLP_MODE_DESCENT, PLP_MODE_GLOBAL};
  for (int step = 0; step < 90; ++step) {
    const plp_mode mode = modes[step / 7 % 3];
    ASSERT_EQ(plp_scene_set_mode(switched.scene.handle, mode), PLP_OK);
    const plp_contacts reference = global.step_to(wobble(step));
    const plp_contacts contacts = switched.step_to(wobble(step));
    if (mode != PLP_MODE_DESCENT) expect_equal(reference, contacts);
  }
}

TEST_F(ModeTest, OnlyKnownModesAreTaken) {
  Stage stage(*this, PLP_MODE_GLOBAL);
  EXPECT_EQ(plp_scene_set_mode(stage.scene.handle, 3), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_set_mode(stage.scene.handle, -1), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_set_mode(nullptr, PLP_MODE_GLOBAL), PLP_ERROR_INVALID_HANDLE);
}

}  // namespace
}  // namespace palpate::test
