#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/gltf/gltf_builder.h"

namespace palpate::test {
namespace {

// Small, so that no mutation asks for much.
GltfOptions small_limits() {
  GltfOptions options;
  options.limits.max_file_bytes = 16u << 20;
  options.limits.max_triangles = 100'000;
  options.limits.max_nodes = 1'000;
  return options;
}

// A success must be sound: a caller indexes with what it holds.
void expect_sound(const GltfScene& scene) {
  for (const TriangleSoup& mesh : scene.meshes) {
    ASSERT_TRUE(mesh.double_sided.empty() || mesh.double_sided.size() == mesh.triangles.size());
    for (const TriangleIndices& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.positions.size());
    }
    for (const DVec3& p : mesh.positions)
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  for (const GltfInstance& instance : scene.instances) ASSERT_LT(instance.mesh, scene.meshes.size());
  ASSERT_FALSE(bake(scene).triangles.empty());
}

void expect_error_or_sound(const Bytes& bytes) {
  const Result<GltfScene> scene = read(bytes, small_limits());
  if (scene.ok()) {
    expect_sound(scene.value());
  } else {
    ASSERT_EQ(scene.error().message.rfind("case.gltf: ", 0), 0u) << scene.error().message;
  }
}

// A model that uses nearly all there is: two nodes, indices, sparse values, a morph target, instances, a
// skin.
GltfBuilder rich_model() {
  GltfBuilder builder;
  const int positions = builder.add_positions(kStripQuad);
  const int indices = builder.add_indices({0, 1, 2, 2, 1, 3});
  const int offsets = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int joints = builder.add_array(std::vector<std::uint8_t>(16, 0), 5121, "VEC4", 4);
  const int weights = builder.add_array(std::vector<float>(16, 0.25f), 5126, "VEC4", 4);
  const int places = builder.add_positions({0, 0, 0, 5, 0, 0});
  const std::vector<std::uint16_t> rows = {3};
  builder.json["accessors"][positions]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", builder.add_view(rows.data(), 2)}, {"componentType", 5123}}},
      {"values", {{"bufferView", builder.add_view(kStripQuad.data(), 12)}}}};
  builder.add_mesh({{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                    {"indices", indices},
                    {"material", 0},
                    {"targets", {{{"POSITION", offsets}}}}});
  builder.json["meshes"][0]["weights"] = {0.5};
  builder.json["materials"] = {{{"doubleSided", true}}};
  builder.json["skins"] = {{{"joints", {0}}}};
  const Json instancing = {{"attributes", {{"TRANSLATION", places}}}};
  builder.add_node({{"mesh", 0},
                    {"rotation", {0, 0, 0, 1}},
                    {"children", {1}},
                    {"extensions", {{"EXT_mesh_gpu_instancing", instancing}}}});
  builder.json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
  return builder;
}

TEST(Hostile, TheModelToMutateIsValid) {
  const Result<GltfScene> scene = read(rich_model(), small_limits());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(bake(scene.value()).triangles.size(), 6u);
}

TEST(Hostile, EveryTruncationIsAnError) {
  const Bytes glb = rich_model().glb();
  for (std::size_t length = 0; length < glb.size(); ++length) {
    const Bytes cut(glb.begin(), glb.begin() + static_cast<std::ptrdiff_t>(length));
    ASSERT_FALSE(read(cut, small_limits()).ok()) << length;
  }
}

// Cuts the chunk, too: the header's lengths fit what is left.
TEST(Hostile, ShortenedBuffersNeverCrash) {
  const GltfBuilder builder = rich_model();
  for (std::size_t length = 0; length < builder.bin().size(); ++length) {
    const Bytes bin(builder.bin().begin(), builder.bin().begin() + static_cast<std::ptrdiff_t>(length));
    expect_error_or_sound(make_glb(builder.json.dump(), bin));
    GltfBuilder honest = builder;
    honest.json["buffers"][0]["byteLength"] = length;
    ASSERT_FALSE(read(make_glb(honest.json.dump(), bin), small_limits()).ok()) << length;
  }
}

void flip_bytes(Bytes& bytes, std::uint32_t seed) {
  std::mt19937 random(seed);
  const int flips = 1 + static_cast<int>(random() % 4);
  for (int i = 0; i < flips; ++i)
    bytes[random() % bytes.size()] ^= static_cast<std::byte>(1 + random() % 255);
}

TEST(Hostile, FlippedBytesNeverCrash) {
  const Bytes glb = rich_model().glb();
  for (std::uint32_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    Bytes mutated = glb;
    flip_bytes(mutated, seed);
    expect_error_or_sound(mutated);
    if (HasFatalFailure()) return;
  }
}

// Replaces one number of the document by an extreme one: the JSON stays valid, so that all of it reaches the
// readers.
TEST(Hostile, ExtremeNumbersNeverCrash) {
  const GltfBuilder builder = rich_model();
  const Json flat = builder.json.flatten();
  const Json extremes = {0,
                         1,
                         2,
                         3,
                         255,
                         65535,
                         2147483647,
                         2147483648,
                         4294967295,
                         9223372036854775807,
                         18446744073709551615u,
                         -1,
                         0.5,
                         1e300,
                         -1e300,
                         nullptr,
                         "x",
                         true,
                         Json::array(),
                         Json::object()};
  for (const auto& [pointer, value] : flat.items()) {
    for (const Json& extreme : extremes) {
      SCOPED_TRACE(pointer + " = " + extreme.dump());
      GltfBuilder mutated = builder;
      mutated.json[Json::json_pointer(pointer)] = extreme;
      expect_error_or_sound(mutated.glb());
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Hostile, MissingPropertiesNeverCrash) {
  const GltfBuilder builder = rich_model();
  const Json flat = builder.json.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    SCOPED_TRACE(pointer);
    const Json::json_pointer at(pointer);
    GltfBuilder mutated = builder;
    Json& parent = mutated.json[at.parent_pointer()];
    if (parent.is_object()) {
      parent.erase(at.back());
    } else {
      parent.erase(std::stoul(at.back()));
    }
    expect_error_or_sound(mutated.glb());
    if (HasFatalFailure()) return;
  }
}

Bytes file_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return bytes_of(text);
}

// Compressed files, whose bytes go through Draco and meshoptimizer.
TEST(Hostile, FlippedBytesOfCompressedFilesNeverCrash) {
  const char* data = std::getenv("PALPATE_DATA");
  if (data == nullptr) GTEST_SKIP() << "skipped: PALPATE_DATA";
  for (const char* name :
       {"Box_Draco.glb", "pirate_meshopt.glb", "duck_quantized.glb", "BoxInterleaved.glb"}) {
    const Bytes glb = file_bytes(std::filesystem::path(data) / "gltf-features" / name);
    ASSERT_TRUE(read(glb, small_limits()).ok()) << name;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
      SCOPED_TRACE(name + std::string(" ") + std::to_string(seed));
      Bytes mutated = glb;
      flip_bytes(mutated, seed);
      expect_error_or_sound(mutated);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace palpate::test
