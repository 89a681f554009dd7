// A certified step with a budget: what it costs, what it still promises, and that nothing is lost.
#include <algorithm>
#include <vector>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr std::uint32_t kBudget = 400;

// A ring in a ring, turning and swaying; `pace` is how far a step goes.
plp_pose sway(double way) {
  const double tilt = 0.4 * std::sin(3.0 * way);
  return {{1.25 * std::cos(way), 1.25 * std::sin(way), 0.3 + 0.15 * std::sin(7.0 * way)},
          {std::sin(0.5 * tilt), 0.1, std::sin(0.5 * way), std::cos(0.5 * tilt)}};
}

class BudgetTest : public testing::Test {
 protected:
  struct Stage {
    Stage(const BudgetTest& test, plp_mode mode, std::uint32_t budget) : scene(options_of(mode, budget)) {
      scene.add(test.ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
      tool = scene.add(test.tool_.handle, PLP_BODY_TOOL, sway(0));
    }
    static plp_scene_options options_of(plp_mode mode, std::uint32_t budget) {
      plp_scene_options options = TestScene::options_with(0.3);
      options.mode = mode;
      options.tick_budget = budget;
      return options;
    }
    plp_contacts step_to(const plp_pose& pose) {
      EXPECT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      return scene.step();
    }

    TestScene scene;
    plp_body tool = 0;
  };

  TestModel ring_{torus(1.0, 0.25, 60, 30)};
  TestModel tool_{torus(0.3, 0.1, 24, 12)};
};

bool has(const plp_contacts& contacts, const plp_lmd& lmd) {
  const auto same = [&](const plp_lmd& other) {
    double apart = 0.0;
    for (int k = 0; k < 3; ++k)
      apart += std::abs(lmd.point_a[k] - other.point_a[k]) + std::abs(lmd.point_b[k] - other.point_b[k]);
    return apart < 1e-9;
  };
  return std::any_of(contacts.lmds, contacts.lmds + contacts.lmd_count, same);
}

bool by_descent(const plp_contacts& contacts) {
  return (contacts.status & PLP_STATUS_BY_DESCENT) != 0;
}

void expect_same_set(const plp_contacts& one, const plp_contacts& other) {
  ASSERT_EQ(one.lmd_count, other.lmd_count);
  for (std::size_t i = 0; i < one.lmd_count; ++i) {
    EXPECT_TRUE(has(other, one.lmds[i]));
    EXPECT_TRUE(has(one, other.lmds[i]));
  }
  if (one.spring_count > one.lmd_count) return;  // a wall that ended just now still fades
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(one.wrench.force[k], other.wrench.force[k]);
    EXPECT_EQ(one.wrench.torque[k], other.wrench.torque[k]);
  }
}

TEST_F(BudgetTest, IsKeptAndFlaggedAndAllThatIsFoundIsThere) {
  Stage global(*this, PLP_MODE_GLOBAL, 0), hurried(*this, PLP_MODE_CERTIFIED, kBudget);
  std::size_t flagged = 0, wanted = 0, found = 0;
  for (int step = 0; step < 200; ++step) {
    const plp_contacts reference = global.step_to(sway(0.02 * step));
    const plp_contacts contacts = hurried.step_to(sway(0.02 * step));
    // What descent measured is beyond the budget: it costs what the LMDs cost.
    EXPECT_LE(contacts.work.node_pairs, kBudget);
    flagged += by_descent(contacts);
    if (!by_descent(contacts)) expect_same_set(contacts, reference);
    for (std::size_t i = 0; i < contacts.lmd_count; ++i)
      EXPECT_TRUE(has(reference, contacts.lmds[i])) << "step " << step;
    wanted += reference.lmd_count;
    found += contacts.lmd_count;
  }
  std::printf("%zu of 200 steps by descent; %zu of %zu LMDs found\n", flagged, found, wanted);
  EXPECT_GT(flagged, 100u);
  EXPECT_GT(found, wanted / 2);
}

TEST_F(BudgetTest, SetIsCompleteAgainOnceTheMotionIsSlow) {
  Stage global(*this, PLP_MODE_GLOBAL, 0), hurried(*this, PLP_MODE_CERTIFIED, kBudget);
  double way = 0.0;
  for (int step = 0; step < 50; ++step) hurried.step_to(sway(way += 0.02));
  ASSERT_TRUE(by_descent(hurried.step_to(sway(way += 0.02))));
  int late = 0;
  while (by_descent(hurried.step_to(sway(way += 1e-6))) && late < 1000) ++late;
  ASSERT_LT(late, 1000);
  int complete = 0;
  for (int step = 0; step < 100; ++step) {
    const plp_contacts reference = global.step_to(sway(way += 1e-6));
    const plp_contacts contacts = hurried.step_to(sway(way));
    if (by_descent(contacts)) continue;
    ++complete;
    expect_same_set(contacts, reference);
  }
  std::printf("complete after %d slow steps, then in %d of 100\n", late, complete);
  EXPECT_GT(complete, 75);
}

TEST_F(BudgetTest, IsCompletedWhereNothingMovesAndThenSearchesNoMore) {
  Stage global(*this, PLP_MODE_GLOBAL, 0), hurried(*this, PLP_MODE_CERTIFIED, kBudget);
  const plp_contacts reference = global.step_to(sway(0.7));
  plp_contacts contacts = hurried.step_to(sway(0.7));
  EXPECT_TRUE(by_descent(contacts));
  int steps = 0;
  for (; by_descent(contacts) && steps < 1000; ++steps) contacts = hurried.scene.step();
  EXPECT_LT(steps, 1000);
  expect_same_set(contacts, reference);
  contacts = hurried.scene.step();
  EXPECT_EQ(contacts.work.node_pairs, 0u);
  EXPECT_EQ(contacts.work.triangle_pairs, 0u);
  EXPECT_FALSE(by_descent(contacts));
}

TEST_F(BudgetTest, OverlapsAreNotLost) {
  Stage hurried(*this, PLP_MODE_CERTIFIED, kBudget);
  const plp_pose inside{{1.0, 0.0, 0.2}, {0.1, 0.0, 0.05, 1.0}};
  plp_contacts contacts = hurried.step_to(inside);
  for (int steps = 0; by_descent(contacts) && steps < 1000; ++steps) contacts = hurried.scene.step();
  ASSERT_EQ(contacts.overlap, 1);
  std::size_t flagged = 0;
  for (int step = 0; step < 50; ++step) {
    contacts =
        hurried.step_to({{1.0 + 0.002 * step, 0.004 * step, 0.2}, {0.1, 0.0, 0.05 + 0.01 * step, 1.0}});
    flagged += by_descent(contacts);
    EXPECT_EQ(contacts.overlap, 1) << "step " << step;
  }
  EXPECT_GT(flagged, 0u);
}

TEST_F(BudgetTest, LargeEnoughIsNeverExceeded) {
  Stage global(*this, PLP_MODE_GLOBAL, 0), easy(*this, PLP_MODE_CERTIFIED, 10'000'000);
  for (int step = 0; step < 100; ++step) {
    const plp_contacts reference = global.step_to(sway(0.02 * step));
    const plp_contacts contacts = easy.step_to(sway(0.02 * step));
    EXPECT_FALSE(by_descent(contacts));
    expect_same_set(contacts, reference);
  }
}

}  // namespace
}  // namespace palpate::test
