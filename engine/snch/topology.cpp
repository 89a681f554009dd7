#include "engine/snch/topology.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <new>
#include <vector>

#include "engine/base/memory_reserve.h"
#include "engine/base/parallel.h"

namespace palpate {
namespace {

using Branch = Topology::Branch;

// Trees of real models are 20 to 40 deep; geometric progressions of sizes can reach the range of float
// exponents.
constexpr unsigned kMaxDepth = 1000;

// Embree catches what its callbacks throw, and ends the build.
void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  using Node = Topology::InnerNode;
  void* const memory = rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node));
  if (!memory) throw std::bad_alloc();
  return new (memory) Node{};
}

// Comes once both children are complete.
void set_children(void* node, void** children, unsigned, void*) {
  auto& inner = *static_cast<Topology::InnerNode*>(node);
  inner = {{children[0], children[1]}, Branch(children[0]).leaves() + Branch(children[1]).leaves()};
}

void ignore_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t, void*) {
  return Branch(primitives[0].primID).code();
}

std::vector<RTCBuildPrimitive> primitives_of(const Mesh& mesh) {
  std::vector<RTCBuildPrimitive> primitives(mesh.triangles.size());
  for_each_in_parallel(mesh.triangles.size(), [&](std::uint32_t t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 low = glm::min(mesh.positions[a], glm::min(mesh.positions[b], mesh.positions[c]));
    const Vec3 high = glm::max(mesh.positions[a], glm::max(mesh.positions[b], mesh.positions[c]));
    primitives[t] = {low.x, low.y, low.z, 0, high.x, high.y, high.z, t};
  });
  return primitives;
}

RTCDevice new_device() {
  const RTCDevice made = rtcNewDevice(nullptr);
  if (!made) throw std::bad_alloc();
  return made;
}

// One device for the process: it owns the builder's worker threads.
RTCDevice device() {
  static const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> instance(new_device(),
                                                                                  &rtcReleaseDevice);
  return instance.get();
}

// Embree 3.13 binds a thread to the memory of a build before it notes that it did: where the note finds no
// memory the thread stays bound to what is then released, and the next build destroys it. The notes are
// small.
constexpr std::size_t kReserve = 1u << 16;

}  // namespace

void Topology::Release::operator()(RTCBVHTy* bvh) const {
  rtcReleaseBVH(bvh);
}

Topology::Topology(const Mesh& mesh) : bvh_(rtcNewBVH(device())), root_(nullptr) {
  std::vector<RTCBuildPrimitive> primitives = primitives_of(mesh);
  if (!bvh_) throw std::bad_alloc();
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof(arguments);
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = kMaxDepth;
  arguments.sahBlockSize = 1;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = 1;
  arguments.bvh = bvh_.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = ignore_bounds;
  arguments.createLeaf = create_leaf;
  const MemoryReserve reserve(kReserve, MemoryReserve::For::kAllThreads);
  root_ = Branch(rtcBuildBVH(&arguments));
  if (!root_.code() || root_.leaves() != primitives.size() || reserve.is_touched()) throw std::bad_alloc();
}

}  // namespace palpate
