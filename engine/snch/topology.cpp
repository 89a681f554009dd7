#include "engine/snch/topology.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <new>

#include "engine/base/memory_reserve.h"
#include "engine/snch/tree.h"

namespace palpate {
namespace {

// Trees of real models are 20 to 40 deep; geometric progressions of sizes can reach the range of float
// exponents.
constexpr unsigned kMaxDepth = 1000;

struct BuildNode {
  BuildNode* children[2];
  std::uint32_t triangle;
};

// Embree catches what its callbacks throw, and ends the build.
void* node_memory(RTCThreadLocalAllocator allocator) {
  void* const memory = rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode));
  if (!memory) throw std::bad_alloc();
  return memory;
}

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (node_memory(allocator)) BuildNode{};
}

void set_children(void* node, void** children, unsigned, void*) {
  for (int i = 0; i < 2; ++i)
    static_cast<BuildNode*>(node)->children[i] = static_cast<BuildNode*>(children[i]);
}

void ignore_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t,
                  void*) {
  return new (node_memory(allocator)) BuildNode{{nullptr, nullptr}, primitives[0].primID};
}

std::vector<RTCBuildPrimitive> primitives_of(const Mesh& mesh) {
  std::vector<RTCBuildPrimitive> primitives(mesh.triangles.size());
  for (std::uint32_t t = 0; t < primitives.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 low = glm::min(mesh.positions[a], glm::min(mesh.positions[b], mesh.positions[c]));
    const Vec3 high = glm::max(mesh.positions[a], glm::max(mesh.positions[b], mesh.positions[c]));
    primitives[t] = {low.x, low.y, low.z, 0, high.x, high.y, high.z, t};
  }
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

void append_depth_first(const BuildNode* root, std::vector<TopologyNode>& nodes) {
  struct Visit {
    const BuildNode* node;
    std::uint32_t parent;  // whose second child this is, or kNone
  };
  constexpr std::uint32_t kNone = ~0u;
  std::vector<Visit> stack{{root, kNone}};
  while (!stack.empty()) {
    const auto [node, parent] = stack.back();
    stack.pop_back();
    const auto index = static_cast<std::uint32_t>(nodes.size());
    if (parent != kNone) nodes[parent].link = index;
    if (!node->children[0]) {
      nodes.push_back({Node::kLeaf | node->triangle, index + 1});
      continue;
    }
    nodes.push_back({0, 0});
    stack.push_back({node->children[1], index});
    stack.push_back({node->children[0], kNone});
  }
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (!(nodes[i].link & Node::kLeaf)) nodes[i].end = nodes[nodes[i].link].end;
}

}  // namespace

std::vector<TopologyNode> build_topology(const Mesh& mesh) {
  std::vector<RTCBuildPrimitive> primitives = primitives_of(mesh);
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device()), &rtcReleaseBVH);
  if (!bvh) throw std::bad_alloc();
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof(arguments);
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = kMaxDepth;
  arguments.sahBlockSize = 1;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = 1;
  arguments.bvh = bvh.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = ignore_bounds;
  arguments.createLeaf = create_leaf;
  const MemoryReserve reserve(kReserve, MemoryReserve::For::kAllThreads);
  const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  if (!root || reserve.is_touched()) throw std::bad_alloc();

  std::vector<TopologyNode> nodes;
  nodes.reserve(2 * primitives.size());
  append_depth_first(root, nodes);
  return nodes;
}

}  // namespace palpate
