// What a scene and its bodies are made of: damping, friction, and the cap on stiffness.
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr double kCutoff = 0.2, kStiffness = 1000.0, kStep = 0.001;

using Force = std::array<double, 3>;

class MaterialTest : public testing::Test {
 protected:
  static plp_scene_options options() { return TestScene::options_with(kCutoff); }
  static plp_body_options body_options(plp_model model, plp_body_kind kind, const plp_pose& pose) {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = model;
    options.kind = kind;
    options.pose = pose;
    return options;
  }
  static plp_body add(const TestScene& scene, const plp_body_options& options) {
    plp_body body = 0;
    EXPECT_EQ(plp_scene_add_body(scene.handle, &options, &body), PLP_OK) << plp_last_error();
    return body;
  }
  static plp_contacts step_to(TestScene& scene, plp_body tool, const plp_pose& pose) {
    EXPECT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
    return scene.step();
  }
  // The force after a tool has moved from one place to another beside a wall of its own material.
  Force force_of(const plp_scene_options& options, const plp_pose& from, const plp_pose& to,
                 double own_damping = 0.0, double own_friction = 0.0) {
    TestScene scene(options);
    plp_body_options wall = body_options(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
    wall.damping = own_damping;
    wall.friction = own_friction;
    add(scene, wall);
    const plp_body tool = add(scene, body_options(box_.handle, PLP_BODY_TOOL, from));
    scene.step();
    const plp_contacts contacts = step_to(scene, tool, to);
    Force sum{};
    for (std::size_t i = 0; i < contacts.spring_count; ++i)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += contacts.springs[i].force[k];
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(sum[k], contacts.wrench.force[k], 1e-9) << "the wrench is their sum";
    return sum;
  }

  const TestModel box_{box(0.5f, 0.5f, 0.5f)};
};

TEST_F(MaterialTest, SpringsAreTheMinimaByDefault) {
  TestScene scene(options());
  scene.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, at(1.125, 0, 0));
  scene.step();
  const plp_contacts contacts = step_to(scene, tool, at(1.12, 0.001, 0));
  ASSERT_EQ(contacts.spring_count, contacts.lmd_count);
  ASSERT_GT(contacts.spring_count, 0u);
  EXPECT_EQ(std::memcmp(contacts.springs, contacts.lmds, contacts.lmd_count * sizeof(plp_lmd)), 0);
  EXPECT_EQ(contacts.status, 0u);
}

TEST_F(MaterialTest, DampingIsOnlyFeltWhileClosing) {
  plp_scene_options damped = options();
  damped.damping = 50.0;
  const double at_rest = kStiffness * (kCutoff - 0.1);
  EXPECT_NEAR(force_of(damped, at(1.102, 0, 0), at(1.1, 0, 0))[0], at_rest + 50.0 * 0.002 / kStep, 1e-4);
  EXPECT_NEAR(force_of(damped, at(1.098, 0, 0), at(1.1, 0, 0))[0], at_rest, 1e-4);
  EXPECT_NEAR(force_of(damped, at(1.1, 0, 0), at(1.1, 0, 0))[0], at_rest, 1e-4) << "at rest";
  EXPECT_NEAR(force_of(damped, at(1.4, 0, 0), at(1.1, 0, 0))[0], at_rest, 1e-4) << "put there";
  damped.time_step = 2.0 * kStep;
  EXPECT_NEAR(force_of(damped, at(1.102, 0, 0), at(1.1, 0, 0))[0], at_rest + 50.0 * 0.002 / damped.time_step,
              1e-4);
}

TEST_F(MaterialTest, FrictionOpposesTheSlip) {
  plp_scene_options rough = options();
  rough.stiffness = 10.0;  // presses with 1 N
  rough.friction = 0.3;
  EXPECT_NEAR(force_of(rough, at(1.1, -0.002, 0), at(1.1, 0, 0))[1], -0.3, 1e-6);
  EXPECT_NEAR(force_of(rough, at(1.1, 0, 0.002), at(1.1, 0, 0))[2], 0.3, 1e-6);
  EXPECT_NEAR(force_of(rough, at(1.1, -1e-6, 0), at(1.1, 0, 0))[1], -20.0 * 1e-6 / kStep, 1e-6) << "viscous";
  EXPECT_EQ(force_of(rough, at(1.1, 0, 0), at(1.1, 0, 0))[1], 0.0) << "at rest";
}

TEST_F(MaterialTest, BodiesHaveTheirOwn) {
  plp_scene_options common = options();
  common.stiffness = 10.0;
  common.damping = 5.0;
  common.friction = 0.3;
  const plp_pose from = at(1.102, 0, 0), slid = at(1.1, -0.002, 0), to = at(1.1, 0, 0);
  EXPECT_NEAR(force_of(common, from, to)[0], 1.0 + 10.0, 1e-6);
  EXPECT_NEAR(force_of(common, from, to, 7.0)[0], 1.0 + 14.0, 1e-6);
  EXPECT_NEAR(force_of(common, slid, to, 0.0, 0.2)[1], -0.2, 1e-6);
  EXPECT_EQ(force_of(common, slid, to, 0.0, -1.0)[1], 0.0) << "none";
}

TEST_F(MaterialTest, CapBoundsAllSpringsTogether) {
  plp_scene_options capped = options();
  TestScene scene(capped);
  scene.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene.add(box_.handle, PLP_BODY_STATIC, at(0, 3, 0));
  plp_body_options deep = body_options(box_.handle, PLP_BODY_TOOL, at(1.1, 0, 0));
  const plp_body tool = add(scene, deep);
  const double free = scene.step().wrench.force[0];
  EXPECT_EQ(plp_scene_set_stiffness_cap(scene.handle, 400.0), PLP_OK);
  EXPECT_NEAR(scene.step().wrench.force[0], free / (1.0 + 2.0 * 1000.0 / 400.0), 1e-9)
      << "one plateau is one spring of 1000 N/m";
  for (const double none : {0.0, -1.0}) {
    EXPECT_EQ(plp_scene_set_stiffness_cap(scene.handle, none), PLP_OK);
    EXPECT_EQ(scene.step().wrench.force[0], free) << "no device";
  }
  EXPECT_EQ(plp_scene_set_stiffness_cap(scene.handle, 400.0), PLP_OK);
  scene.add(box_.handle, PLP_BODY_STATIC, at(2.2, 0, 0));  // squeezes the tool: two springs in one line
  const plp_contacts squeezed = step_to(scene, tool, at(1.09, 0, 0));
  EXPECT_NEAR(squeezed.wrench.force[0], 2.0 * 1000.0 * 0.01 / (1.0 + 2.0 * 1000.0 / 400.0), 1e-6);
}

TEST_F(MaterialTest, OverlapsAreHeldByWalls) {
  TestScene scene(options());
  scene.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, at(1.01, 0.1, 0.1));
  scene.step();
  const plp_contacts contacts = step_to(scene, tool, at(0.99, 0.1, 0.1));
  EXPECT_EQ(contacts.overlap, 1);
  EXPECT_EQ(contacts.status, std::uint32_t{PLP_STATUS_WALL});
  ASSERT_GT(contacts.spring_count, 0u);
  for (std::size_t i = 0; i < contacts.spring_count; ++i) {
    EXPECT_EQ(contacts.springs[i].set, UINT32_MAX);
    EXPECT_NEAR(contacts.springs[i].distance, -0.01, 1e-6);
  }
  EXPECT_NEAR(contacts.wrench.force[0], kStiffness * (kCutoff + 0.01), 1e-3);
  const plp_contacts outside = step_to(scene, tool, at(1.01, 0.1, 0.1));
  EXPECT_EQ(outside.status, 0u);
  EXPECT_NEAR(outside.wrench.force[0], kStiffness * (kCutoff - 0.01), 1e-3);
}

TEST_F(MaterialTest, SettersTakeEffect) {
  TestScene scene(options());
  scene.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, at(1.102, -0.002, 0));
  scene.step();
  EXPECT_EQ(plp_scene_set_damping(scene.handle, 30.0), PLP_OK);
  EXPECT_EQ(plp_scene_set_friction(scene.handle, 0.1), PLP_OK);
  const plp_contacts contacts = step_to(scene, tool, at(1.1, 0, 0));
  EXPECT_NEAR(contacts.wrench.force[0], 100.0 + 60.0, 1e-6);
  EXPECT_NEAR(contacts.wrench.force[1], -16.0, 1e-6);
}

TEST_F(MaterialTest, OlderStructsAreAsBefore) {
  plp_scene_options old = options();
  old.damping = 1e6;  // behind the old struct's end
  old.struct_size = offsetof(plp_scene_options, law);
  EXPECT_NEAR(force_of(old, at(1.102, 0, 0), at(1.1, 0, 0))[0], 100.0, 1e-6);
}

TEST_F(MaterialTest, OnlyNumbersThatAreNotNegativeAreTaken) {
  TestScene scene(options());
  for (const double bad : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    for (const auto set : {plp_scene_set_damping, plp_scene_set_friction})
      EXPECT_EQ(set(scene.handle, bad), PLP_ERROR_INVALID_ARGUMENT) << bad;
    for (const auto field : {&plp_scene_options::damping, &plp_scene_options::friction,
                             &plp_scene_options::fade_time, &plp_scene_options::time_step}) {
      plp_scene_options wrong = options();
      wrong.*field = bad;
      plp_scene made = nullptr;
      EXPECT_EQ(plp_scene_create(&wrong, &made), PLP_ERROR_INVALID_ARGUMENT) << bad;
    }
    plp_body_options body = body_options(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
    plp_body added = 0;
    body.damping = bad;
    EXPECT_EQ(plp_scene_add_body(scene.handle, &body, &added), PLP_ERROR_INVALID_ARGUMENT) << bad;
  }
  EXPECT_EQ(plp_scene_set_damping(nullptr, 1.0), PLP_ERROR_INVALID_HANDLE);
}

TEST_F(MaterialTest, ACapIsANumber) {
  TestScene scene(options());
  for (const double bad : {-1e300, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(plp_scene_set_stiffness_cap(scene.handle, bad), PLP_ERROR_INVALID_ARGUMENT) << bad;
    plp_scene_options wrong = options();
    wrong.stiffness_cap = bad;
    plp_scene made = nullptr;
    EXPECT_EQ(plp_scene_create(&wrong, &made), PLP_ERROR_INVALID_ARGUMENT) << bad;
  }
}

}  // namespace
}  // namespace palpate::test
