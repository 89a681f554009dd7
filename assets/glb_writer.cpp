// Based on: Khronos Group, glTF 2.0 specification, sections 3.6 (buffers, accessors) and 4 (GLB).
#include "assets/glb_writer.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "engine/math/box.h"

namespace palpate {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::size_t kBytesPerPosition = 12;
constexpr std::size_t kBytesPerIndex = 4;

// GLB is little-endian whatever the machine.
void put_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xffu));
}

void put_f32(std::string& bytes, double value) {
  put_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

// Shortest text that reads back as the same number.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string vector3(const DVec3& v) {
  return joined({"[", number(v.x), ",", number(v.y), ",", number(v.z), "]"});
}

// Indices sorted by the primitive that they go to.
struct Primitives {
  std::string indices;
  std::size_t single_sided = 0;  // triangles
  std::size_t double_sided = 0;
};

Primitives split_by_sides(const TriangleSoup& soup) {
  Primitives result;
  for (const bool pass : {false, true}) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      const bool both = !soup.double_sided.empty() && soup.double_sided[t];
      if (both != pass) continue;
      for (const std::uint32_t corner : soup.triangles[t]) put_u32(result.indices, corner);
      ++(both ? result.double_sided : result.single_sided);
    }
  }
  return result;
}

std::string position_accessor(const TriangleSoup& soup) {
  Box bounds;
  for (const DVec3& p : soup.positions) bounds.grow(p);
  return joined({R"({"bufferView":0,"componentType":5126,"count":)", std::to_string(soup.positions.size()),
                 R"(,"type":"VEC3","min":)", vector3(bounds.low), R"(,"max":)", vector3(bounds.high), "}"});
}

std::string index_accessor(std::size_t first_triangle, std::size_t triangles) {
  return joined({R"({"bufferView":1,"byteOffset":)", std::to_string(first_triangle * 3 * kBytesPerIndex),
                 R"(,"componentType":5125,"count":)", std::to_string(3 * triangles), R"(,"type":"SCALAR"})"});
}

std::string primitive(std::size_t accessor, bool double_sided) {
  return joined({R"({"attributes":{"POSITION":0},"indices":)", std::to_string(accessor),
                 double_sided ? R"(,"material":0})" : "}"});
}

std::string view(std::size_t offset, std::size_t length, std::string_view target) {
  return joined({R"({"buffer":0,"byteOffset":)", std::to_string(offset), R"(,"byteLength":)",
                 std::to_string(length), R"(,"target":)", target, "}"});
}

std::string document(const TriangleSoup& soup, const std::string& name, const Primitives& primitives) {
  constexpr std::string_view kArrayBuffer = "34962";
  constexpr std::string_view kElementArrayBuffer = "34963";
  std::string accessors = position_accessor(soup);
  std::string parts;
  if (primitives.single_sided > 0) {
    accessors += joined({",", index_accessor(0, primitives.single_sided)});
    parts += primitive(1, false);
  }
  if (primitives.double_sided > 0) {
    accessors += joined({",", index_accessor(primitives.single_sided, primitives.double_sided)});
    parts += parts.empty() ? primitive(1, true) : joined({",", primitive(2, true)});
  }
  const std::size_t position_bytes = soup.positions.size() * kBytesPerPosition;
  const std::size_t index_bytes = primitives.indices.size();
  return joined(
      {R"({"asset":{"version":"2.0","generator":"palpate-make-assets"},"scene":0,"scenes":[{"nodes":[0]}],)",
       R"("nodes":[{"mesh":0,"name":")", name, R"("}],"meshes":[{"name":")", name, R"(","primitives":[)",
       parts, "]}],", primitives.double_sided > 0 ? R"("materials":[{"doubleSided":true}],)" : "",
       R"("accessors":[)", accessors, R"(],"bufferViews":[)", view(0, position_bytes, kArrayBuffer), ",",
       view(position_bytes, index_bytes, kElementArrayBuffer), R"(],"buffers":[{"byteLength":)",
       std::to_string(position_bytes + index_bytes), "}]}"});
}

void put_chunk(std::string& bytes, std::uint32_t type, const std::string& content) {
  put_u32(bytes, static_cast<std::uint32_t>(content.size()));
  put_u32(bytes, type);
  bytes += content;
}

}  // namespace

std::string glb_bytes(const TriangleSoup& soup, const std::string& name) {
  const Primitives primitives = split_by_sides(soup);
  std::string json = document(soup, name, primitives);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  // Positions and indices are whole words: the binary chunk needs no padding.
  std::string binary;
  for (const DVec3& p : soup.positions) {
    for (int axis = 0; axis < 3; ++axis) put_f32(binary, p[axis]);
  }
  binary += primitives.indices;

  std::string bytes;
  put_u32(bytes, kGlbMagic);
  put_u32(bytes, 2);
  put_u32(bytes,
          static_cast<std::uint32_t>(kHeaderSize + 2 * kChunkHeaderSize + json.size() + binary.size()));
  put_chunk(bytes, kJsonChunk, json);
  put_chunk(bytes, kBinaryChunk, binary);
  return bytes;
}

}  // namespace palpate
