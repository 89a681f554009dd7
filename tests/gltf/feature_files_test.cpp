#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

#include "engine/gltf/gltf_file.h"
#include "tests/gltf/welded_scene.h"

namespace palpate::test {
namespace {

std::filesystem::path feature_folder() {
  const char* data = std::getenv("PALPATE_DATA");
  return data == nullptr ? std::filesystem::path() : std::filesystem::path(data) / "gltf-features";
}

struct FeatureFile {
  const char* path;
  std::size_t triangles;
  std::size_t vertices;  // welded
  DVec3 box;
};

void PrintTo(const FeatureFile& file, std::ostream* out) {
  *out << file.path;
}

class FeatureFiles : public ::testing::TestWithParam<FeatureFile> {};

// The boxes are stated to five digits.
TEST_P(FeatureFiles, HaveTheStatedGeometry) {
  if (feature_folder().empty()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const FeatureFile& file = GetParam();
  const Result<GltfScene> scene = read_gltf_file(feature_folder() / file.path, {});
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const WeldedScene welded = weld(scene.value());
  EXPECT_EQ(welded.triangles, file.triangles);
  EXPECT_EQ(welded.vertices.size(), file.vertices);
  const DVec3 size = welded.box.size();
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(size[axis], file.box[axis], 1e-4 * file.box[axis] + 1e-6) << axis;
}

INSTANTIATE_TEST_SUITE_P(
    Gltf, FeatureFiles,
    ::testing::Values(FeatureFile{"TriangleWithoutIndices.gltf", 1, 3, {1, 1, 0}},
                      FeatureFile{"SimpleSparseAccessor/SimpleSparseAccessor.gltf", 12, 14, {6, 4, 0}},
                      FeatureFile{"MultipleScenes.gltf", 2, 4, {1, 1, 0}},
                      FeatureFile{"MeshPrimitiveModes.gltf", 16, 20, {5.732, 2, 0}},
                      FeatureFile{"Mesh_PrimitiveMode/Mesh_PrimitiveMode_04.gltf", 2, 4, {1, 1, 0}},
                      FeatureFile{"Mesh_PrimitiveMode/Mesh_PrimitiveMode_12.gltf", 2, 4, {1, 1, 0}},
                      FeatureFile{"Mesh_PrimitiveMode/Mesh_PrimitiveMode_14.gltf", 2, 4, {1, 1, 0}},
                      FeatureFile{"BoxInterleaved.glb", 12, 8, {1, 1, 1}},
                      FeatureFile{"CesiumMilkTruck.glb", 3624, 1840, {4.8689, 2.5829, 2.792}},
                      FeatureFile{"2CylinderEngine.glb", 121496, 60040, {743.38, 273.01, 268}},
                      FeatureFile{"ingenuity/ingenuity.gltf", 9060, 4900, {0.98637, 0.56206, 1.1064}},
                      FeatureFile{"nested.glb", 36, 24, {1.4364, 3.3366, 0.53876}},
                      FeatureFile{"mirror/one_face_123_mirror.gltf", 1, 3, {2, 0.099982, 0}},
                      FeatureFile{"simple_skin.gltf", 8, 10, {1, 2, 0}},
                      FeatureFile{"AnimatedMorphCube/AnimatedMorphCube.gltf", 12, 8, {2, 2, 2}},
                      FeatureFile{"UnlitTest/UnlitTest.gltf", 88, 48, {4.4, 2, 2}},
                      FeatureFile{"duck_quantized.glb", 4212, 2108, {1.6548, 1.5404, 1.1526}},
                      FeatureFile{"Box_Draco.glb", 12, 8, {1, 1, 1}},
                      FeatureFile{"pirate_meshopt.glb", 5010, 2660, {1.52109, 1.90505, 0.455245}}));

struct FaultyFile {
  const char* path;
  ErrorCode code;
  const char* place;
};

void PrintTo(const FaultyFile& file, std::ostream* out) {
  *out << file.path;
}

class FaultyFiles : public ::testing::TestWithParam<FaultyFile> {};

TEST_P(FaultyFiles, AreToldApart) {
  if (feature_folder().empty()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const FaultyFile& file = GetParam();
  const Result<GltfScene> scene = read_gltf_file(feature_folder() / file.path, {});
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, file.code) << scene.error().message;
  EXPECT_NE(scene.error().message.find(file.path), std::string::npos) << scene.error().message;
  EXPECT_NE(scene.error().message.find(file.place), std::string::npos) << scene.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    Gltf, FaultyFiles,
    ::testing::Values(FaultyFile{"Mesh_PrimitiveMode/Mesh_PrimitiveMode_00.gltf", ErrorCode::kNoTriangles,
                                 "points or lines: 1"},
                      FaultyFile{"IndexOutOfRange/IndexOutOfRange.gltf", ErrorCode::kBadFormat,
                                 "mesh 0 primitive 0"},
                      FaultyFile{"BoxWithInfinites.glb", ErrorCode::kNonFinite, "mesh 0 primitive 0: vertex"},
                      FaultyFile{"MissingBin/BoxTextured.gltf", ErrorCode::kFileNotFound, "BoxTextured0.bin"},
                      FaultyFile{"invalid-buffer-view-index.gltf", ErrorCode::kNoTriangles, "scene"}));

}  // namespace
}  // namespace palpate::test
