#pragma once

#include <string>
#include <vector>

#include "engine/gltf/accessor_reader.h"
#include "engine/gltf/skin.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate::gltf {

// Turns meshes of the file into triangles.
class MeshReader {
 public:
  MeshReader(const GltfDocument& document, AccessorReader& accessors, LoadBudget& budget,
             std::vector<std::string>& notes)
      : document_(document), accessors_(accessors), budget_(budget), notes_(notes) {}

  // All triangles of a mesh, morphed by `weights` and then, unless it is nullptr, placed in the scene by
  // `skin`. The soup may be empty.
  TriangleSoup read(int mesh, const std::vector<double>& weights, const Skin* skin);

  // Primitives of points and lines that were skipped so far.
  std::size_t skipped() const { return skipped_; }

 private:
  void read_primitive(const tinygltf::Primitive& primitive, const PrimitiveExtra& extra,
                      const std::vector<double>& weights, const Skin* skin, TriangleSoup& soup);
  bool holds_triangles(const tinygltf::Primitive& primitive, const std::string& place);
  bool is_double_sided(const tinygltf::Primitive& primitive) const;

  const GltfDocument& document_;
  AccessorReader& accessors_;
  LoadBudget& budget_;
  std::vector<std::string>& notes_;
  std::size_t skipped_ = 0;
};

}  // namespace palpate::gltf
