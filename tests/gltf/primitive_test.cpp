#include <gtest/gtest.h>

#include <limits>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/welded_scene.h"

namespace palpate::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// A mesh of one primitive whose JSON is `primitive`, shown by one node.
Result<GltfScene> read_primitive(GltfBuilder builder, const Json& primitive) {
  builder.add_node({{"mesh", builder.add_mesh(primitive)}});
  return read(builder);
}

TriangleSoup baked(const Result<GltfScene>& scene) {
  EXPECT_TRUE(scene.ok()) << scene.error().message;
  return scene.ok() ? bake(scene.value()) : TriangleSoup{};
}

void expect_error(const Result<GltfScene>& scene, ErrorCode code, const char* text) {
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, code) << scene.error().message;
  EXPECT_NE(scene.error().message.find(text), std::string::npos) << scene.error().message;
}

TEST(Primitive, StripAlternatesAndKeepsTheWinding) {
  GltfBuilder builder;
  const int positions = builder.add_positions(kStripQuad);
  const TriangleSoup soup =
      baked(read_primitive(builder, {{"attributes", {{"POSITION", positions}}}, {"mode", 5}}));
  const std::vector<TriangleIndices> expected = {{0, 1, 2}, {1, 3, 2}};
  EXPECT_EQ(soup.triangles, expected);
  EXPECT_EQ(area_vector(soup), DVec3(0, 0, 1));
}

TEST(Primitive, FanTurnsAroundItsFirstVertex) {
  GltfBuilder builder;
  const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const TriangleSoup soup =
      baked(read_primitive(builder, {{"attributes", {{"POSITION", positions}}}, {"mode", 6}}));
  const std::vector<TriangleIndices> expected = {{1, 2, 0}, {2, 3, 0}};
  EXPECT_EQ(soup.triangles, expected);
  EXPECT_EQ(area_vector(soup), DVec3(0, 0, 1));
}

TEST(Primitive, PointsAndLinesAreSkippedWithANote) {
  for (const int mode : {0, 1, 2, 3}) {
    GltfBuilder builder = triangle_builder();
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    const Result<GltfScene> scene = read(builder);
    EXPECT_EQ(baked(scene).triangles.size(), 1u);
    ASSERT_EQ(scene.value().notes.size(), 1u);
    EXPECT_NE(scene.value().notes[0].find("mesh 0 primitive 1"), std::string::npos);
    builder.json["meshes"][0]["primitives"].erase(0);
    expect_error(read(builder), ErrorCode::kNoTriangles, "points or lines: 1");
  }
}

template <class T>
class IndexType : public ::testing::Test {};
using IndexTypes = ::testing::Types<std::uint8_t, std::uint16_t, std::uint32_t>;
TYPED_TEST_SUITE(IndexType, IndexTypes);

template <class T>
constexpr int kIndexComponent = sizeof(T) == 1   ? 5121
                                : sizeof(T) == 2 ? 5123
                                                 : 5125;

template <class T>
Result<GltfScene> read_indexed(const std::vector<T>& indices) {
  GltfBuilder builder;
  const int positions = builder.add_positions(kStripQuad);
  const int accessor = builder.add_array(indices, kIndexComponent<T>, "SCALAR", 1);
  return read_primitive(builder, {{"attributes", {{"POSITION", positions}}}, {"indices", accessor}});
}

TYPED_TEST(IndexType, IsRead) {
  const TriangleSoup soup = baked(read_indexed<TypeParam>({0, 1, 2, 2, 1, 3}));
  const std::vector<TriangleIndices> expected = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_EQ(soup.triangles, expected);
}

TYPED_TEST(IndexType, OutOfRangeOrRestartIsRefused) {
  expect_error(read_indexed<TypeParam>({0, 1, 4}), ErrorCode::kBadFormat,
               "index 4 is past the last vertex 3");
  expect_error(read_indexed<TypeParam>({0, 1, std::numeric_limits<TypeParam>::max()}), ErrorCode::kBadFormat,
               "restart");
}

TEST(Primitive, StrideAndOffsetsAreHonoured) {
  GltfBuilder builder;
  const std::vector<float> rows = {9, 9, 0, 0, 0, 7, 1,
                                   0, 0, 7, 0, 1, 0, 7};  // two floats, then rows of four
  const int view = builder.add_view(rows.data(), rows.size() * sizeof(float), 16);
  const int positions = builder.add_accessor(view, 5126, 3, "VEC3");
  builder.json["accessors"][positions]["byteOffset"] = 8;
  const Json primitive = {{"attributes", {{"POSITION", positions}}}};
  EXPECT_EQ(area_vector(baked(read_primitive(builder, primitive))), DVec3(0, 0, 0.5));

  builder.json["accessors"][positions]["byteOffset"] = 20;  // the last element ends at 64 of 56 bytes
  expect_error(read_primitive(builder, primitive), ErrorCode::kBadFormat, "bufferView");
  builder.json["bufferViews"][view]["byteStride"] = 8;
  expect_error(read_primitive(builder, primitive), ErrorCode::kBadFormat, "stride 8");
}

TEST(Primitive, SparseValuesReplaceElements) {
  for (const bool with_view : {true, false}) {
    GltfBuilder builder;
    const std::vector<float> base = {0, 0, 0, 0, 0, 0, 0, 2, 0};
    const int positions = builder.add_positions(base);
    const std::vector<std::uint8_t> rows = {1, 2};
    const std::vector<float> values = {1, 0, 0, 0, 1, 0};
    const int row_view = builder.add_view(rows.data(), rows.size());
    const int value_view = builder.add_view(values.data(), values.size() * sizeof(float));
    Json& accessor = builder.json["accessors"][positions];
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", row_view}, {"componentType", 5121}}},
                          {"values", {{"bufferView", value_view}}}};
    if (!with_view) accessor.erase("bufferView");
    const Json primitive = {{"attributes", {{"POSITION", positions}}}};
    EXPECT_EQ(area_vector(baked(read_primitive(builder, primitive))), DVec3(0, 0, 0.5));
    accessor["count"] = 2;
    expect_error(read_primitive(builder, primitive), ErrorCode::kBadFormat, "sparse index 2");
  }
}

TEST(Primitive, SparseIndicesNeedNoView) {
  GltfBuilder builder;
  const int positions = builder.add_positions(kTriangle);
  const std::vector<std::uint16_t> corners = {1, 2};
  const int view = builder.add_view(corners.data(), 4);
  builder.json["accessors"].push_back({{"componentType", 5123},
                                       {"count", 3},
                                       {"type", "SCALAR"},
                                       {"sparse",
                                        {{"count", 2},
                                         {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                                         {"values", {{"bufferView", view}}}}}});
  const TriangleSoup soup =
      baked(read_primitive(builder, {{"attributes", {{"POSITION", positions}}}, {"indices", positions + 1}}));
  const std::vector<TriangleIndices> expected = {{0, 1, 2}};
  EXPECT_EQ(soup.triangles, expected);
}

TEST(Primitive, AccessorWithoutViewIsZero) {
  GltfBuilder builder = triangle_builder();
  builder.json["accessors"][0].erase("bufferView");
  const TriangleSoup soup = baked(read(builder));
  ASSERT_EQ(soup.triangles.size(), 1u);
  for (const DVec3& position : soup.positions) EXPECT_EQ(position, DVec3(0.0));
}

template <class T>
DVec3 quantized_far_corner(int component_type, T value, bool normalized) {
  GltfBuilder builder;
  const int positions = builder.add_array(std::vector<T>{0, 0, 0, 0, value, 0, 0, 0, 0, value, 0, 0},
                                          component_type, "VEC3", 4);
  builder.json["bufferViews"][0]["byteStride"] = 4 * sizeof(T);
  builder.json["accessors"][positions]["normalized"] = normalized;
  builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const TriangleSoup soup = baked(read_primitive(builder, {{"attributes", {{"POSITION", positions}}}}));
  return soup.positions.empty() ? DVec3(-9.0) : soup.positions[1] + soup.positions[2];
}

TEST(Primitive, QuantizedPositions) {
  EXPECT_EQ(quantized_far_corner<std::int8_t>(5120, -100, false), DVec3(-100, -100, 0));
  EXPECT_EQ(quantized_far_corner<std::int8_t>(5120, -128, true), DVec3(-1, -1, 0));  // clamped
  EXPECT_EQ(quantized_far_corner<std::int8_t>(5120, 127, true), DVec3(1, 1, 0));
  EXPECT_EQ(quantized_far_corner<std::uint8_t>(5121, 200, false), DVec3(200, 200, 0));
  EXPECT_EQ(quantized_far_corner<std::uint8_t>(5121, 51, true), DVec3(0.2, 0.2, 0));
  EXPECT_EQ(quantized_far_corner<std::int16_t>(5122, -30000, false), DVec3(-30000, -30000, 0));
  EXPECT_EQ(quantized_far_corner<std::int16_t>(5122, 32767, true), DVec3(1, 1, 0));
  EXPECT_EQ(quantized_far_corner<std::uint16_t>(5123, 40000, false), DVec3(40000, 40000, 0));
  EXPECT_EQ(quantized_far_corner<std::uint16_t>(5123, 13107, true), DVec3(0.2, 0.2, 0));
}

TEST(Primitive, LongSharedAccessorIsCutToWhatIsUsed) {
  GltfBuilder builder;
  std::vector<float> many(3 * 1000, kNaN);  // of which the triangle uses none
  many.insert(many.end(), kTriangle.begin(), kTriangle.end());
  const int positions = builder.add_positions(many);
  const int indices = builder.add_indices({1002, 1000, 1001});
  const TriangleSoup soup =
      baked(read_primitive(builder, {{"attributes", {{"POSITION", positions}}}, {"indices", indices}}));
  EXPECT_EQ(soup.positions.size(), 3u);
  EXPECT_EQ(area_vector(soup), DVec3(0, 0, 0.5));
}

TEST(Primitive, NonFinitePositionsAreToldByVertex) {
  for (const float bad : {kNaN, std::numeric_limits<float>::infinity()}) {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, bad, 0, 0, 1, 0});
    expect_error(read_primitive(builder, {{"attributes", {{"POSITION", positions}}}}), ErrorCode::kNonFinite,
                 "mesh 0 primitive 0: vertex 1");
  }
}

TEST(Primitive, DoubleSidedComesFromTheMaterial) {
  GltfBuilder builder = triangle_builder();
  EXPECT_TRUE(baked(read(builder)).double_sided.empty());
  builder.json["materials"] = {{{"doubleSided", true}, {"name", 5}, {"pbrMetallicRoughness", "wrong"}},
                               Json::object()};
  Json& primitives = builder.json["meshes"][0]["primitives"];
  for (const int material : {0, 1}) {
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"material", material}});
  }
  const std::vector<bool> expected = {false, true, false};
  EXPECT_EQ(baked(read(builder)).double_sided, expected);
}

TEST(Primitive, WrongReferencesAreRefused) {
  struct Case {
    const char* pointer;
    Json value;
  };
  const Case cases[] = {{"/meshes/0/primitives/0/attributes/POSITION", 1},
                        {"/meshes/0/primitives/0/indices", 9},
                        {"/accessors/0/bufferView", 1},
                        {"/bufferViews/0/buffer", 1},
                        {"/bufferViews/0/byteLength", 37},
                        {"/accessors/0/count", 4},
                        {"/accessors/0/type", "VEC2"},
                        {"/accessors/0/componentType", 5125},
                        {"/nodes/0/mesh", 1},
                        {"/accessors/0/byteOffset", ~0ull},
                        {"/bufferViews/0/byteOffset", ~0ull},
                        {"/accessors/0/count", 1ull << 62}};
  for (const Case& wrong : cases) {
    GltfBuilder builder = triangle_builder();
    builder.json[Json::json_pointer(wrong.pointer)] = wrong.value;
    const Result<GltfScene> scene = read(builder);
    ASSERT_FALSE(scene.ok()) << wrong.pointer;
    const ErrorCode expected = wrong.value == Json(1ull << 62) ? ErrorCode::kLimit : ErrorCode::kBadFormat;
    EXPECT_EQ(scene.error().code, expected) << scene.error().message;
  }
}

}  // namespace
}  // namespace palpate::test
