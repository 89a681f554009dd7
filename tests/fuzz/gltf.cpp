#include <cmath>

#include "tests/fuzz/sound.h"
#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

// So that no input is slow for no other reason than its size.
constexpr std::uint64_t kMostTriangles = 20'000;
constexpr std::uint64_t kMostSearched = 300;

void require_sound_info(const plp_model_info& info) {
  require(info.searched.triangles > 0, "triangles in what was loaded");
  require(std::isfinite(info.diagonal) && info.diagonal > 0.0, "a finite diagonal");
  for (int axis = 0; axis < 3; ++axis)
    require(std::isfinite(info.bounds_min[axis]) && info.bounds_min[axis] <= info.bounds_max[axis], "bounds");
}

void search(plp_model model, const plp_model_info& info) {
  plp_query_options options;
  plp_query_options_init(&options, sizeof options);
  options.cutoff = 0.05 * info.diagonal;
  if (!(options.cutoff > 0.0 && options.cutoff < 1e15)) return;
  const plp_pose pose = {{0.6 * info.diagonal, 0.2 * info.diagonal, 0.0}, {0.1, 0.2, 0.3, 0.9}};
  touch(model, model, pose, options);
}

}  // namespace

void gltf(std::span<const std::uint8_t> bytes) {
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.max_triangles = kMostTriangles;
  plp_model model = nullptr;
  if (checked(plp_model_load_memory(bytes.data(), bytes.size(), nullptr, &options, &model)) < 0) {
    require(!model, "no model after an error");
    return;
  }
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  require(checked(plp_model_get_info(model, &info)) == PLP_OK, "an info");
  require_sound_info(info);
  if (info.searched.triangles <= kMostSearched) search(model, info);
  require(checked(plp_model_release(model)) == PLP_OK, "a model to release");
}

}  // namespace palpate::fuzz
