#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/capi/shapes.h"

namespace {

// Every allocation of this program and of the library, which takes its operator new from here.
std::atomic<std::uint64_t> allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

void* counted(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, alignment);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace palpate::test {
namespace {

TEST(Allocation, IsCounted) {
  const std::uint64_t before = allocations;
  const TestModel model(box(1, 1, 1));
  EXPECT_GT(allocations, before) << "the library's own allocations are seen";
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
  for (int round = 0; round < 4; ++round) {
    const std::uint64_t before = allocations;
    for (int i = 0; i < 100; ++i) {
      const plp_pose pose = {{1.80 + 0.002 * i, 0.01 * i, 0.0}, {0.0, 0.003 * i, 0.002 * i, 1.0}};
      ASSERT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      scene.step();
    }
    during_last_round = allocations - before;
  }
  EXPECT_EQ(during_last_round, 0u);
}

}  // namespace
}  // namespace palpate::test
