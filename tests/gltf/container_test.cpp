#include <gtest/gtest.h>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/temporary_folder.h"

namespace palpate::test {
namespace {

class ContainerFile : public TemporaryFolder {};

ErrorCode code_of(const Result<GltfScene>& result) {
  EXPECT_FALSE(result.ok());
  return result.ok() ? ErrorCode::kInternal : result.error().code;
}

TEST(Container, GlbAndGltfHoldTheSame) {
  const GltfBuilder builder = triangle_builder();
  for (const Bytes& bytes : {builder.glb(), bytes_of(builder.gltf())}) {
    const Result<GltfScene> scene = read(bytes);
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(bake(scene.value()).triangles.size(), 1u);
    EXPECT_EQ(area_vector(bake(scene.value())), DVec3(0, 0, 0.5));
  }
}

TEST_F(ContainerFile, IsToldByItsContentNotItsName) {
  const GltfBuilder builder = triangle_builder();
  EXPECT_TRUE(read_gltf_file(write("binary.gltf", builder.glb()), {}).ok());
  EXPECT_TRUE(read_gltf_file(write("text.glb", builder.gltf()), {}).ok());
}

TEST_F(ContainerFile, AbsentOrNoFileIsToldByName) {
  const Result<GltfScene> absent = read_gltf_file(folder_ / "absent.glb", {});
  EXPECT_EQ(code_of(absent), ErrorCode::kFileNotFound);
  EXPECT_NE(absent.error().message.find("absent.glb"), std::string::npos);
  EXPECT_EQ(code_of(read_gltf_file(folder_, {})), ErrorCode::kFileRead);
}

TEST_F(ContainerFile, UnreadableFileIsAReadError) {
  const std::filesystem::path path = write("secret.glb", triangle_builder().glb());
  std::filesystem::permissions(path, std::filesystem::perms::none);
  constexpr uid_t kNobody = 65534;  // the superuser may read everything
  const uid_t user = ::geteuid();
  ASSERT_EQ(user == 0 ? ::seteuid(kNobody) : 0, 0);
  const Result<GltfScene> scene = read_gltf_file(path, {});
  ASSERT_EQ(::seteuid(user), 0);
  EXPECT_EQ(code_of(scene), ErrorCode::kFileRead);
}

TEST(Container, EmptyAndForeignBytesAreRefused) {
  EXPECT_EQ(code_of(read(Bytes{})), ErrorCode::kBadFormat);
  EXPECT_EQ(code_of(read(bytes_of("solid cube"))), ErrorCode::kBadFormat);
  EXPECT_EQ(code_of(read(bytes_of("[1, 2]"))), ErrorCode::kBadFormat);
  EXPECT_EQ(code_of(read(bytes_of("{}"))), ErrorCode::kBadFormat);
  EXPECT_EQ(code_of(read(bytes_of("glTF"))), ErrorCode::kBadFormat);
}

TEST(Container, WrongJsonIsToldByPlace) {
  const Result<GltfScene> cut = read(bytes_of("{\"asset\": {"));
  EXPECT_EQ(code_of(cut), ErrorCode::kBadFormat);
  EXPECT_NE(cut.error().message.find("byte 12"), std::string::npos) << cut.error().message;
  const Result<GltfScene> huge = read(bytes_of("{\"asset\": {\"version\": \"2.0\", \"extras\": 1e999}}"));
  EXPECT_EQ(code_of(huge), ErrorCode::kBadFormat);
  EXPECT_NE(huge.error().message.find("out of range"), std::string::npos) << huge.error().message;
}

TEST(Container, OtherVersionsAreUnsupported) {
  Bytes glb = triangle_builder().glb();
  glb[4] = std::byte{1};
  EXPECT_EQ(code_of(read(glb)), ErrorCode::kUnsupported);
  GltfBuilder old = triangle_builder();
  old.json["asset"]["version"] = "1.0";
  EXPECT_EQ(code_of(read(old)), ErrorCode::kUnsupported);
  GltfBuilder newer = triangle_builder();
  newer.json["asset"]["minVersion"] = "2.7";
  EXPECT_EQ(code_of(read(newer)), ErrorCode::kUnsupported);
}

TEST(Container, BufferNeedsItsChunk) {
  const GltfBuilder builder = triangle_builder();
  const Result<GltfScene> scene = read(make_glb(builder.json.dump(), {}));
  EXPECT_EQ(code_of(scene), ErrorCode::kBadFormat);
  EXPECT_NE(scene.error().message.find("buffer 0"), std::string::npos) << scene.error().message;
}

TEST(Container, EmptyChunkIsNoErrorWhenNothingNeedsIt) {
  GltfBuilder builder = triangle_builder();
  Json& buffer = builder.json["buffers"][0];
  buffer["uri"] = data_uri(builder.bin());
  Bytes glb = make_glb(builder.json.dump(), {});
  const Bytes empty_chunk = {std::byte{0},   std::byte{0},   std::byte{0},   std::byte{0},
                             std::byte{'B'}, std::byte{'I'}, std::byte{'N'}, std::byte{0}};
  glb.insert(glb.end(), empty_chunk.begin(), empty_chunk.end());
  const auto length = static_cast<std::uint32_t>(glb.size());
  std::memcpy(glb.data() + 8, &length, sizeof(length));
  EXPECT_TRUE(read(glb).ok());
}

TEST(Container, WrongJsonTypesAreRefusedByPlace) {
  struct Case {
    const char* pointer;
    Json value;
    const char* place;
  };
  const Case cases[] = {{"/accessors/0/count", "three", "accessor 0"},
                        {"/accessors/0/count", -3, "accessor 0"},
                        {"/accessors/0/byteOffset", 1.5, "accessor 0"},
                        {"/accessors/0/bufferView", 1e300, "accessor 0"},
                        {"/accessors/0/type", 3, "accessor 0"},
                        {"/accessors/0/componentType", 5124, "accessor 0"},
                        {"/accessors/0/normalized", 1, "accessor 0"},
                        {"/accessors/0/type", "VEC9", "accessor 0"},
                        {"/accessors/0/componentType", 1, "accessor 0"},
                        {"/bufferViews/0/byteStride", 6, "bufferView 0"},
                        {"/accessors", Json::object(), "accessors"},
                        {"/bufferViews/0/buffer", 4294967296, "bufferView 0"},
                        {"/buffers/0/byteLength", nullptr, "buffer 0"},
                        {"/nodes/0/mesh", "0", "node 0"},
                        {"/nodes/0/children", Json::array({0.5}), "node 0"},
                        {"/nodes/0/translation", Json::array({0, "x", 0}), "node 0"},
                        {"/nodes/0/rotation", Json::array({0, 0, 1}), "node 0"},
                        {"/nodes/0/extensions", Json::array(), "node 0"},
                        {"/nodes/0", 7, "node 0"},
                        {"/meshes/0/primitives", "all", "mesh 0"},
                        {"/meshes/0/primitives/0/attributes", Json::array(), "primitive 0"},
                        {"/meshes/0/primitives/0/attributes/POSITION", -1, "primitive 0"},
                        {"/meshes/0/primitives/0/targets", Json::array({3}), "primitive 0"},
                        {"/meshes/0/primitives/0/mode", 7, "primitive 0"},
                        {"/meshes/0/primitives/0/material", 0, "primitive 0"},
                        {"/scenes/0/nodes", Json::object(), "scene 0"},
                        {"/scene", "first", "scene"}};
  for (const Case& wrong : cases) {
    GltfBuilder builder = triangle_builder();
    builder.json[Json::json_pointer(wrong.pointer)] = wrong.value;
    const Result<GltfScene> scene = read(builder);
    ASSERT_FALSE(scene.ok()) << wrong.pointer;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadFormat) << scene.error().message;
    EXPECT_NE(scene.error().message.find(wrong.place), std::string::npos) << scene.error().message;
    EXPECT_EQ(scene.error().message.rfind("case.gltf: ", 0), 0u) << scene.error().message;
  }
}

TEST(Container, RequiredExtensionsThatChangeGeometryAreUnsupported) {
  GltfBuilder builder = triangle_builder();
  builder.json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_basisu", "KHR_lights_punctual",
                                        "EXT_texture_webp",    "KHR_xmp_json_ld",    "KHR_mesh_quantization"};
  EXPECT_TRUE(read(builder).ok());
  builder.json["extensionsRequired"].push_back("ACME_curved_triangles");
  const Result<GltfScene> scene = read(builder);
  EXPECT_EQ(code_of(scene), ErrorCode::kUnsupported);
  EXPECT_NE(scene.error().message.find("ACME_curved_triangles"), std::string::npos);
}

}  // namespace
}  // namespace palpate::test
