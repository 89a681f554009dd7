#include "parsed_glb.h"

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace palpate::test {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}

std::uint32_t u32_at(const std::string& bytes, std::size_t offset) {
  require(offset + 4 <= bytes.size(), "file ends early");
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::uint32_t(static_cast<unsigned char>(bytes[offset + i])) << 8 * i;
  return value;
}

std::string chunk(const std::string& bytes, std::size_t& offset, std::uint32_t type) {
  const std::size_t length = u32_at(bytes, offset);
  require(u32_at(bytes, offset + 4) == type, "chunk type");
  require(length % 4 == 0, "chunk length is no multiple of 4");
  require(offset + 8 + length <= bytes.size(), "chunk ends after the file");
  const std::string content = bytes.substr(offset + 8, length);
  offset += 8 + length;
  return content;
}

// The bytes of an accessor, checked to lie within its view and its view within the buffer.
std::string accessor_bytes(const ParsedGlb& glb, int index, int component, const std::string& type,
                           std::size_t stride) {
  const auto& accessor = glb.document.at("accessors").at(index);
  const auto& view = glb.document.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  require(accessor.at("componentType") == component && accessor.at("type") == type, "accessor type");
  const std::size_t length = accessor.at("count").get<std::size_t>() * stride;
  const std::size_t within = accessor.value("byteOffset", std::size_t{0});
  const std::size_t start = view.value("byteOffset", std::size_t{0});
  const std::size_t view_length = view.at("byteLength").get<std::size_t>();
  require(start % 4 == 0 && within % 4 == 0, "alignment");
  require(within + length <= view_length, "accessor ends after its view");
  require(start + view_length <= glb.document.at("buffers").at(0).at("byteLength").get<std::size_t>(),
          "view ends after its buffer");
  return glb.binary.substr(start + within, length);
}

void read_positions(ParsedGlb& glb, int accessor) {
  const std::string bytes = accessor_bytes(glb, accessor, 5126, "VEC3", 12);
  for (std::size_t offset = 0; offset < bytes.size(); offset += 12) {
    DVec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t word = u32_at(bytes, offset + 4 * static_cast<std::size_t>(axis));
      float value = 0.0F;
      std::memcpy(&value, &word, sizeof value);
      p[axis] = value;
    }
    glb.soup.positions.push_back(p);
  }
}

void read_primitive(ParsedGlb& glb, const nlohmann::json& primitive) {
  const std::string bytes = accessor_bytes(glb, primitive.at("indices").get<int>(), 5125, "SCALAR", 4);
  const bool double_sided =
      primitive.contains("material") &&
      glb.document.at("materials").at(primitive["material"].get<std::size_t>()).value("doubleSided", false);
  for (std::size_t offset = 0; offset < bytes.size(); offset += 12) {
    glb.soup.triangles.push_back(
        {u32_at(bytes, offset), u32_at(bytes, offset + 4), u32_at(bytes, offset + 8)});
    glb.soup.double_sided.push_back(double_sided);
  }
}

}  // namespace

ParsedGlb parse_glb(const std::string& bytes) {
  require(u32_at(bytes, 0) == 0x46546C67 && u32_at(bytes, 4) == 2, "magic or version");
  require(u32_at(bytes, 8) == bytes.size(), "length in the header");
  ParsedGlb glb;
  std::size_t offset = 12;
  glb.document = nlohmann::json::parse(chunk(bytes, offset, 0x4E4F534A));
  glb.binary = chunk(bytes, offset, 0x004E4942);
  require(offset == bytes.size(), "bytes after the last chunk");
  const auto& primitives = glb.document.at("meshes").at(0).at("primitives");
  read_positions(glb, primitives.at(0).at("attributes").at("POSITION").get<int>());
  for (const auto& primitive : primitives) read_primitive(glb, primitive);
  return glb;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  require(file.good(), "file cannot be opened");
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

}  // namespace palpate::test
