#include "engine/gltf/load_budget.h"

#include <algorithm>
#include <limits>

#include "engine/gltf/byte_range.h"
#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

// A few seconds of decoding; a hundred million triangles that share nothing need a third of it.
constexpr std::uint64_t kMostElements = 1ull << 30;

// A soup has at most three vertices a triangle, and their indices have 32 bits.
constexpr std::uint64_t kMostTriangles = std::numeric_limits<std::uint32_t>::max() / 3;

}  // namespace

LoadBudget::LoadBudget(const GltfLimits& limits)
    : limits_(limits),
      bytes_left_(limits.max_file_bytes),
      elements_left_(kMostElements),
      triangles_left_(std::min(limits.max_triangles, kMostTriangles)),
      instances_left_(limits.max_nodes) {}

void LoadBudget::take_bytes(std::uint64_t count) {
  if (count > bytes_left_) fail(ErrorCode::kLimit, "more than ", limits_.max_file_bytes, " bytes of buffers");
  bytes_left_ -= count;
}

void LoadBudget::take_elements(std::uint64_t count) {
  if (count > elements_left_)
    fail(ErrorCode::kLimit, "more than ", kMostElements, " accessor elements to read");
  elements_left_ -= count;
}

void LoadBudget::require_triangles(std::uint64_t count) const {
  if (count > triangles_left_)
    fail(ErrorCode::kLimit, "more than ", std::min(limits_.max_triangles, kMostTriangles), " triangles");
}

void LoadBudget::take_instances(std::uint64_t instances, std::uint64_t triangles_each) {
  if (instances > instances_left_) fail(ErrorCode::kLimit, "more than ", limits_.max_nodes, " instances");
  const std::uint64_t triangles = saturated_product(instances, triangles_each);
  require_triangles(triangles);
  instances_left_ -= instances;
  triangles_left_ -= triangles;
}

}  // namespace palpate::gltf
