#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/gltf/attribute_table.h"
#include "engine/gltf/load_budget.h"
#include "engine/mesh/triangle_soup.h"

namespace draco {
class Mesh;
}

namespace palpate::gltf {

// How the accessor beside a compressed attribute wants its integers read.
struct DracoFormat {
  int component_type;
  bool normalized;
};

// A primitive decoded from KHR_draco_mesh_compression. Draco gives a plain list of triangles, also for
// strips.
class DracoMesh {
 public:
  DracoMesh(std::span<const std::byte> stream, LoadBudget& budget);
  DracoMesh(DracoMesh&&) noexcept;
  ~DracoMesh();

  std::vector<TriangleIndices> triangles() const;
  AttributeTable table(int unique_id, std::uint32_t width, const DracoFormat& format) const;

 private:
  LoadBudget* budget_;
  std::unique_ptr<draco::Mesh> mesh_;
};

}  // namespace palpate::gltf
