#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

// One triangle, its nine floats and three shorts in a data URI.
constexpr const char* kTriangle = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                 "min": [0, 0, 0], "max": [1, 1, 0]}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"byteLength": 36, "uri":
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

plp_result load(const std::string& gltf, const plp_model_options* options = nullptr) {
  plp_model model = nullptr;
  const plp_result result = plp_model_load_memory(gltf.data(), gltf.size(), nullptr, options, &model);
  EXPECT_EQ(model != nullptr, result == PLP_OK);
  plp_model_release(model);
  return result;
}

plp_result load_file(const std::filesystem::path& path) {
  plp_model model = nullptr;
  const plp_result result = plp_model_load_file(path.string().c_str(), nullptr, &model);
  plp_model_release(model);
  return result;
}

class LoadTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      ("palpate_load_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(LoadTest, TriangleFromBytes) {
  EXPECT_EQ(load(kTriangle), PLP_OK) << plp_last_error();
}

TEST_F(LoadTest, TriangleFromAFileWithAUtf8Name) {
  const auto path = folder_ / std::filesystem::path(u8"дом ☃.gltf");
  std::ofstream(path) << kTriangle;
  EXPECT_EQ(load_file(path), PLP_OK) << plp_last_error();
}

TEST_F(LoadTest, EachErrorHasItsCodeAndNamesTheFile) {
  EXPECT_EQ(load_file(folder_ / "missing.glb"), PLP_ERROR_FILE_NOT_FOUND);
  EXPECT_NE(std::string(plp_last_error()).find("missing.glb"), std::string::npos) << plp_last_error();
  EXPECT_EQ(load_file(folder_), PLP_ERROR_FILE_READ) << plp_last_error();
}

TEST_F(LoadTest, BadFormat) {
  EXPECT_EQ(load("this is no glTF"), PLP_ERROR_BAD_FORMAT);
  EXPECT_EQ(load(""), PLP_ERROR_BAD_FORMAT);
}

TEST_F(LoadTest, Unsupported) {
  EXPECT_EQ(
      load(replaced(kTriangle, "\"scene\": 0", "\"extensionsRequired\": [\"ACME_unknown\"], \"scene\": 0")),
      PLP_ERROR_UNSUPPORTED);
}

TEST_F(LoadTest, NoTriangles) {
  EXPECT_EQ(load(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{}]})"), PLP_ERROR_NO_TRIANGLES);
}

TEST_F(LoadTest, UnsafePath) {
  const std::string outside = replaced(
      kTriangle, "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA",
      "../outside.bin");
  const auto path = folder_ / "unsafe.gltf";
  std::ofstream(path) << outside;
  EXPECT_EQ(load_file(path), PLP_ERROR_UNSAFE_PATH) << plp_last_error();
}

TEST_F(LoadTest, NonFinite) {
  // The first float becomes 0x7fc00000: NaN.
  EXPECT_EQ(load(replaced(kTriangle, "base64,AAAAAAAA", "base64,AADAfwAA")), PLP_ERROR_NON_FINITE);
}

TEST_F(LoadTest, Options) {
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.gltf_scene = 0;
  EXPECT_EQ(load(kTriangle, &options), PLP_OK);
  options.gltf_scene = 1;
  EXPECT_EQ(load(kTriangle, &options), PLP_ERROR_INVALID_ARGUMENT);
  options.gltf_scene = -1;
  options.max_triangles = 1;
  EXPECT_EQ(load(kTriangle, &options), PLP_OK);
}

plp_model_info info_of(const std::string& gltf, double scale) {
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.scale = scale;
  plp_model model = nullptr;
  EXPECT_EQ(plp_model_load_memory(gltf.data(), gltf.size(), nullptr, &options, &model), PLP_OK)
      << plp_last_error();
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  EXPECT_EQ(plp_model_get_info(model, &info), PLP_OK);
  plp_model_release(model);
  return info;
}

TEST_F(LoadTest, ScaleMultipliesPositions) {
  const plp_model_info one = info_of(kTriangle, 1.0), more = info_of(kTriangle, 3.0);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(more.bounds_max[i], 3.0 * one.bounds_max[i]);
  EXPECT_EQ(info_of(kTriangle, 0.0).diagonal, one.diagonal) << "what an older program leaves zero is 1";
}

TEST_F(LoadTest, BytesReadAndDecodedAreTold) {
  const plp_model_info info = info_of(kTriangle, 1.0);
  EXPECT_EQ(info.read_bytes, std::string(kTriangle).size());
  EXPECT_EQ(info.decoded_bytes, 36u);
}

// A program with the first version's header gives and gets shorter structs.
TEST_F(LoadTest, StructsOfTheFirstVersionAreUnderstood) {
  plp_model_options options;
  plp_model_options_init(&options, offsetof(plp_model_options, scale));
  EXPECT_EQ(load(kTriangle, &options), PLP_OK) << plp_last_error();
  plp_model model = nullptr;
  ASSERT_EQ(plp_model_load_memory(kTriangle, std::string(kTriangle).size(), nullptr, nullptr, &model),
            PLP_OK);
  plp_model_info info;
  std::memset(&info, 0xAB, sizeof info);
  plp_model_info_init(&info, offsetof(plp_model_info, read_bytes));
  EXPECT_EQ(plp_model_get_info(model, &info), PLP_OK);
  EXPECT_EQ(info.read_bytes, 0xABABABABABABABABu) << "is beyond the end of the caller's struct";
  plp_model_release(model);
}

TEST_F(LoadTest, RealModels) {
  const char* data = std::getenv("PALPATE_DATA");
  if (!data) GTEST_SKIP() << "skipped: PALPATE_DATA";
  plp_model model = nullptr;
  ASSERT_EQ(plp_model_load_file((std::string(data) + "/gear_6k.glb").c_str(), nullptr, &model), PLP_OK)
      << plp_last_error();
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  ASSERT_EQ(plp_model_get_info(model, &info), PLP_OK);
  EXPECT_GT(info.source.triangles, 5000u);
  EXPECT_GT(info.load_us, 0.0);
  plp_model_release(model);
}

}  // namespace
}  // namespace palpate::test
