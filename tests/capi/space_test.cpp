// One scene told in several spaces must be one physical scene. The conversions here are plain matrices, so
// that they share nothing with the library's.
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

struct NamedSpace {
  const char* name;
  plp_space space;
};

constexpr NamedSpace kSpaces[] = {
    {"palpate", {{1, 2, 3}, 0, 1.0}},         {"unity_flip_x", {{-1, 2, 3}, 0, 1.0}},
    {"unity_flip_z", {{1, 2, -3}, 0, 1.0}},   {"z_up", {{1, -3, 2}, 0, 1.0}},
    {"millimetres", {{1, 2, 3}, 0, 0.001}},   {"unreal_like", {{3, 1, 2}, 0, 0.01}},
    {"all_mirrored", {{-1, -2, -3}, 0, 2.0}},
};

// The matrix that takes a direction of `space` to Palpate's.
glm::dmat3 matrix_of(const plp_space& space) {
  glm::dmat3 matrix(0.0);
  for (int i = 0; i < 3; ++i) matrix[i][std::abs(space.axes[i]) - 1] = space.axes[i] > 0 ? 1.0 : -1.0;
  return matrix;
}

glm::dvec3 vector_of(const double numbers[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}

plp_pose pose_in(const plp_space& space, const glm::dquat& rotation, const glm::dvec3& position) {
  const glm::dmat3 to_palpate = matrix_of(space);
  const glm::dmat3 from_palpate = glm::transpose(to_palpate);
  const glm::dquat turned = glm::quat_cast(from_palpate * glm::mat3_cast(rotation) * to_palpate);
  const glm::dvec3 moved = from_palpate * position / space.metres_per_unit;
  return {{moved.x, moved.y, moved.z}, {turned.x, turned.y, turned.z, turned.w}};
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance, const char* what) {
  EXPECT_LT(glm::length(actual - expected), tolerance) << what;
}

// The tool, a torus, hangs tilted between two boxes; it is clear of both by a few centimetres.
class SpaceTest : public testing::TestWithParam<NamedSpace> {
 protected:
  struct Outcome {
    plp_contacts contacts;
    std::vector<plp_lmd> lmds;
  };

  Outcome outcome_in(const plp_space& space) {
    const double unit = space.metres_per_unit;
    plp_scene_options options = TestScene::options_with(0.3 / unit);
    options.space = space;
    options.stiffness = 700.0;
    TestScene scene(options);
    scene.add(box_.handle, PLP_BODY_STATIC,
              pose_in(space, glm::dquat(0.96, 0.1, 0.2, -0.15), {-1.3, 0.1, 0.2}));
    scene.add(box_.handle, PLP_BODY_MOVING,
              pose_in(space, glm::dquat(0.9, -0.3, 0.1, 0.2), {1.35, -0.1, 0.3}));
    plp_body_options tool;
    plp_body_options_init(&tool, sizeof tool);
    tool.kind = PLP_BODY_TOOL;
    tool.model = torus_.handle;
    tool.pose = pose_in(space, glm::dquat(0.8, 0.3, -0.4, 0.1), {0.05, 0.02, 0.1});
    const glm::dvec3 reference = glm::transpose(matrix_of(space)) * glm::dvec3(0.1, -0.2, 0.05) / unit;
    for (int i = 0; i < 3; ++i) tool.reference_point[i] = reference[i];
    plp_body body = 0;
    EXPECT_EQ(plp_scene_add_body(scene.handle, &tool, &body), PLP_OK);
    const plp_contacts contacts = scene.step();
    return {contacts, {contacts.lmds, contacts.lmds + contacts.lmd_count}};
  }

  TestModel box_{box(0.5f, 0.6f, 0.7f)};
  TestModel torus_{torus(0.5, 0.15, 24, 12)};
};

TEST_P(SpaceTest, SameScene) {
  const plp_space& space = GetParam().space;
  const glm::dmat3 matrix = matrix_of(space);
  const double unit = space.metres_per_unit;
  const Outcome expected = outcome_in(kSpaces[0].space);
  const Outcome actual = outcome_in(space);
  ASSERT_GE(expected.contacts.set_count, 2u) << "the scene touches both boxes";
  ASSERT_EQ(expected.contacts.overlap, 0);
  ASSERT_EQ(actual.contacts.set_count, expected.contacts.set_count);
  ASSERT_EQ(actual.lmds.size(), expected.lmds.size());
  EXPECT_NEAR(unit * actual.contacts.min_distance, expected.contacts.min_distance, 1e-12);
  for (std::size_t i = 0; i < actual.lmds.size(); ++i) {
    const plp_lmd& mine = actual.lmds[i];
    const plp_lmd& theirs = expected.lmds[i];
    EXPECT_EQ(mine.body_a, theirs.body_a);
    EXPECT_EQ(mine.triangle_b, theirs.triangle_b);
    EXPECT_NEAR(unit * mine.distance, theirs.distance, 1e-12);
    expect_near(unit * (matrix * vector_of(mine.point_a)), vector_of(theirs.point_a), 1e-12, "point_a");
    expect_near(unit * (matrix * vector_of(mine.point_b)), vector_of(theirs.point_b), 1e-12, "point_b");
    expect_near(matrix * vector_of(mine.normal), vector_of(theirs.normal), 1e-10, "normal");
    expect_near(matrix * vector_of(mine.force), vector_of(theirs.force), 1e-8, "force");
  }
  const plp_wrench& wrench = actual.contacts.wrench;
  const glm::dvec3 torque = vector_of(expected.contacts.wrench.torque);
  ASSERT_GT(glm::length(torque), 1.0) << "the torque is worth a test";
  expect_near(matrix * vector_of(wrench.force), vector_of(expected.contacts.wrench.force), 1e-8, "force");
  expect_near(glm::determinant(matrix) * (matrix * vector_of(wrench.torque)), torque, 1e-8, "torque");
}

TEST_P(SpaceTest, PosesComeBack) {
  plp_scene_options options = TestScene::options_with(1.0);
  options.space = GetParam().space;
  TestScene scene(options);
  const glm::dquat rotation = glm::normalize(glm::dquat(0.8, 0.3, -0.4, 0.1));
  const plp_pose pose = {{1.25, -2.5, 3.75}, {rotation.x, rotation.y, rotation.z, rotation.w}};
  const plp_body body = scene.add(box_.handle, PLP_BODY_MOVING, pose);
  plp_pose read;
  ASSERT_EQ(plp_scene_get_pose(scene.handle, body, &read), PLP_OK);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(read.position[i], pose.position[i], 1e-14);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(read.orientation[i], pose.orientation[i], 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Spaces, SpaceTest, testing::ValuesIn(kSpaces),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace palpate::test
