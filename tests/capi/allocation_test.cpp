#include "tests/capi/shapes.h"
#include "tests/support/allocation_count.h"

namespace palpate::test {
namespace {

TEST(Allocation, IsCounted) {
  const std::uint64_t before = allocation_count();
  const TestModel model(box(1, 1, 1));
  EXPECT_GT(allocation_count(), before) << "the library's own allocations are seen";
}

// What has been met once is met again without allocating.
TEST(Allocation, StepsAllocateNothingOnceTheyHaveMetTheirScene) {
  const TestModel ring(torus(1.0, 0.25, 48, 24));
  const TestModel cube(box(0.5f, 0.5f, 0.5f));
  TestScene scene(0.3);
  scene.add(ring.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene.add(cube.handle, PLP_BODY_STATIC, at(3, 0, 0));
  const plp_body tool = scene.add(cube.handle, PLP_BODY_TOOL, at(0, 0, 0));
  std::uint64_t during_last_round = 0;
  // Cells of the front are renewed in turn, so that its highest water may come some rounds late.
  for (int round = 0; round < 8; ++round) {
    const std::uint64_t before = allocation_count();
    for (int i = 0; i < 100; ++i) {
      const plp_pose pose = {{1.80 + 0.002 * i, 0.01 * i, 0.0}, {0.0, 0.003 * i, 0.002 * i, 1.0}};
      ASSERT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      scene.step();
    }
    during_last_round = allocation_count() - before;
  }
  EXPECT_EQ(during_last_round, 0u);
}

}  // namespace
}  // namespace palpate::test
