// Files that change while they are read.
#include <filesystem>
#include <string>

#include "tests/capi/gltf_file.h"
#include "tests/fault/refused_calls.h"
#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

class ChangingFile : public testing::Test {
 protected:
  // Its buffer is a file of its own, of whole pages, as what is mapped into memory would be.
  ChangingFile() {
    Json json = gltf_of({torus(0.5, 0.2, 60, 40)});
    add_node(json, {{"mesh", 0}});
    const std::size_t size = json["buffers"][0]["byteLength"];
    json["buffers"][0]["uri"] = buffer_.filename().string();
    std::ofstream(buffer_, std::ios::binary) << std::string(size, '\1');
    file_ = std::make_unique<GltfFile>(json);
  }
  ~ChangingFile() override { std::filesystem::remove(buffer_); }

  plp_result load(std::string* sentence = nullptr) const {
    plp_model model = nullptr;
    const plp_result result = plp_model_load_file(file_->path().c_str(), nullptr, &model);
    if (sentence) *sentence = plp_last_error();
    plp_model_release(model);
    return result;
  }

  const std::filesystem::path buffer_ =
      std::filesystem::temp_directory_path() / ("palpate_buffer_" + std::to_string(::getpid()) + ".bin");
  std::unique_ptr<GltfFile> file_;
};

TEST_F(ChangingFile, AGltfThatIsCutWhileItIsReadIsTold) {
  std::string sentence;
  before_opening(1, [&] { std::filesystem::resize_file(file_->path(), 100); });
  EXPECT_EQ(load(&sentence), PLP_ERROR_FILE_READ);
  EXPECT_NE(sentence.find(file_->path()), std::string::npos) << sentence;
}

TEST_F(ChangingFile, ABufferThatIsCutWhileItIsReadIsTold) {
  std::string sentence;
  before_opening(2, [&] { std::filesystem::resize_file(buffer_, 5'000); });
  EXPECT_EQ(load(&sentence), PLP_ERROR_FILE_READ);
  EXPECT_NE(sentence.find(buffer_.filename().string()), std::string::npos) << sentence;
}

TEST_F(ChangingFile, AFileThatIsGoneOrAnotherWhenItIsOpenedIsAnError) {
  before_opening(2, [&] { std::filesystem::remove(buffer_); });
  EXPECT_EQ(load(), PLP_ERROR_FILE_READ);
  before_opening(1, [&] {
    const auto size = std::filesystem::file_size(file_->path());
    std::ofstream(file_->path(), std::ios::binary) << std::string(2 * size, '[');
  });
  EXPECT_EQ(load(), PLP_ERROR_LIMIT) << "brackets nest";
}

TEST(ChangingTrace, OneThatIsCutWhileItIsOpenIsTold) {
  const TraceFile file;
  const TestModel cube(box(0.5f, 0.5f, 0.5f));
  TestScene scene(0.2);
  scene.add(cube.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene.add(cube.handle, PLP_BODY_TOOL, at(1.1, 0, 0));
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  for (int i = 0; i < 100; ++i) scene.step();
  stop_recording(scene.handle);
  const TestTrace trace(file);
  std::filesystem::resize_file(file.path(), file.bytes().size() / 2);
  plp_trace_tick tick;
  plp_trace_tick_init(&tick, sizeof tick);
  EXPECT_EQ(plp_trace_read(trace.handle, 0, &tick), PLP_OK) << plp_last_error();
  EXPECT_EQ(plp_trace_read(trace.handle, 99, &tick), PLP_ERROR_FILE_READ);
  EXPECT_NE(std::string(plp_last_error()).find(file.path()), std::string::npos) << plp_last_error();
  EXPECT_EQ(plp_trace_read(trace.handle, 0, &tick), PLP_OK) << plp_last_error();
}

// Another file under its name is none of its business.
TEST(ChangingTrace, OneThatIsReplacedWhileItIsOpenGoesOn) {
  const TraceFile file, other;
  TestScene scene(0.2);
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  scene.step();
  stop_recording(scene.handle);
  const TestTrace trace(file);
  other.write("something else");
  std::filesystem::rename(other.path(), file.path());
  EXPECT_EQ(trace.read(0).step, 1u);
}

}  // namespace
}  // namespace palpate::test
