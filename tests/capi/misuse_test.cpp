#include <cstring>
#include <functional>
#include <limits>
#include <string>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Handle>
Handle as(std::uint64_t bits) {
  return reinterpret_cast<Handle>(static_cast<std::uintptr_t>(bits));
}

template <class To, class From>
To cast_handle(From handle) {
  return reinterpret_cast<To>(handle);
}

// Expects INVALID_ARGUMENT with a sentence that names `what`.
void expect_refused(plp_result result, const char* what) {
  EXPECT_EQ(result, PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(plp_last_error()).find(what), std::string::npos) << plp_last_error();
}

class Misuse : public testing::Test {
 protected:
  plp_query_options query_options() const {
    plp_query_options options;
    plp_query_options_init(&options, sizeof options);
    options.cutoff = 0.1;
    return options;
  }

  plp_body_options body_options() const {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = model_.handle;
    return options;
  }

  plp_result query(plp_pose pose, plp_query_options options) {
    return plp_query(model_.handle, model_.handle, &pose, &options, query_.handle);
  }

  plp_result add(const plp_body_options& options) {
    plp_body body = 77;
    const plp_result result = plp_scene_add_body(scene_.handle, &options, &body);
    EXPECT_EQ(body == 77u, result < 0) << "an output was touched, or was not";
    return result;
  }

  TestModel model_{box(1.0f, 1.0f, 1.0f)};
  TestQuery query_;
  TestScene scene_{0.1};
};

TEST_F(Misuse, NullHandlesAreRefusedButReleased) {
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  const plp_pose pose = at(0, 0, 0);
  const plp_query_options options = query_options();
  plp_pose read;
  EXPECT_EQ(plp_model_retain(nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_prepare(nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_get_info(nullptr, &info), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_note(nullptr, 0), nullptr);
  EXPECT_EQ(plp_query(nullptr, model_.handle, &pose, &options, query_.handle), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_query(model_.handle, nullptr, &pose, &options, query_.handle), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_query(model_.handle, model_.handle, &pose, &options, nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_query_result_get(nullptr, &contacts), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_step(nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_get_contacts(nullptr, &contacts), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_set_pose(nullptr, 1, &pose), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_get_pose(nullptr, 1, &read), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_remove_body(nullptr, 1), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_set_cutoff(nullptr, 1.0), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_set_stiffness(nullptr, 1.0), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_release(nullptr), PLP_OK);
  EXPECT_EQ(plp_query_result_release(nullptr), PLP_OK);
  EXPECT_EQ(plp_scene_release(nullptr), PLP_OK);
}

TEST_F(Misuse, HandlesOfAnotherKindAreRefused) {
  EXPECT_EQ(plp_model_release(cast_handle<plp_model>(scene_.handle)), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_prepare(cast_handle<plp_model>(query_.handle)), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_step(cast_handle<plp_scene>(model_.handle)), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_release(cast_handle<plp_scene>(query_.handle)), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_query_result_release(cast_handle<plp_query_result>(model_.handle)), PLP_ERROR_INVALID_HANDLE);
  int local = 0;
  EXPECT_EQ(plp_model_prepare(cast_handle<plp_model>(&local)), PLP_ERROR_INVALID_HANDLE) << "an address";
  for (const std::uint64_t garbage :
       {std::uint64_t{1}, UINT64_MAX, std::uint64_t{1} << 56, std::uint64_t{0xdead} << 40}) {
    EXPECT_EQ(plp_model_prepare(as<plp_model>(garbage)), PLP_ERROR_INVALID_HANDLE) << garbage;
  }
}

TEST_F(Misuse, ReleasedHandlesAreRefused) {
  plp_query_result result = nullptr;
  ASSERT_EQ(plp_query_result_create(&result), PLP_OK);
  EXPECT_EQ(plp_query_result_release(result), PLP_OK);
  EXPECT_EQ(plp_query_result_release(result), PLP_ERROR_INVALID_HANDLE);
  plp_query_result other = nullptr;
  ASSERT_EQ(plp_query_result_create(&other), PLP_OK);
  EXPECT_NE(other, result) << "a handle came back";
  EXPECT_EQ(plp_query_result_release(result), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_query_result_release(other), PLP_OK);
}

TEST_F(Misuse, RetainedModelLivesUntilItsLastRelease) {
  plp_model model = nullptr;
  const Shape shape = box(1, 1, 1);
  const plp_triangles triangles = triangles_of(shape);
  ASSERT_EQ(plp_model_create_from_triangles(&triangles, nullptr, &model), PLP_OK);
  EXPECT_EQ(plp_model_retain(model), PLP_OK);
  EXPECT_EQ(plp_model_release(model), PLP_OK);
  EXPECT_EQ(plp_model_prepare(model), PLP_OK);
  EXPECT_EQ(plp_model_release(model), PLP_OK);
  EXPECT_EQ(plp_model_release(model), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_retain(model), PLP_ERROR_INVALID_HANDLE);
}

TEST_F(Misuse, NullPointersAreRefused) {
  const plp_pose pose = at(0, 0, 0);
  const plp_query_options options = query_options();
  plp_model model = nullptr;
  plp_scene scene = nullptr;
  plp_body body = 0;
  expect_refused(plp_model_load_file(nullptr, nullptr, &model), "path");
  expect_refused(plp_model_load_file("", nullptr, &model), "path");
  expect_refused(plp_model_load_file("x.glb", nullptr, nullptr), "model");
  expect_refused(plp_model_load_memory(nullptr, 8, nullptr, nullptr, &model), "data");
  expect_refused(plp_model_create_from_triangles(nullptr, nullptr, &model), "triangles");
  expect_refused(plp_model_get_info(model_.handle, nullptr), "info");
  expect_refused(plp_query_result_create(nullptr), "result");
  expect_refused(plp_query(model_.handle, model_.handle, nullptr, &options, query_.handle), "a_from_b");
  expect_refused(plp_query(model_.handle, model_.handle, &pose, nullptr, query_.handle), "options");
  expect_refused(plp_query_result_get(query_.handle, nullptr), "contacts");
  expect_refused(plp_scene_create(nullptr, &scene), "options");
  expect_refused(plp_scene_add_body(scene_.handle, nullptr, &body), "options");
  expect_refused(plp_scene_get_contacts(scene_.handle, nullptr), "contacts");
  const plp_body_options valid = body_options();
  expect_refused(plp_scene_add_body(scene_.handle, &valid, nullptr), "body");
  ASSERT_EQ(plp_scene_add_body(scene_.handle, &valid, &body), PLP_OK);
  expect_refused(plp_scene_set_pose(scene_.handle, body, nullptr), "pose");
  expect_refused(plp_scene_get_pose(scene_.handle, body, nullptr), "pose");
}

TEST_F(Misuse, InitFunctionsBearNull) {
  plp_model_options_init(nullptr, sizeof(plp_model_options));
  plp_triangles_init(nullptr, sizeof(plp_triangles));
  plp_model_info_init(nullptr, sizeof(plp_model_info));
  plp_contacts_init(nullptr, sizeof(plp_contacts));
  plp_query_options_init(nullptr, sizeof(plp_query_options));
  plp_scene_options_init(nullptr, sizeof(plp_scene_options));
  plp_body_options_init(nullptr, sizeof(plp_body_options));
  EXPECT_EQ(plp_scene_step(scene_.handle), PLP_OK);
}

TEST_F(Misuse, PosesMustBeFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e300}) {
    for (int i = 0; i < 3; ++i) {
      plp_pose pose = at(0, 0, 0);
      pose.position[i] = bad;
      expect_refused(query(pose, query_options()), "a_from_b.position");
    }
  }
  for (const double bad : {kNan, kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      plp_pose pose = at(0, 0, 0);
      pose.orientation[i] = bad;
      expect_refused(query(pose, query_options()), "a_from_b.orientation");
    }
  }
  plp_pose zero = at(0, 0, 0);
  zero.orientation[3] = 0.0;
  expect_refused(query(zero, query_options()), "orientation is zero");
}

TEST_F(Misuse, QuaternionsOfAnyLengthAreNormalised) {
  for (const double length : {1e-300, 1e-3, 7.0, 1e300}) {
    plp_pose pose = at(2.05, 0, 0);
    pose.orientation[3] = length;
    EXPECT_EQ(query(pose, query_options()), PLP_OK) << plp_last_error();
    EXPECT_NEAR(query_.contacts().min_distance, 0.05, 1e-15) << length;
  }
}

TEST_F(Misuse, NumbersOfAQueryAreChecked) {
  for (const double bad : {kNan, kInfinity, 0.0, -1.0, 1e300}) {
    plp_query_options options = query_options();
    options.cutoff = bad;
    expect_refused(query(at(0, 0, 0), options), "cutoff");
  }
  for (const double bad : {kNan, kInfinity, -1.0, 1e300}) {
    plp_query_options options = query_options();
    options.stiffness = bad;
    expect_refused(query(at(0, 0, 0), options), "stiffness");
  }
  plp_query_options options = query_options();
  options.reference_point[2] = kNan;
  expect_refused(query(at(0, 0, 0), options), "reference_point");
}

TEST_F(Misuse, FailedQueryLeavesAnEmptyResult) {
  ASSERT_EQ(query(at(2.05, 0, 0), query_options()), PLP_OK);
  ASSERT_GT(query_.contacts().lmd_count, 0u);
  expect_refused(query(at(kNan, 0, 0), query_options()), "position");
  EXPECT_EQ(query_.contacts().lmd_count, 0u);
  EXPECT_EQ(query_.contacts().min_distance, kInfinity);
}

TEST_F(Misuse, NumbersOfASceneAreChecked) {
  for (const double bad : {kNan, kInfinity, 0.0, -1.0}) {
    const plp_scene_options options = TestScene::options_with(bad);
    plp_scene scene = nullptr;
    expect_refused(plp_scene_create(&options, &scene), "cutoff");
    EXPECT_EQ(scene, nullptr);
    expect_refused(plp_scene_set_cutoff(scene_.handle, bad), "cutoff");
  }
  for (const double bad : {kNan, kInfinity, -1.0}) {
    plp_scene_options options = TestScene::options_with(0.1);
    options.stiffness = bad;
    plp_scene scene = nullptr;
    expect_refused(plp_scene_create(&options, &scene), "stiffness");
    expect_refused(plp_scene_set_stiffness(scene_.handle, bad), "stiffness");
  }
}

TEST_F(Misuse, SpacesAreChecked) {
  const plp_space bad[] = {{{0, 0, 0}, 0, 1.0},        {{1, 1, 2}, 0, 1.0}, {{1, -1, 3}, 0, 1.0},
                           {{1, 2, 4}, 0, 1.0},        {{1, 2, 3}, 0, 0.0}, {{1, 2, 3}, 0, -1.0},
                           {{1, 2, 3}, 0, kNan},       {{1, 2, 3}, 9, 1.0}, {{1, 2, 3}, 0, kInfinity},
                           {{1, 2, INT32_MIN}, 0, 1.0}};
  for (const plp_space& space : bad) {
    plp_scene_options options = TestScene::options_with(0.1);
    options.space = space;
    plp_scene scene = nullptr;
    expect_refused(plp_scene_create(&options, &scene), "space");
    const Shape shape = box(1, 1, 1);
    plp_triangles triangles = triangles_of(shape);
    triangles.space = space;
    plp_model model = nullptr;
    expect_refused(plp_model_create_from_triangles(&triangles, nullptr, &model), "space");
  }
}

TEST_F(Misuse, BodiesAreChecked) {
  plp_body_options options = body_options();
  options.kind = static_cast<plp_body_kind>(3);
  expect_refused(add(options), "kind");
  options = body_options();
  options.pose.position[0] = kNan;
  expect_refused(add(options), "pose");
  options = body_options();
  options.stiffness = -1.0;
  expect_refused(add(options), "stiffness");
  options = body_options();
  options.reference_point[1] = kInfinity;
  expect_refused(add(options), "reference_point");
  options = body_options();
  options.model = nullptr;
  EXPECT_EQ(add(options), PLP_ERROR_INVALID_HANDLE);
  options = body_options();
  options.kind = PLP_BODY_TOOL;
  EXPECT_EQ(add(options), PLP_OK);
  expect_refused(add(options), "tool");
}

TEST_F(Misuse, BodiesThatAreNoneAreRefused) {
  const plp_body_options options = body_options();
  plp_body body = 0;
  ASSERT_EQ(plp_scene_add_body(scene_.handle, &options, &body), PLP_OK);
  const plp_pose pose = at(0, 0, 0);
  EXPECT_EQ(plp_scene_remove_body(scene_.handle, body), PLP_OK);
  for (const plp_body none : {plp_body{0}, body, plp_body{UINT64_MAX}}) {
    plp_pose read;
    EXPECT_EQ(plp_scene_remove_body(scene_.handle, none), PLP_ERROR_INVALID_HANDLE);
    EXPECT_EQ(plp_scene_set_pose(scene_.handle, none, &pose), PLP_ERROR_INVALID_HANDLE);
    EXPECT_EQ(plp_scene_get_pose(scene_.handle, none, &read), PLP_ERROR_INVALID_HANDLE);
  }
  plp_body next = 0;
  ASSERT_EQ(plp_scene_add_body(scene_.handle, &options, &next), PLP_OK);
  EXPECT_NE(next, body);
}

TEST_F(Misuse, ModelOptionsAreChecked) {
  const Shape shape = box(1, 1, 1);
  const plp_triangles triangles = triangles_of(shape);
  const std::pair<std::function<void(plp_model_options&)>, const char*> cases[] = {
      {[](plp_model_options& o) { o.flags = 4; }, "flags"},
      {[](plp_model_options& o) { o.flags = 0x80000001u; }, "flags"},
      {[](plp_model_options& o) { o.reserved = 1; }, "reserved"},
      {[](plp_model_options& o) { o.gltf_scene = -2; }, "gltf_scene"},
      {[](plp_model_options& o) { o.weld_tolerance = kNan; }, "weld_tolerance"},
      {[](plp_model_options& o) { o.weld_tolerance = -1.0; }, "weld_tolerance"},
      {[](plp_model_options& o) { o.scale = kNan; }, "scale"},
      {[](plp_model_options& o) { o.scale = -1.0; }, "scale"},
  };
  for (const auto& [spoil, name] : cases) {
    plp_model_options options;
    plp_model_options_init(&options, sizeof options);
    spoil(options);
    plp_model model = nullptr;
    expect_refused(plp_model_create_from_triangles(&triangles, &options, &model), name);
    EXPECT_EQ(model, nullptr);
  }
}

// A caller's struct followed by what a later version may have appended.
template <class T>
struct Longer {
  T known;
  unsigned char tail[16] = {};
};

// Whatever size a program was built with, no byte behind it is written, and what this version does not know
// is zero.
template <class T>
void expect_fills(void (*init)(T*, std::size_t)) {
  constexpr unsigned char kUntouched = 0xA5;
  T whole;
  init(&whole, sizeof whole);
  EXPECT_EQ(whole.struct_size, sizeof whole);
  for (const std::size_t size : {std::size_t{4}, sizeof(T) - 8, sizeof(T), sizeof(T) + 32}) {
    alignas(T) unsigned char bytes[sizeof(T) + 64];
    std::memset(bytes, kUntouched, sizeof bytes);
    init(reinterpret_cast<T*>(bytes), size);
    std::uint32_t told = 0;
    std::memcpy(&told, bytes, sizeof told);
    EXPECT_EQ(told, size);
    const std::size_t known = std::min(size, sizeof(T));
    EXPECT_EQ(std::memcmp(bytes + 4, reinterpret_cast<unsigned char*>(&whole) + 4, known - 4), 0) << size;
    for (std::size_t i = known; i < sizeof bytes; ++i) EXPECT_EQ(bytes[i], i < size ? 0 : kUntouched) << i;
  }
  T left_alone;
  std::memset(static_cast<void*>(&left_alone), kUntouched, sizeof left_alone);
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{5000}, SIZE_MAX}) {
    init(&left_alone, size);
    EXPECT_EQ(left_alone.struct_size, 0xA5A5A5A5u) << size;
  }
  init(nullptr, sizeof(T));
}

TEST_F(Misuse, InitFunctionsWriteNoMoreThanTheirCallersStruct) {
  expect_fills(plp_model_options_init);
  expect_fills(plp_triangles_init);
  expect_fills(plp_model_info_init);
  expect_fills(plp_contacts_init);
  expect_fills(plp_query_options_init);
  expect_fills(plp_scene_options_init);
  expect_fills(plp_body_options_init);
  expect_fills(plp_servo_options_init);
  expect_fills(plp_servo_state_init);
  expect_fills(plp_device_info_init);
  expect_fills(plp_device_state_init);
  expect_fills(plp_safety_limits_init);
  expect_fills(plp_hand_options_init);
  expect_fills(plp_device_mapping_init);
}

TEST_F(Misuse, InputStructSizes) {
  const plp_pose pose = at(0, 0, 0);
  Longer<plp_query_options> longer{query_options(), {}};
  const auto run = [&] {
    return plp_query(model_.handle, model_.handle, &pose, &longer.known, query_.handle);
  };
  for (const std::uint32_t size : {0u, 4u, 40u, 47u, 5000u, UINT32_MAX}) {
    longer.known.struct_size = size;
    expect_refused(run(), "struct_size");
  }
  longer.known.struct_size = sizeof longer;
  EXPECT_EQ(run(), PLP_OK);
  longer.tail[15] = 1;
  expect_refused(run(), "this version does not have");
  longer.known.struct_size = sizeof longer.known;
  EXPECT_EQ(run(), PLP_OK) << "what is behind the struct is none of the library's business";
}

TEST_F(Misuse, EveryInputStructHasItsSizeChecked) {
  const Shape shape = box(1, 1, 1);
  plp_triangles triangles = triangles_of(shape);
  plp_model_options model_options;
  plp_model_options_init(&model_options, sizeof model_options);
  plp_scene_options scene_options = TestScene::options_with(0.1);
  plp_body_options placed = body_options();
  plp_model model = nullptr;
  plp_scene scene = nullptr;
  triangles.struct_size -= 1;
  expect_refused(plp_model_create_from_triangles(&triangles, nullptr, &model), "triangles->struct_size");
  triangles.struct_size += 1;
  model_options.struct_size = offsetof(plp_model_options, scale) - 1;
  expect_refused(plp_model_create_from_triangles(&triangles, &model_options, &model), "options->struct_size");
  scene_options.struct_size = offsetof(plp_scene_options, law) - 1;  // the first version's size, less one
  expect_refused(plp_scene_create(&scene_options, &scene), "options->struct_size");
  placed.struct_size = offsetof(plp_body_options, damping) - 1;
  expect_refused(add(placed), "options->struct_size");
}

TEST_F(Misuse, OutputStructSizes) {
  Longer<plp_model_info> longer;
  plp_model_info_init(&longer.known, sizeof longer.known);
  std::memset(longer.tail, 0xab, sizeof longer.tail);
  for (const std::uint32_t size : {0u, 8u, 287u, 5000u}) {
    longer.known.struct_size = size;
    expect_refused(plp_model_get_info(model_.handle, &longer.known), "struct_size");
    EXPECT_EQ(longer.known.searched.triangles, 0u) << "an output was touched";
  }
  longer.known.struct_size = sizeof longer;
  EXPECT_EQ(plp_model_get_info(model_.handle, &longer.known), PLP_OK);
  EXPECT_EQ(longer.known.struct_size, sizeof longer);
  EXPECT_EQ(longer.known.searched.triangles, 12u);
  EXPECT_EQ(longer.tail[0], 0xab);
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  contacts.struct_size = 215;
  expect_refused(plp_query_result_get(query_.handle, &contacts), "struct_size");
  expect_refused(plp_scene_get_contacts(scene_.handle, &contacts), "struct_size");
}

}  // namespace
}  // namespace palpate::test
