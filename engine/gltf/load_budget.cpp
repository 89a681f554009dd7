#include "engine/gltf/load_budget.h"

#include <algorithm>
#include <limits>

#include "engine/gltf/byte_range.h"
#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

// Six a triangle are its corners and their indices when nothing is shared; the rest is for skins and morph
// targets.
constexpr std::uint64_t kElementsPerTriangle = 8;
constexpr std::uint64_t kElementsBesides = 1ull << 24;  // a tenth of a second

// A soup has at most three vertices a triangle, and their indices have 32 bits.
constexpr std::uint64_t kMostTriangles = std::numeric_limits<std::uint32_t>::max() / 3;

std::uint64_t most_triangles(const GltfLimits& limits) {
  return std::min(limits.max_triangles, kMostTriangles);
}

}  // namespace

LoadBudget::LoadBudget(const GltfLimits& limits)
    : limits_(limits),
      bytes_left_(limits.max_file_bytes),
      elements_left_(kElementsBesides + kElementsPerTriangle * most_triangles(limits)),
      triangles_left_(most_triangles(limits)),
      instances_left_(limits.max_nodes) {}

void LoadBudget::take_bytes(std::uint64_t count) {
  if (count > bytes_left_) fail(ErrorCode::kLimit, "more than ", limits_.max_file_bytes, " bytes of buffers");
  bytes_left_ -= count;
}

void LoadBudget::take_elements(std::uint64_t count) {
  if (count > elements_left_)
    fail(ErrorCode::kLimit, "more accessor elements to read than ", most_triangles(limits_),
         " triangles can need");
  elements_left_ -= count;
}

void LoadBudget::require_triangles(std::uint64_t count) const {
  if (count > triangles_left_) fail(ErrorCode::kLimit, "more than ", most_triangles(limits_), " triangles");
}

void LoadBudget::take_instances(std::uint64_t instances, std::uint64_t triangles_each) {
  if (instances > instances_left_) fail(ErrorCode::kLimit, "more than ", limits_.max_nodes, " instances");
  const std::uint64_t triangles = saturated_product(instances, triangles_each);
  require_triangles(triangles);
  instances_left_ -= instances;
  triangles_left_ -= triangles;
}

}  // namespace palpate::gltf
