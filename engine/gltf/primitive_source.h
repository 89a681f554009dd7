#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/gltf/accessor_reader.h"
#include "engine/gltf/draco_mesh.h"
#include "engine/gltf/triangle_list.h"

namespace palpate::gltf {

// One primitive of a mesh, whether its data lie in accessors or in a Draco stream.
class PrimitiveSource {
 public:
  PrimitiveSource(const tinygltf::Primitive& primitive, const PrimitiveExtra& extra,
                  AccessorReader& accessors, LoadBudget& budget);

  bool has(const std::string& attribute) const;
  AttributeTable table(const std::string& attribute, std::uint32_t width) const;
  std::shared_ptr<const AttributeTable> positions() const;

  // Their corners are checked to be below `vertices`.
  std::vector<TriangleIndices> triangles(TriangleMode mode, std::size_t vertices) const;

 private:
  std::vector<std::uint32_t> corners(std::size_t vertices) const;

  const tinygltf::Primitive& primitive_;
  const PrimitiveExtra& extra_;
  AccessorReader& accessors_;
  LoadBudget& budget_;
  std::optional<DracoMesh> draco_;
};

}  // namespace palpate::gltf
