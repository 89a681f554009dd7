// What states a size that it cannot have is refused before memory is taken for it.
#include <cstdint>
#include <string>
#include <vector>

#include "tests/capi/gltf_file.h"
#include "tests/fault/failing_allocation.h"
#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

constexpr std::size_t kModest = 1u << 20;

class StatedSize : public testing::Test {
 protected:
  StatedSize() {
    json_ = gltf_of({box(0.5f, 0.5f, 0.5f)});
    add_node(json_, {{"mesh", 0}});
  }

  void expect_refused(const char* what) {
    const std::string text = json_.dump();
    take_largest_request();
    plp_model model = nullptr;
    const plp_result result = plp_model_load_memory(text.data(), text.size(), nullptr, nullptr, &model);
    EXPECT_TRUE(result == PLP_ERROR_LIMIT || result == PLP_ERROR_BAD_FORMAT)
        << what << ": " << plp_result_string(result);
    EXPECT_LT(take_largest_request(), kModest) << what << ": " << plp_last_error();
    plp_model_release(model);
  }

  Json& accessor(int index) { return json_["accessors"][static_cast<std::size_t>(index)]; }
  Json& primitive() { return json_["meshes"][0]["primitives"][0]; }

  Json json_;
};

TEST_F(StatedSize, OfAnAccessor) {
  for (const std::uint64_t count : {1'000'000'000ull, 4'294'967'295ull, 1ull << 40, 1ull << 62}) {
    accessor(0)["count"] = count;
    expect_refused("more vertices than bytes");
    accessor(0).erase("bufferView");
    expect_refused("zeros");
    accessor(0)["bufferView"] = 0;
    accessor(0)["count"] = 8;
    accessor(1)["count"] = count / 3 * 3;
    expect_refused("more indices than bytes");
    accessor(1)["count"] = 36;
  }
}

TEST_F(StatedSize, OfASparseAccessor) {
  accessor(0)["sparse"] = {{"count", 2'000'000'000},
                           {"indices", {{"bufferView", 1}, {"componentType", 5125}}},
                           {"values", {{"bufferView", 0}}}};
  expect_refused("sparse");
}

TEST_F(StatedSize, OfABuffer) {
  json_["buffers"][0]["byteLength"] = 1ull << 40;
  expect_refused("a data URI that is shorter");
  json_["buffers"][0]["byteLength"] = 30;
  expect_refused("a buffer that is shorter than its views");
}

TEST_F(StatedSize, OfACompressedView) {
  json_["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0}, {"byteLength", 96}, {"byteStride", 12}, {"count", 1ull << 40}, {"mode", "ATTRIBUTES"}};
  expect_refused("meshopt");
}

TEST_F(StatedSize, OfADracoStream) {
  const std::string stream("DRACO\2\2\1\0\0\0\xff\xff\xff\xff\x0f\3", 17);
  const std::vector<unsigned char> bytes(stream.begin(), stream.end());
  json_["buffers"][0] = {{"byteLength", bytes.size()},
                         {"uri", "data:application/octet-stream;base64," + base64(bytes)}};
  json_["bufferViews"] = {{{"buffer", 0}, {"byteLength", bytes.size()}}};
  for (Json& stated : json_["accessors"]) stated.erase("bufferView");
  primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                             {"attributes", {{"POSITION", 0}}}};
  expect_refused("Draco");
}

TEST(StatedTriangles, AreRefusedBeforeTheyAreCopied) {
  const Shape shape = box(1, 1, 1);
  for (const std::size_t count : {std::size_t{100'000'001}, std::size_t{1} << 40, SIZE_MAX / 3}) {
    plp_triangles triangles = triangles_of(shape);
    triangles.triangle_count = count;
    plp_model model = nullptr;
    take_largest_request();
    EXPECT_LT(plp_model_create_from_triangles(&triangles, nullptr, &model), 0);
    EXPECT_LT(take_largest_request(), kModest) << plp_last_error();
    triangles = triangles_of(shape);
    triangles.vertex_count = count << 8;
    take_largest_request();
    EXPECT_LT(plp_model_create_from_triangles(&triangles, nullptr, &model), 0);
    EXPECT_LT(take_largest_request(), kModest) << plp_last_error();
  }
}

TEST(StatedOverlaps, AreRoomForThoseThatThereAreOnly) {
  const TestModel cube(box(0.5f, 0.5f, 0.5f));
  plp_scene_options options = TestScene::options_with(0.1);
  options.max_overlaps = UINT32_MAX;
  TestScene scene(options);
  scene.add(cube.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene.add(cube.handle, PLP_BODY_TOOL, at(0.9, 0.1, 0.1));
  take_largest_request();
  EXPECT_GT(scene.step().overlap_count, 0u);
  EXPECT_LT(take_largest_request(), kModest);
}

// A block that says that it has four gigabytes, and counts of parts that no tick has.
TEST(StatedTrace, IsReadAsFarAsItIsThere) {
  const TraceFile file;
  TestScene scene(0.2);
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  for (int i = 0; i < 3; ++i) scene.step();
  stop_recording(scene.handle);
  const std::string whole = file.bytes();
  for (std::size_t at = 0; at + 4 <= whole.size(); at += 4) {
    std::string bytes = whole;
    bytes.replace(at, 4, "\xff\xff\xff\xff");
    file.write(bytes);
    take_largest_request();
    plp_trace trace = nullptr;
    if (plp_trace_open(file.path(), &trace) == PLP_OK) {
      plp_trace_tick tick;
      plp_trace_tick_init(&tick, sizeof tick);
      for (std::uint64_t i = 0; i < 3; ++i) plp_trace_read(trace, i, &tick);
      plp_trace_release(trace);
    }
    EXPECT_LT(take_largest_request(), kModest) << "at byte " << at;
  }
}

}  // namespace
}  // namespace palpate::test
