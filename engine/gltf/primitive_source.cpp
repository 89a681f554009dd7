#include "engine/gltf/primitive_source.h"

#include <numeric>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

void check_corners(const std::vector<TriangleIndices>& triangles, std::size_t vertices) {
  for (const TriangleIndices& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner < vertices) continue;
      if (vertices == 0) fail(ErrorCode::kBadFormat, "index ", corner, " but there is no vertex");
      fail(ErrorCode::kBadFormat, "index ", corner, " is past the last vertex ", vertices - 1);
    }
  }
}

}  // namespace

PrimitiveSource::PrimitiveSource(const tinygltf::Primitive& primitive, const PrimitiveExtra& extra,
                                 AccessorReader& accessors, LoadBudget& budget)
    : primitive_(primitive), extra_(extra), accessors_(accessors), budget_(budget) {
  if (extra.draco) draco_.emplace(accessors.buffers().view(extra.draco->buffer_view).bytes, budget);
}

bool PrimitiveSource::has(const std::string& attribute) const {
  return primitive_.attributes.contains(attribute);
}

AttributeTable PrimitiveSource::table(const std::string& attribute, std::uint32_t width) const {
  const int index = primitive_.attributes.at(attribute);
  if (!draco_ || !extra_.draco->attributes.contains(attribute)) return accessors_.table(index, width);
  const tinygltf::Accessor& accessor = accessors_.accessor(index);
  return draco_->table(extra_.draco->attributes.at(attribute), width,
                       {accessor.componentType, accessor.normalized});
}

std::shared_ptr<const AttributeTable> PrimitiveSource::positions() const {
  if (!draco_) return accessors_.positions(primitive_.attributes.at("POSITION"));
  return std::make_shared<const AttributeTable>(table("POSITION", 3));
}

std::vector<std::uint32_t> PrimitiveSource::corners(std::size_t vertices) const {
  if (extra_.indices >= 0) return accessors_.indices(extra_.indices);
  std::vector<std::uint32_t> all(vertices);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

std::vector<TriangleIndices> PrimitiveSource::triangles(TriangleMode mode, std::size_t vertices) const {
  std::vector<TriangleIndices> triangles;
  if (draco_) {
    triangles = draco_->triangles();
  } else {
    const std::uint64_t count = extra_.indices >= 0 ? accessors_.accessor(extra_.indices).count : vertices;
    budget_.require_triangles(count_triangles(count, mode));
    triangles = list_triangles(corners(vertices), mode);
  }
  check_corners(triangles, vertices);
  return triangles;
}

}  // namespace palpate::gltf
