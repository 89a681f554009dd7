#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "engine/mesh/triangle_soup.h"

namespace palpate {

// Reads a .glb file of one mesh with one TRIANGLES primitive of float32 POSITION and uint32 indices, both
// tightly packed in the binary chunk. Independent of engine/gltf, so that the two can check each other.
class SimpleGlb {
 public:
  explicit SimpleGlb(const std::string& path) : path_(path) {
    std::ifstream file(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    constexpr std::size_t kJsonBegin = 20;  // after the file's header and the chunk's
    const std::uint32_t json_size = read<std::uint32_t>(12);
    require(kJsonBegin + json_size + 8 <= bytes_.size());
    json_ = nlohmann::json::parse(bytes_.substr(kJsonBegin, json_size));
    binary_begin_ = kJsonBegin + json_size + 8;
  }

  TriangleSoup soup() const {
    const nlohmann::json& primitive = json_.at("meshes").at(0).at("primitives").at(0);
    TriangleSoup soup;
    const auto [positions, position_count] = accessor(primitive.at("attributes").at("POSITION"), 5126);
    for (std::size_t i = 0; i < position_count; ++i) {
      const std::size_t at = positions + 12 * i;
      soup.positions.emplace_back(read<float>(at), read<float>(at + 4), read<float>(at + 8));
    }
    const auto [indices, index_count] = accessor(primitive.at("indices"), 5125);
    for (std::size_t i = 0; i + 2 < index_count; i += 3) {
      const std::size_t at = indices + 4 * i;
      soup.triangles.push_back(
          {read<std::uint32_t>(at), read<std::uint32_t>(at + 4), read<std::uint32_t>(at + 8)});
    }
    return soup;
  }

 private:
  void require(bool condition) const {
    if (!condition) throw std::runtime_error(path_ + " is not the simple kind of .glb file that tests use");
  }

  template <class T>
  T read(std::size_t offset) const {
    require(offset + sizeof(T) <= bytes_.size());
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof(T));
    return value;
  }

  // Where the accessor's bytes begin, and its count.
  std::pair<std::size_t, std::size_t> accessor(const nlohmann::json& index, int component_type) const {
    const nlohmann::json& accessor = json_.at("accessors").at(index.get<std::size_t>());
    require(accessor.at("componentType") == component_type);
    const nlohmann::json& view = json_.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    require(!view.contains("byteStride"));
    const std::size_t offset = view.value("byteOffset", 0u) + accessor.value("byteOffset", 0u);
    return {binary_begin_ + offset, accessor.at("count")};
  }

  std::string path_;
  std::string bytes_;
  nlohmann::json json_;
  std::size_t binary_begin_ = 0;
};

}  // namespace palpate
