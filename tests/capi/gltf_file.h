#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/capi/shapes.h"

namespace palpate::test {

using Json = nlohmann::json;

inline std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < 3; ++k) block = block << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[block >> (18 - 6 * k) & 63u];
  }
  return text;
}

// A glTF document of one mesh for each shape; its nodes are for the caller to add.
inline Json gltf_of(const std::vector<Shape>& shapes) {
  Json json = {{"asset", {{"version", "2.0"}}},
               {"scene", 0},
               {"scenes", Json::array({{{"nodes", Json::array()}}})},
               {"nodes", Json::array()}};
  std::vector<unsigned char> bytes;
  const auto add = [&](const auto& rows, int component_type, const char* type, std::size_t count) {
    const std::size_t size = rows.size() * sizeof(rows[0]);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"count", count},
                                 {"type", type}});
    bytes.resize(bytes.size() + size);
    std::memcpy(bytes.data() + bytes.size() - size, rows.data(), size);
    return json["accessors"].size() - 1;
  };
  for (const Shape& shape : shapes) {
    const std::size_t positions = add(shape.positions, 5126, "VEC3", shape.positions.size());
    const std::size_t indices = add(shape.triangles, 5125, "SCALAR", 3 * shape.triangles.size());
    json["meshes"].push_back(
        {{"primitives", Json::array({{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}})}});
  }
  json["buffers"] = {
      {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
  return json;
}

// Adds a root of the scene, or a child of `parent`.
inline std::size_t add_node(Json& json, Json node, int parent = -1) {
  json["nodes"].push_back(std::move(node));
  const std::size_t index = json["nodes"].size() - 1;
  Json& siblings =
      parent < 0 ? json["scenes"][0]["nodes"] : json["nodes"][static_cast<std::size_t>(parent)]["children"];
  siblings.push_back(index);
  return index;
}

// A document in a file that lives as long as this.
class GltfFile {
 public:
  explicit GltfFile(const Json& json) {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("palpate_scene_" + std::to_string(::getpid()) + "_" + std::to_string(++count) + ".gltf");
    std::ofstream(path_) << json.dump();
  }
  ~GltfFile() { std::filesystem::remove(path_); }
  GltfFile(const GltfFile&) = delete;
  GltfFile& operator=(const GltfFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace palpate::test
