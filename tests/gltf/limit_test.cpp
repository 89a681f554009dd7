#include <gtest/gtest.h>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/temporary_folder.h"

namespace palpate::test {
namespace {

class FileLimit : public TemporaryFolder {};

void expect_limit(const Result<GltfScene>& scene, const char* text) {
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, ErrorCode::kLimit) << scene.error().message;
  EXPECT_NE(scene.error().message.find(text), std::string::npos) << scene.error().message;
}

TEST_F(FileLimit, BytesOfFileAndBuffersTogether) {
  const GltfBuilder embedded = triangle_builder();
  GltfOptions options;
  options.limits.max_file_bytes = embedded.glb().size();
  EXPECT_TRUE(read_gltf_file(write("a.glb", embedded.glb()), options).ok());
  --options.limits.max_file_bytes;
  expect_limit(read_gltf_file(write("a.glb", embedded.glb()), options), "bytes");

  GltfBuilder external = triangle_builder();
  external.json["buffers"][0]["uri"] = "b.bin";
  const std::string text = external.json.dump();
  write("b.bin", external.bin());
  options.limits.max_file_bytes = text.size() + external.bin().size();
  EXPECT_TRUE(read_gltf_file(write("b.gltf", text), options).ok());
  --options.limits.max_file_bytes;
  expect_limit(read_gltf_file(write("b.gltf", text), options), "b.bin");
}

TEST(Limit, TrianglesOfOneMesh) {
  GltfBuilder builder;
  const int positions = builder.add_positions(kStripQuad);
  const Json strip = {{"attributes", {{"POSITION", positions}}}, {"mode", 5}};
  builder.add_node({{"mesh", builder.add_mesh(strip)}});
  builder.json["meshes"][0]["primitives"].push_back(strip);
  GltfOptions options;
  options.limits.max_triangles = 4;
  EXPECT_TRUE(read(builder, options).ok());
  options.limits.max_triangles = 3;
  expect_limit(read(builder, options), "primitive 1");
}

TEST(Limit, TrianglesCountForEachInstance) {
  GltfBuilder builder = triangle_builder();
  builder.add_node({{"mesh", 0}});
  GltfOptions options;
  options.limits.max_triangles = 2;
  EXPECT_TRUE(read(builder, options).ok());
  builder.add_node({{"mesh", 0}});
  expect_limit(read(builder, options), "node 2");
}

// 2⁶⁰ instances in a file of a few hundred bytes.
TEST(Limit, GpuInstancesWithoutBytes) {
  GltfBuilder builder = triangle_builder();
  builder.json["accessors"].push_back({{"componentType", 5126}, {"count", 1ull << 60}, {"type", "VEC3"}});
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", 1}};
  expect_limit(read(builder), "instances");
  builder.json["accessors"][1]["count"] = 1000;
  EXPECT_TRUE(read(builder).ok());
  GltfOptions options;
  options.limits.max_triangles = 999;
  expect_limit(read(builder, options), "triangles");
}

TEST(Limit, ZerosWithoutBytes) {
  GltfBuilder builder = triangle_builder();
  builder.json["accessors"][0].erase("bufferView");
  builder.json["accessors"][0]["count"] = 3ull << 24;
  expect_limit(read(builder), "without a bufferView");
  builder.json["accessors"][0]["count"] = ~0ull;
  expect_limit(read(builder), "accessor elements");
}

// Many primitives that share a long accessor cost time, not bytes.
TEST(Limit, WorkOfAccessorsReadAgainAndAgain) {
  GltfBuilder builder = triangle_builder();
  const int indices = builder.add_indices({0, 1, 2});
  for (int i = 0; i < 2; ++i)
    builder.json["accessors"].push_back({{"componentType", 5120}, {"count", 1 << 20}, {"type", "VEC3"}});
  Json& primitives = builder.json["meshes"][0]["primitives"];
  const auto add = [&](int i) {  // in turn, so that neither stays cached
    primitives.push_back({{"attributes", {{"POSITION", 2 + i % 2}}}, {"indices", indices}});
  };
  for (int i = 0; i < 15; ++i) add(i);
  GltfOptions options;
  options.limits.max_triangles = 100;
  EXPECT_TRUE(read(builder, options).ok());
  for (int i = 15; i < 17; ++i) add(i);
  expect_limit(read(builder, options), "accessor elements");
}

TEST(Limit, NodesAndDepth) {
  GltfBuilder builder = triangle_builder();
  for (int i = 1; i < 20; ++i) builder.json["nodes"].push_back({{"children", {i - 1}}});
  builder.json["scenes"][0]["nodes"] = {19};
  GltfOptions options;
  options.limits.max_depth = 20;
  options.limits.max_nodes = 20;
  EXPECT_TRUE(read(builder, options).ok());
  options.limits.max_depth = 19;
  expect_limit(read(builder, options), "deeper than 19");
  options.limits.max_depth = 20;
  options.limits.max_nodes = 19;
  expect_limit(read(builder, options), "20 nodes");
}

TEST(Limit, LongChainsOfNodesDoNotOverflowTheStack) {
  GltfBuilder builder = triangle_builder();
  constexpr int kLength = 200'000;
  for (int i = 1; i < kLength; ++i) builder.json["nodes"].push_back({{"children", {i - 1}}});
  builder.json["scenes"][0]["nodes"] = {kLength - 1};
  expect_limit(read(builder), "deeper than 1000");
  GltfOptions options;
  options.limits.max_depth = kLength;
  EXPECT_TRUE(read(builder, options).ok());
}

TEST(Limit, DeepJsonDoesNotOverflowTheStack) {
  const std::string text = triangle_builder().gltf();
  for (const char* open : {"[", "{\"a\":"}) {
    std::string deep = text.substr(0, text.size() - 1) + ",\"extras\":";
    for (int i = 0; i < 1'000'000; ++i) deep += open;
    expect_limit(read(bytes_of(deep)), "nests deeper");
  }
  const std::string brackets =
      text.substr(0, text.size() - 1) + ",\"extras\":\"" + std::string(1000, '[') + "\\\"\"}";
  EXPECT_TRUE(read(bytes_of(brackets)).ok());  // in a string they nest nothing
}

}  // namespace
}  // namespace palpate::test
