#include "tests/gltf/gltf_builder.h"

#include <utility>

namespace palpate::test {
namespace {

void append_number(Bytes& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::byte>(value >> shift & 0xFFu));
}

void append_chunk(Bytes& glb, std::uint32_t type, const Bytes& data, std::byte padding) {
  const std::size_t padded = (data.size() + 3) / 4 * 4;
  append_number(glb, static_cast<std::uint32_t>(padded));
  append_number(glb, type);
  glb.insert(glb.end(), data.begin(), data.end());
  glb.insert(glb.end(), padded - data.size(), padding);
}

}  // namespace

GltfBuilder::GltfBuilder() {
  json = {
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", Json::array({{{"nodes", Json::array()}}})}};
}

int GltfBuilder::add_view(const void* data, std::size_t size, int stride) {
  bin_.resize((bin_.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", size}};
  if (stride != 0) view["byteStride"] = stride;
  const auto* first = static_cast<const std::byte*>(data);
  bin_.insert(bin_.end(), first, first + size);
  json["buffers"][0]["byteLength"] = bin_.size();
  json["bufferViews"].push_back(view);
  return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfBuilder::add_accessor(int view, int component_type, std::size_t count, const char* type) {
  json["accessors"].push_back(
      {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
  return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfBuilder::add_node(Json node) {
  json["nodes"].push_back(std::move(node));
  const int index = static_cast<int>(json["nodes"].size()) - 1;
  json["scenes"][0]["nodes"].push_back(index);
  return index;
}

int GltfBuilder::add_mesh(Json primitive) {
  json["meshes"].push_back({{"primitives", Json::array({std::move(primitive)})}});
  return static_cast<int>(json["meshes"].size()) - 1;
}

Bytes GltfBuilder::glb() const {
  return make_glb(json.dump(), bin_);
}

std::string GltfBuilder::gltf() const {
  Json embedded = json;
  if (!bin_.empty()) embedded["buffers"][0]["uri"] = data_uri(bin_);
  return embedded.dump();
}

Bytes make_glb(const std::string& json, const Bytes& bin) {
  Bytes chunks;
  append_chunk(chunks, 0x4E4F534A, bytes_of(json), std::byte{' '});
  if (!bin.empty()) append_chunk(chunks, 0x004E4942, bin, std::byte{0});
  Bytes glb = bytes_of("glTF");
  append_number(glb, 2);
  append_number(glb, static_cast<std::uint32_t>(12 + chunks.size()));
  glb.insert(glb.end(), chunks.begin(), chunks.end());
  return glb;
}

Bytes bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

std::string data_uri(const Bytes& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = "data:application/octet-stream;base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      uri += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return uri;
}

GltfBuilder triangle_builder() {
  GltfBuilder builder;
  const int positions = builder.add_positions(kTriangle);
  builder.add_node({{"mesh", builder.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
  return builder;
}

Result<GltfScene> read(const Bytes& bytes, const GltfOptions& options) {
  return read_gltf_bytes(bytes, "case.gltf", {}, options);
}

DVec3 area_vector(const TriangleSoup& soup) {
  DVec3 sum(0.0);
  for (const TriangleIndices& triangle : soup.triangles) {
    const DVec3& a = soup.positions[triangle[0]];
    sum += 0.5 * glm::cross(soup.positions[triangle[1]] - a, soup.positions[triangle[2]] - a);
  }
  return sum;
}

}  // namespace palpate::test
