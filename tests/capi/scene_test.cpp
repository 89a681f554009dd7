#include <cstring>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

plp_pose tilted(double x, double angle) {
  return {{x, 0.0, 0.0}, {0.0, 0.0, std::sin(0.5 * angle), std::cos(0.5 * angle)}};
}

class SceneTest : public testing::Test {
 protected:
  void set_pose(plp_body body, const plp_pose& pose) {
    EXPECT_EQ(plp_scene_set_pose(scene_.handle, body, &pose), PLP_OK) << plp_last_error();
  }

  std::uint64_t tree_nodes(const TestModel& model) {
    plp_model_info info;
    plp_model_info_init(&info, sizeof info);
    EXPECT_EQ(plp_model_get_info(model.handle, &info), PLP_OK);
    return info.tree_nodes;
  }

  TestModel box_{box(0.5f, 0.5f, 0.5f)};
  TestScene scene_{0.2};
};

TEST_F(SceneTest, WithoutAToolThereAreNoContacts) {
  scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene_.add(box_.handle, PLP_BODY_MOVING, at(1.1, 0, 0));
  const plp_contacts contacts = scene_.step();
  EXPECT_EQ(contacts.lmd_count, 0u);
  EXPECT_EQ(contacts.work.bodies, 0u);
}

TEST_F(SceneTest, ContactsNameTheirBodiesAndNumberTheirSets) {
  const plp_body left = scene_.add(box_.handle, PLP_BODY_STATIC, at(-1.125, 0, 0));
  const plp_body tool = scene_.add(box_.handle, PLP_BODY_TOOL, at(0, 0, 0));
  const plp_body right = scene_.add(box_.handle, PLP_BODY_STATIC, at(1.0625, 0, 0));
  const plp_contacts contacts = scene_.step();
  ASSERT_EQ(contacts.set_count, 2u);
  EXPECT_EQ(contacts.min_distance, 0.0625);
  for (std::size_t i = 0; i < contacts.lmd_count; ++i) {
    const plp_lmd& lmd = contacts.lmds[i];
    EXPECT_EQ(lmd.body_b, tool);
    EXPECT_EQ(lmd.body_a, lmd.set == 0 ? left : right);
    EXPECT_NEAR(lmd.normal[0], lmd.set == 0 ? 1.0 : -1.0, 1e-12);
  }
  EXPECT_NEAR(contacts.wrench.force[0], 1000.0 * ((0.2 - 0.125) - (0.2 - 0.0625)), 1e-9);
}

TEST_F(SceneTest, StiffnessOfABodyReplacesThatOfTheScene) {
  scene_.add(box_.handle, PLP_BODY_TOOL, at(1.125, 0, 0));
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.model = box_.handle;
  options.stiffness = 300.0;
  plp_body body = 0;
  ASSERT_EQ(plp_scene_add_body(scene_.handle, &options, &body), PLP_OK);
  EXPECT_NEAR(scene_.step().wrench.force[0], 300.0 * 0.075, 1e-9);
  ASSERT_EQ(plp_scene_remove_body(scene_.handle, body), PLP_OK);
  scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  EXPECT_NEAR(scene_.step().wrench.force[0], 1000.0 * 0.075, 1e-9);
  ASSERT_EQ(plp_scene_set_stiffness(scene_.handle, 50.0), PLP_OK);
  EXPECT_NEAR(scene_.step().wrench.force[0], 50.0 * 0.075, 1e-9);
}

TEST_F(SceneTest, PairThatDidNotMoveIsNotSearchedAgain) {
  const plp_body tool = scene_.add(box_.handle, PLP_BODY_TOOL, at(1.125, 0, 0));
  scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_contacts first = scene_.step();
  EXPECT_EQ(first.work.body_pairs, 1u);
  EXPECT_GT(first.work.node_pairs, 0u);
  const std::vector<plp_lmd> lmds(first.lmds, first.lmds + first.lmd_count);

  const plp_contacts second = scene_.step();
  EXPECT_EQ(second.work.bodies, 1u);
  EXPECT_EQ(second.work.body_pairs, 0u);
  EXPECT_EQ(second.work.node_pairs, 0u);
  EXPECT_EQ(second.work.triangle_pairs, 0u);
  ASSERT_EQ(second.lmd_count, lmds.size());
  EXPECT_EQ(std::memcmp(second.lmds, lmds.data(), lmds.size() * sizeof(plp_lmd)), 0);
  EXPECT_EQ(std::memcmp(&second.wrench, &first.wrench, sizeof first.wrench), 0);

  ASSERT_EQ(plp_scene_set_cutoff(scene_.handle, 0.15), PLP_OK);
  EXPECT_EQ(scene_.step().work.body_pairs, 1u) << "another cutoff";
  set_pose(tool, at(1.0625, 0, 0));
  EXPECT_EQ(scene_.step().work.body_pairs, 1u) << "another pose";
  EXPECT_EQ(scene_.step().work.body_pairs, 0u);
}

TEST_F(SceneTest, FarBodiesCostNoTree) {
  const TestModel far(torus(1.0, 0.25, 32, 16));
  const plp_body body = scene_.add(far.handle, PLP_BODY_STATIC, at(50, 0, 0));
  scene_.add(box_.handle, PLP_BODY_TOOL, at(0, 0, 0));
  plp_contacts contacts = scene_.step();
  EXPECT_EQ(contacts.work.bodies, 1u);
  EXPECT_EQ(contacts.work.body_pairs, 0u);
  EXPECT_EQ(tree_nodes(far), 0u);
  EXPECT_EQ(tree_nodes(box_), 0u);
  set_pose(body, at(1.8, 0, 0));
  contacts = scene_.step();
  EXPECT_EQ(contacts.work.body_pairs, 1u);
  EXPECT_GT(tree_nodes(far), 0u);
}

TEST_F(SceneTest, BodyThatLeavesAndReturnsIsSearchedAgain) {
  const plp_body tool = scene_.add(box_.handle, PLP_BODY_TOOL, at(1.125, 0, 0));
  scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene_.step();
  set_pose(tool, at(9, 0, 0));
  EXPECT_EQ(scene_.step().set_count, 0u);
  set_pose(tool, at(1.125, 0, 0));
  const plp_contacts contacts = scene_.step();
  EXPECT_EQ(contacts.work.body_pairs, 1u);
  EXPECT_EQ(contacts.set_count, 1u);
}

TEST_F(SceneTest, NewToolIsNotTakenForTheOld) {
  scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene_.add(box_.handle, PLP_BODY_TOOL, at(1.25, 0, 0));
  EXPECT_EQ(scene_.step().set_count, 0u);
  ASSERT_EQ(plp_scene_remove_body(scene_.handle, tool), PLP_OK);
  EXPECT_EQ(scene_.step().set_count, 0u);
  const TestModel larger(box(0.625f, 0.625f, 0.625f));
  scene_.add(larger.handle, PLP_BODY_TOOL, at(1.25, 0, 0));
  const plp_contacts contacts = scene_.step();
  EXPECT_EQ(contacts.set_count, 1u);
  EXPECT_EQ(contacts.min_distance, 0.125);
}

TEST_F(SceneTest, SceneKeepsItsModels) {
  plp_model model = nullptr;
  const Shape shape = box(0.5f, 0.5f, 0.5f);
  const plp_triangles triangles = triangles_of(shape);
  ASSERT_EQ(plp_model_create_from_triangles(&triangles, nullptr, &model), PLP_OK);
  scene_.add(model, PLP_BODY_STATIC, at(0, 0, 0));
  scene_.add(model, PLP_BODY_TOOL, at(1.125, 0, 0));
  ASSERT_EQ(plp_model_release(model), PLP_OK);
  EXPECT_EQ(scene_.step().set_count, 1u);
}

TEST_F(SceneTest, OutcomeIsKeptUntilTheNextStep) {
  const plp_body body = scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene_.add(box_.handle, PLP_BODY_TOOL, at(1.125, 0, 0));
  scene_.step();
  ASSERT_EQ(plp_scene_remove_body(scene_.handle, body), PLP_OK);
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  ASSERT_EQ(plp_scene_get_contacts(scene_.handle, &contacts), PLP_OK);
  EXPECT_EQ(contacts.set_count, 1u);
  EXPECT_EQ(scene_.step().set_count, 0u);
}

TEST_F(SceneTest, FarFromTheOriginIsAsAtIt) {
  scene_.add(box_.handle, PLP_BODY_STATIC, at(1048576.0, -2097152.0, 0));
  scene_.add(box_.handle, PLP_BODY_TOOL, at(1048577.125, -2097152.0, 0));
  const plp_contacts contacts = scene_.step();
  ASSERT_EQ(contacts.set_count, 1u);
  EXPECT_EQ(contacts.min_distance, 0.125);
  EXPECT_NEAR(contacts.wrench.force[0], 75.0, 1e-6);
  EXPECT_NEAR(contacts.wrench.torque[2], 0.0, 1e-6);
}

// A plateau begins within 1e-6 rad of parallel and lasts until 4e-6.
TEST_F(SceneTest, PlateauHasHysteresis) {
  scene_.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene_.add(box_.handle, PLP_BODY_TOOL, tilted(1.125, 2.5e-6));
  const auto lmds_at = [&](double angle) {
    set_pose(tool, tilted(1.125, angle));
    return scene_.step().lmd_count;
  };
  const std::size_t edge = lmds_at(2.5e-6);
  const std::size_t face = lmds_at(0.0);
  ASSERT_LT(edge, face) << "a tilted box touches with an edge";
  EXPECT_EQ(lmds_at(2.4e-6), face);
  EXPECT_EQ(lmds_at(2.6e-6), face);
  EXPECT_EQ(lmds_at(1e-3), edge);
}

// The same poses give the same bits in another scene of the same history.
TEST_F(SceneTest, StepsAreRepeatable) {
  const TestModel ring(torus(1.0, 0.25, 32, 16));
  const auto run = [&] {
    TestScene scene(0.3);
    scene.add(ring.handle, PLP_BODY_STATIC, at(0, 0, 0));
    const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, at(0, 0, 0));
    std::vector<plp_wrench> wrenches;
    for (int i = 0; i < 200; ++i) {
      const plp_pose pose = tilted(1.9 - 0.002 * i, 0.01 * i);
      EXPECT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      wrenches.push_back(scene.step().wrench);
    }
    return wrenches;
  };
  const std::vector<plp_wrench> first = run();
  const std::vector<plp_wrench> second = run();
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(plp_wrench)), 0);
}

}  // namespace
}  // namespace palpate::test
