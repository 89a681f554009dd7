// A load tells how many bytes it read and decoded: of images and animations, none.
#include <gtest/gtest.h>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/temporary_folder.h"

namespace palpate::test {
namespace {

constexpr std::uint64_t kPositionBytes = 36;
constexpr std::uint64_t kIndexBytes = 6;

// An indexed triangle with normals and an animation in the same buffer, and an image in a file or there, too.
struct Scene {
  GltfBuilder builder;
  int image_view = 0;

  Scene() {
    const int positions = builder.add_positions(kTriangle);
    const int indices = builder.add_indices({0, 1, 2});
    const int normals = builder.add_positions(kTriangle);
    builder.add_node(
        {{"mesh", builder.add_mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                                    {"indices", indices}})}});
    const Bytes pixels(1000, std::byte{7});
    image_view = builder.add_view(pixels.data(), pixels.size());
    const int times = builder.add_array(std::vector<float>(50), 5126, "SCALAR", 1);
    const int places = builder.add_array(std::vector<float>(150), 5126, "VEC3", 3);
    builder.json["images"] = {{{"bufferView", image_view}, {"mimeType", "image/png"}}};
    builder.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", places}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  }
};

class Tally : public TemporaryFolder {};

TEST_F(Tally, OfAFileIsAllItsBytesAndWhatItsTrianglesNeed) {
  const Bytes glb = Scene().builder.glb();
  const auto scene = read_gltf_file(write("model.glb", glb), {});
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().tally.read_bytes, glb.size());
  EXPECT_EQ(scene.value().tally.decoded_bytes, kPositionBytes + kIndexBytes);
  const auto in_memory = read(glb);
  EXPECT_EQ(in_memory.value().tally.read_bytes, glb.size());
}

// The image's view and the animation's are in buffers of their own.
TEST_F(Tally, FilesOfImagesAndAnimationsAreNeverOpened) {
  Scene scene;
  Json& json = scene.builder.json;
  json["buffers"][0]["uri"] = "triangle.bin";
  for (const char* uri : {"pixels.bin", "motion.bin"})
    json["buffers"].push_back({{"uri", uri}, {"byteLength", 4000}});
  json["bufferViews"][static_cast<std::size_t>(scene.image_view)] = {{"buffer", 1}, {"byteLength", 1000}};
  for (std::size_t view = static_cast<std::size_t>(scene.image_view) + 1; view < json["bufferViews"].size();
       ++view)
    json["bufferViews"][view]["buffer"] = 2;
  json["images"].push_back({{"uri", "picture.png"}});
  const std::string text = json.dump();
  const auto path = write("model.gltf", text);
  write("triangle.bin", scene.builder.bin());

  const auto read = [&] { return read_gltf_file(path, {}); };
  ASSERT_TRUE(read()) << read().error().message << ": the other files are not there";
  for (const char* other : {"pixels.bin", "motion.bin", "picture.png"}) write(other, Bytes(4000));
  EXPECT_EQ(read().value().tally.read_bytes, text.size() + scene.builder.bin().size());
  EXPECT_EQ(read().value().tally.decoded_bytes, kPositionBytes + kIndexBytes);
}

TEST_F(Tally, CountsWhatSparseAccessorsChange) {
  GltfBuilder builder = triangle_builder();
  const std::uint64_t plain = read(builder).value().tally.decoded_bytes;
  const std::vector<std::uint16_t> row = {1};
  const std::vector<float> place = {2, 0, 0};
  const int rows = builder.add_view(row.data(), 2), places = builder.add_view(place.data(), 12);
  builder.json["accessors"][0]["sparse"] = {{"count", 1},
                                            {"indices", {{"bufferView", rows}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", places}}}};
  EXPECT_EQ(read(builder).value().tally.decoded_bytes, plain + 2 + 12);
}

// A mesh that many nodes show is decoded once.
TEST_F(Tally, OfASharedMeshIsCountedOnce) {
  GltfBuilder builder = triangle_builder();
  const std::uint64_t once = read(builder).value().tally.decoded_bytes;
  for (int i = 0; i < 9; ++i) builder.add_node({{"mesh", 0}});
  ASSERT_EQ(read(builder).value().instances.size(), 10u);
  EXPECT_EQ(read(builder).value().tally.decoded_bytes, once);
}

}  // namespace
}  // namespace palpate::test
