#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/welded_scene.h"

namespace palpate::test {
namespace {

constexpr int kSide = 9;  // quads along each side of the curved sheet that is compressed here

struct Sheet {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
};

Sheet make_sheet() {
  Sheet sheet;
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) {
      const float fx = static_cast<float>(x);
      const float fy = static_cast<float>(y);
      sheet.positions.insert(sheet.positions.end(), {fx, fy, std::sin(fx) * std::cos(fy)});
    }
  }
  for (unsigned y = 0; y < kSide; ++y) {
    for (unsigned x = 0; x < kSide; ++x) {
      const unsigned a = y * (kSide + 1) + x;
      const unsigned above = a + kSide + 1;
      sheet.indices.insert(sheet.indices.end(), {a, a + 1, above, a + 1, above + 1, above});
    }
  }
  return sheet;
}

WeldedScene plain_sheet() {
  const Sheet sheet = make_sheet();
  GltfBuilder builder;
  const int positions = builder.add_positions(sheet.positions);
  const int indices = builder.add_array(sheet.indices, 5125, "SCALAR", 1);
  builder.add_node(
      {{"mesh", builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}})}});
  return weld(read(builder).value());
}

void expect_same(const Result<GltfScene>& scene, const WeldedScene& expected) {
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const WeldedScene welded = weld(scene.value());
  EXPECT_EQ(welded.triangles, expected.triangles);
  EXPECT_EQ(welded.vertices, expected.vertices);
  EXPECT_GT(area_vector(bake(scene.value())).z, 0.9 * kSide * kSide);
}

Bytes draco_stream(const Sheet& sheet, int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(sheet.indices.size() / 3));
  const int attribute = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t i = 0; i < sheet.indices.size(); i += 3) {
    builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(static_cast<std::uint32_t>(i / 3)),
                                      &sheet.positions[3 * sheet.indices[i]],
                                      &sheet.positions[3 * sheet.indices[i + 1]],
                                      &sheet.positions[3 * sheet.indices[i + 2]]);
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer out;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*builder.Finalize(), &out).ok());
  const auto* first = reinterpret_cast<const std::byte*>(out.data());
  return {first, first + out.size()};
}

GltfBuilder draco_model(const Bytes& stream) {
  GltfBuilder builder;
  const int view = builder.add_view(stream.data(), stream.size());
  builder.json["accessors"] = {{{"componentType", 5126}, {"count", 100}, {"type", "VEC3"}},
                               {{"componentType", 5123}, {"count", 486}, {"type", "SCALAR"}}};
  builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  const Json draco = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
  builder.add_node({{"mesh", builder.add_mesh({{"attributes", {{"POSITION", 0}}},
                                               {"indices", 1},
                                               {"extensions", {{"KHR_draco_mesh_compression", draco}}}})}});
  return builder;
}

TEST(Draco, BothMethodsGiveTheSheetBack) {
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING})
    expect_same(read(draco_model(draco_stream(make_sheet(), method))), plain_sheet());
}

TEST(Draco, TheCompressedBytesAreWhatIsDecoded) {
  const Bytes stream = draco_stream(make_sheet(), draco::MESH_EDGEBREAKER_ENCODING);
  EXPECT_EQ(read(draco_model(stream)).value().tally.decoded_bytes, stream.size());
}

TEST(Draco, StatedFacesAreLimitedBeforeTheyAreDecoded) {
  GltfOptions options;
  options.limits.max_triangles = 161;
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
    const GltfBuilder builder = draco_model(draco_stream(make_sheet(), method));
    const Result<GltfScene> scene = read(builder, options);
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().code, ErrorCode::kLimit) << scene.error().message;
  }
  // A header of 2³² − 1 faces and nothing else.
  const Bytes stream = bytes_of(std::string("DRACO\2\2\1\0\0\0\xff\xff\xff\xff\x0f\3", 17));
  const Result<GltfScene> scene = read(draco_model(stream));
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, ErrorCode::kLimit) << scene.error().message;
}

TEST(Draco, DamagedStreamsAreRefused) {
  const Bytes stream = draco_stream(make_sheet(), draco::MESH_EDGEBREAKER_ENCODING);
  for (std::size_t length = 0; length < stream.size(); length += 7) {
    Bytes cut = stream;
    cut.resize(length);
    const Result<GltfScene> scene = read(draco_model(cut));
    ASSERT_FALSE(scene.ok()) << length;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadFormat) << scene.error().message;
  }
}

TEST(Draco, AttributesThatAreNotThereAreRefused) {
  GltfBuilder builder = draco_model(draco_stream(make_sheet(), draco::MESH_EDGEBREAKER_ENCODING));
  builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]
              ["POSITION"] = 5;
  const Result<GltfScene> scene = read(builder);
  ASSERT_FALSE(scene.ok());
  EXPECT_NE(scene.error().message.find("no attribute 5"), std::string::npos) << scene.error().message;
}

Bytes encode_vertices(const void* vertices, std::size_t count, std::size_t stride) {
  Bytes out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), vertices,
                                        count, stride));
  return out;
}

Bytes encode_triangles(const Sheet& sheet) {
  Bytes out(meshopt_encodeIndexBufferBound(sheet.indices.size(), sheet.positions.size() / 3));
  out.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                       sheet.indices.data(), sheet.indices.size()));
  return out;
}

Bytes encode_sequence(const Sheet& sheet) {
  Bytes out(meshopt_encodeIndexSequenceBound(sheet.indices.size(), sheet.positions.size() / 3));
  out.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                         sheet.indices.data(), sheet.indices.size()));
  return out;
}

// Adds a compressed view whose uncompressed twin would lie in a fallback buffer without bytes.
int add_compressed(GltfBuilder& builder, const Bytes& stream, const char* extension, const Json& block) {
  const int view = builder.add_view(stream.data(), stream.size());
  Json& json = builder.json["bufferViews"][view];
  Json compressed = block;
  compressed["buffer"] = 0;
  compressed["byteOffset"] = json["byteOffset"];
  compressed["byteLength"] = stream.size();
  json = {{"buffer", 1}, {"byteLength", 100000}, {"extensions", {{extension, compressed}}}};
  builder.json["buffers"][1] = {{"byteLength", 100000}, {"extensions", {{extension, {{"fallback", true}}}}}};
  return view;
}

struct MeshoptCase {
  const char* extension = "EXT_meshopt_compression";
  const char* mode = "TRIANGLES";
  bool exponential = false;
  int index_bytes = 2;
};

GltfBuilder meshopt_model(const MeshoptCase& wanted) {
  const Sheet sheet = make_sheet();
  const std::size_t count = sheet.positions.size() / 3;
  std::vector<float> rows = sheet.positions;
  if (wanted.exponential) meshopt_encodeFilterExp(rows.data(), count, 12, 24, sheet.positions.data());
  GltfBuilder builder;
  Json attributes = {{"mode", "ATTRIBUTES"}, {"byteStride", 12}, {"count", count}};
  if (wanted.exponential) attributes["filter"] = "EXPONENTIAL";
  const int positions = builder.add_accessor(
      add_compressed(builder, encode_vertices(rows.data(), count, 12), wanted.extension, attributes), 5126,
      count, "VEC3");
  const bool triangles = wanted.mode == std::string("TRIANGLES");
  const int indices = builder.add_accessor(
      add_compressed(
          builder, triangles ? encode_triangles(sheet) : encode_sequence(sheet), wanted.extension,
          {{"mode", wanted.mode}, {"byteStride", wanted.index_bytes}, {"count", sheet.indices.size()}}),
      wanted.index_bytes == 2 ? 5123 : 5125, sheet.indices.size(), "SCALAR");
  builder.json["extensionsRequired"] = {wanted.extension};
  builder.add_node(
      {{"mesh", builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}})}});
  return builder;
}

TEST(Meshopt, EveryModeGivesTheSheetBack) {
  const WeldedScene expected = plain_sheet();
  expect_same(read(meshopt_model({})), expected);
  expect_same(read(meshopt_model({"KHR_meshopt_compression", "TRIANGLES", false, 4})), expected);
  expect_same(read(meshopt_model({"EXT_meshopt_compression", "INDICES", false, 2})), expected);
  expect_same(read(meshopt_model({"EXT_meshopt_compression", "INDICES", false, 4})), expected);
}

TEST(Meshopt, ExponentialFilterIsUndone) {
  const Result<GltfScene> scene = read(meshopt_model({"EXT_meshopt_compression", "TRIANGLES", true, 2}));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const Box box = weld(scene.value()).box;
  EXPECT_NEAR(box.size().x, kSide, 1e-5);
  EXPECT_NEAR(box.size().z, plain_sheet().box.size().z, 1e-5);
}

TEST(Meshopt, WrongBlocksAreRefused) {
  struct Case {
    const char* property;
    Json value;
    ErrorCode code;
  };
  const Case cases[] = {
      {"byteStride", 10, ErrorCode::kBadFormat},      {"byteStride", 0, ErrorCode::kBadFormat},
      {"byteStride", 260, ErrorCode::kBadFormat},     {"count", 300, ErrorCode::kBadFormat},
      {"count", ~0ull, ErrorCode::kBadFormat},        {"count", "many", ErrorCode::kBadFormat},
      {"byteLength", 5, ErrorCode::kBadFormat},       {"byteLength", 1 << 30, ErrorCode::kBadFormat},
      {"buffer", 3, ErrorCode::kBadFormat},           {"mode", "STARS", ErrorCode::kUnsupported},
      {"filter", "BLUR", ErrorCode::kUnsupported},    {"filter", "QUATERNION", ErrorCode::kBadFormat},
      {"filter", "OCTAHEDRAL", ErrorCode::kBadFormat}};
  for (const Case& wrong : cases) {
    GltfBuilder builder = meshopt_model({});
    builder.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][wrong.property] = wrong.value;
    const Result<GltfScene> scene = read(builder);
    ASSERT_FALSE(scene.ok()) << wrong.property << ' ' << wrong.value;
    EXPECT_EQ(scene.error().code, wrong.code) << scene.error().message;
  }
}

TEST(Meshopt, NewerStreamVersionsAreUnsupported) {
  const Sheet sheet = make_sheet();
  Bytes stream = encode_vertices(sheet.positions.data(), 100, 12);
  stream[0] |= std::byte{0x0f};
  GltfBuilder builder;
  const int view = add_compressed(builder, stream, "KHR_meshopt_compression",
                                  {{"mode", "ATTRIBUTES"}, {"byteStride", 12}, {"count", 100}});
  const int positions = builder.add_accessor(view, 5126, 100, "VEC3");
  builder.add_node({{"mesh", builder.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
  const Result<GltfScene> scene = read(builder);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, ErrorCode::kUnsupported) << scene.error().message;
}

}  // namespace
}  // namespace palpate::test
