#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/gltf/gltf_file.h"

namespace palpate::test {

using Json = nlohmann::json;
using Bytes = std::vector<std::byte>;

// A glTF document put together in memory. `json` is open to every change that a case needs.
class GltfBuilder {
 public:
  GltfBuilder();

  // Each returns the index of what it adds.
  int add_view(const void* data, std::size_t size, int stride = 0);
  int add_accessor(int view, int component_type, std::size_t count, const char* type);
  int add_node(Json node);  // also as a root of scene 0
  int add_mesh(Json primitive);

  template <class T>
  int add_array(const std::vector<T>& values, int component_type, const char* type, std::size_t width) {
    const int view = add_view(values.data(), values.size() * sizeof(T));
    return add_accessor(view, component_type, values.size() / width, type);
  }
  int add_positions(const std::vector<float>& xyz) { return add_array(xyz, 5126, "VEC3", 3); }
  int add_indices(const std::vector<std::uint16_t>& indices) { return add_array(indices, 5123, "SCALAR", 1); }

  Bytes glb() const;         // with the buffer as the binary chunk
  std::string gltf() const;  // with the buffer as a data URI
  const Bytes& bin() const { return bin_; }

  Json json;

 private:
  Bytes bin_;
};

// A container of these chunks; an empty `bin` has no chunk.
Bytes make_glb(const std::string& json, const Bytes& bin);
Bytes bytes_of(const std::string& text);
std::string data_uri(const Bytes& bytes);

// Corners (0,0,0), (1,0,0), (0,1,0) and the quad that (1,1,0) makes of them, in glTF's order of strips.
inline const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
inline const std::vector<float> kStripQuad = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

// One triangle, counter-clockwise in the plane z = 0, in a mesh that one node shows.
GltfBuilder triangle_builder();

Result<GltfScene> read(const Bytes& bytes, const GltfOptions& options = {});
inline Result<GltfScene> read(const GltfBuilder& builder, const GltfOptions& options = {}) {
  return read(builder.glb(), options);
}

// The sum of the triangles' area vectors, ½ Σ (b − a) × (c − a).
DVec3 area_vector(const TriangleSoup& soup);

}  // namespace palpate::test
