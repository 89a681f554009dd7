#include "tests/fuzz/box_model.h"

#include <algorithm>
#include <array>

#include "tests/fuzz/sound.h"

namespace palpate::fuzz {

plp_model box_model(float edge, std::uint64_t triangles) {
  constexpr std::uint8_t kFaces[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                     2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  std::array<float, 24> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = (i / 3 >> i % 3 & 1 ? 0.5f : -0.5f) * edge;
  plp_triangles given;
  plp_triangles_init(&given, sizeof given);
  given.positions = corners.data();
  given.vertex_count = 8;
  given.indices = kFaces;
  given.index_type = PLP_TYPE_UINT8;
  given.triangle_count = std::min(triangles, kBoxTriangles);
  plp_model model = nullptr;
  checked(plp_model_create_from_triangles(&given, nullptr, &model));
  return model;
}

}  // namespace palpate::fuzz
