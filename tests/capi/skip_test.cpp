// What a scene does not need costs nothing, by its own counters.
#include <vector>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr int kSteps = 60;

plp_pose slide(int step) {
  return {{1.0 - 0.0005 * step, 0.004 * step, 0.05}, {0.0, 0.1, 0.001 * step, 1.0}};
}

std::uint64_t tree_bytes(const TestModel& model) {
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  EXPECT_EQ(plp_model_get_info(model.handle, &info), PLP_OK);
  return info.tree_bytes;
}

class SkipTest : public testing::TestWithParam<plp_mode> {
 protected:
  static plp_scene_options options() {
    plp_scene_options options = TestScene::options_with(0.2);
    options.mode = GetParam();
    return options;
  }

  // The work of a motion past the near body, summed.
  plp_work slide_through(TestScene& scene) {
    scene.add(near_.handle, PLP_BODY_STATIC, at(0, 0, 0));
    const plp_body tool = scene.add(tool_.handle, PLP_BODY_TOOL, slide(0));
    plp_work sum{};
    for (int step = 0; step < kSteps; ++step) {
      const plp_pose pose = slide(step);
      EXPECT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      const plp_work work = scene.step().work;
      sum.bodies += work.bodies;
      sum.body_pairs += work.body_pairs;
      sum.node_pairs += work.node_pairs;
      sum.triangle_pairs += work.triangle_pairs;
      sum.descents += work.descents;
      sum.descent_steps += work.descent_steps;
      sum.front_entries += work.front_entries;
      sum.front_expired += work.front_expired;
      sum.rebuilds += work.rebuilds;
    }
    return sum;
  }

  TestModel near_{torus(0.5, 0.2, 32, 16)};
  TestModel far_{torus(0.5, 0.2, 32, 16)};
  TestModel tool_{box(0.2f, 0.3f, 0.25f)};
};

TEST_P(SkipTest, AThousandBodiesWithOneNearCostWhatTheOneCosts) {
  TestScene crowd(options()), alone(options());
  for (int i = 0; i < 999; ++i)
    crowd.add(far_.handle, i % 2 ? PLP_BODY_MOVING : PLP_BODY_STATIC,
              at(10.0 + 2 * (i % 10), 2 * (i / 10), 3));
  const plp_work in_crowd = slide_through(crowd), by_itself = slide_through(alone);
  EXPECT_EQ(in_crowd.bodies, 1000u * kSteps) << "beside the tool";
  EXPECT_EQ(in_crowd.body_pairs, by_itself.body_pairs);
  EXPECT_EQ(in_crowd.node_pairs, by_itself.node_pairs);
  EXPECT_EQ(in_crowd.triangle_pairs, by_itself.triangle_pairs);
  EXPECT_EQ(in_crowd.descents, by_itself.descents);
  EXPECT_EQ(in_crowd.descent_steps, by_itself.descent_steps);
  EXPECT_EQ(in_crowd.front_entries, by_itself.front_entries);
  EXPECT_EQ(in_crowd.front_expired, by_itself.front_expired);
  EXPECT_EQ(in_crowd.rebuilds, by_itself.rebuilds);
  EXPECT_GT(by_itself.triangle_pairs, 0u);
  EXPECT_EQ(by_itself.rebuilds > 0, GetParam() == PLP_MODE_CERTIFIED);
  EXPECT_EQ(tree_bytes(far_), 0u) << "nothing came near";
  EXPECT_GT(tree_bytes(near_), 0u);
}

TEST_P(SkipTest, AnUnmovedSceneDoesNoSearchAtAll) {
  TestScene scene(options());
  slide_through(scene);
  for (int step = 0; step < 30; ++step) {
    const plp_contacts contacts = scene.step();
    EXPECT_GT(contacts.lmd_count, 0u);
    EXPECT_EQ(contacts.work.body_pairs, 0u);
    EXPECT_EQ(contacts.work.node_pairs, 0u);
    EXPECT_EQ(contacts.work.triangle_pairs, 0u);
    EXPECT_EQ(contacts.work.descents, 0u);
    EXPECT_EQ(contacts.work.rebuilds, 0u);
  }
}

TEST_P(SkipTest, OnlyThePairThatMovedIsSearched) {
  TestScene scene(options());
  const plp_body moved = scene.add(near_.handle, PLP_BODY_MOVING, at(0, 0, 0));
  scene.add(near_.handle, PLP_BODY_STATIC, at(2.1, 0, 0));
  scene.add(tool_.handle, PLP_BODY_TOOL, at(1.05, 0, 0));
  EXPECT_EQ(scene.step().work.body_pairs, 2u);
  const plp_pose aside = at(0.001, 0, 0);
  EXPECT_EQ(plp_scene_set_pose(scene.handle, moved, &aside), PLP_OK);
  EXPECT_EQ(scene.step().work.body_pairs, 1u);
}

INSTANTIATE_TEST_SUITE_P(Modes, SkipTest,
                         testing::Values(PLP_MODE_GLOBAL, PLP_MODE_DESCENT, PLP_MODE_CERTIFIED));

}  // namespace
}  // namespace palpate::test
