#include <vector>

#include "tests/fuzz/input.h"
#include "tests/fuzz/sound.h"
#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

constexpr std::size_t kMostVertices = 24;
constexpr std::size_t kMostTriangles = 40;

// On a coarse grid, so that planes, lines and points coincide; or any bits.
std::vector<float> positions(Input& input) {
  std::vector<float> xyz(3 * input.below(kMostVertices));
  const bool on_grid = input.byte() < 200;
  for (float& x : xyz) x = on_grid ? 0.25f * static_cast<float>(input.byte() % 9) : input.take<float>();
  return xyz;
}

std::vector<std::uint32_t> indices(Input& input, std::size_t vertices) {
  std::vector<std::uint32_t> corners(3 * input.below(kMostTriangles));
  for (std::uint32_t& corner : corners)
    corner = input.byte() == 255 ? input.take<std::uint32_t>()
                                 : static_cast<std::uint32_t>(input.below(vertices + 1));
  return corners;
}

plp_model make(Input& input) {
  const std::vector<float> xyz = positions(input);
  const std::vector<std::uint32_t> corners = indices(input, xyz.size() / 3);
  plp_triangles triangles;
  plp_triangles_init(&triangles, sizeof triangles);
  triangles.positions = xyz.data();
  triangles.vertex_count = xyz.size() / 3;
  triangles.indices = corners.data();
  triangles.triangle_count = corners.size() / 3;
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.flags = input.byte() % 4;
  if (input.byte() > 230) options.weld_tolerance = input.number();
  plp_model model = nullptr;
  if (checked(plp_model_create_from_triangles(&triangles, &options, &model)) < 0)
    require(!model, "no model after an error");
  return model;
}

void search(Input& input, plp_model a, plp_model b) {
  plp_query_options options;
  plp_query_options_init(&options, sizeof options);
  options.cutoff = 0.5 + input.number();
  options.law = static_cast<std::int32_t>(input.below(2));
  const plp_pose pose = input.pose();
  touch(a, b, pose, options);
}

}  // namespace

void triangles(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const plp_model a = make(input);
  const plp_model b = make(input);
  for (int i = 0; i < 4; ++i)
    if (a && b) search(input, a, b);
  plp_model_release(a);
  plp_model_release(b);
}

}  // namespace palpate::fuzz
