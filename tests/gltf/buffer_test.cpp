#include <gtest/gtest.h>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/temporary_folder.h"

namespace palpate::test {
namespace {

class ExternalBuffer : public TemporaryFolder {
 protected:
  // A model in folder "model" whose buffer is at `uri`.
  Result<GltfScene> read_with(const std::string& uri) const {
    GltfBuilder builder = triangle_builder();
    builder.json["buffers"][0]["uri"] = uri;
    return read_gltf_file(write("model/model.gltf", builder.json.dump()), {});
  }

  void expect_error(const std::string& uri, ErrorCode code) const {
    const Result<GltfScene> scene = read_with(uri);
    ASSERT_FALSE(scene.ok()) << uri;
    EXPECT_EQ(scene.error().code, code) << scene.error().message;
    EXPECT_NE(scene.error().message.find("buffer 0"), std::string::npos) << scene.error().message;
  }

  Bytes data_ = triangle_builder().bin();
};

TEST_F(ExternalBuffer, ComesFromTheFolderOrBelow) {
  write("model/a.bin", data_);
  write("model/deep/er/b c%.bin", data_);
  write("model/ü.bin", data_);
  for (const char* uri : {"a.bin", "./a.bin", "deep/er/b%20c%25.bin", "deep//er/b%20c%.bin", "%C3%BC.bin"}) {
    const Result<GltfScene> scene = read_with(uri);
    EXPECT_TRUE(scene.ok()) << scene.error().message;
  }
}

TEST_F(ExternalBuffer, NeverFromElsewhere) {
  const std::filesystem::path secret = write("secret.bin", data_);
  write("model/deep/b.bin", data_);
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2E/secret.bin"), std::string("deep/../../secret.bin"),
        std::string("deep/../deep/b.bin"), std::string("..%2Fsecret.bin"), std::string("..\\secret.bin"),
        std::string("deep%5C..%5C..%5Csecret.bin"), secret.string(), "file://" + secret.string(),
        std::string("http://example.org/b.bin"), std::string("C:/b.bin"), std::string("C%3A/b.bin"),
        std::string("b.bin%00.txt"), std::string(""), std::string(".")}) {
    expect_error(uri, ErrorCode::kUnsafePath);
  }
}

TEST_F(ExternalBuffer, SymbolicLinksMayNotLeaveTheFolder) {
  const std::filesystem::path secret = write("secret.bin", data_);
  write("model/deep/b.bin", data_);
  std::filesystem::create_symlink(secret, folder_ / "model" / "link.bin");
  std::filesystem::create_directory_symlink(folder_, folder_ / "model" / "up");
  std::filesystem::create_symlink("deep/b.bin", folder_ / "model" / "inside.bin");
  expect_error("link.bin", ErrorCode::kUnsafePath);
  expect_error("up/secret.bin", ErrorCode::kUnsafePath);
  EXPECT_TRUE(read_with("inside.bin").ok());
}

TEST_F(ExternalBuffer, SiblingFolderWithTheSamePrefixIsElsewhere) {
  write("model2/b.bin", data_);
  std::filesystem::create_directories(folder_ / "model");
  std::filesystem::create_directory_symlink(folder_ / "model2", folder_ / "model" / "other");
  expect_error("other/b.bin", ErrorCode::kUnsafePath);
}

TEST_F(ExternalBuffer, AbsentOrShortOrNoFileIsTold) {
  expect_error("absent.bin", ErrorCode::kFileNotFound);
  EXPECT_NE(read_with("absent.bin").error().message.find("absent.bin"), std::string::npos);
  write("model/short.bin", Bytes(35));
  expect_error("short.bin", ErrorCode::kBadFormat);
  std::filesystem::create_directories(folder_ / "model" / "folder.bin");
  expect_error("folder.bin", ErrorCode::kFileRead);
}

TEST_F(ExternalBuffer, BytesInMemoryUseTheFolderGiven) {
  write("a.bin", data_);
  GltfBuilder builder = triangle_builder();
  builder.json["buffers"][0]["uri"] = "a.bin";
  const Bytes bytes = bytes_of(builder.json.dump());
  EXPECT_TRUE(read_gltf_bytes(bytes, "memory", folder_, {}).ok());
  const Result<GltfScene> scene = read_gltf_bytes(bytes, "memory", {}, {});
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, ErrorCode::kFileNotFound);
}

TEST_F(ExternalBuffer, WhatOnlyImagesNeedIsNeverTouched) {
  GltfBuilder builder = triangle_builder();
  builder.json["buffers"].push_back({{"byteLength", 10}, {"uri", "pixels.bin"}});
  builder.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 10}});
  builder.json["images"] = {{{"bufferView", 1}, {"mimeType", "image/png"}},
                            {{"uri", "/dev/zero"}},
                            {{"uri", "../secret.png"}},
                            {{"uri", "data:image/png;base64,AAAA"}},
                            "not even an image"};
  builder.json["textures"] = {{{"source", 4000}}};
  builder.json["animations"] = {{{"channels", "wrong"}}};
  builder.json["extras"] = {{"anything", Json::array({1, nullptr})}};
  const Result<GltfScene> scene = read_gltf_bytes(builder.glb(), "memory", folder_, {});
  EXPECT_TRUE(scene.ok()) << scene.error().message;
}

TEST(DataUri, DamagedOneIsRefused) {
  for (const char* uri :
       {"data:application/octet-stream;base64,AAAA", "data:application/octet-stream;base64,!!!!",
        "data:,plain", "DATA:application/octet-stream;base64"}) {
    GltfBuilder builder = triangle_builder();
    builder.json["buffers"][0]["uri"] = uri;
    const Result<GltfScene> scene = read(bytes_of(builder.json.dump()));
    ASSERT_FALSE(scene.ok()) << uri;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadFormat) << scene.error().message;
  }
}

}  // namespace
}  // namespace palpate::test
