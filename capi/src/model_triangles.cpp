#include <algorithm>

#include "capi/src/handles.h"

namespace palpate::capi {
namespace {

void copy_positions(const Mesh& mesh, std::size_t rows, double* positions) {
  for (std::size_t i = 0; i < rows; ++i) {
    store(mesh.frame.metres(mesh.position(static_cast<std::uint32_t>(i))), positions + 3 * i);
  }
}

void copy_corners(const Mesh& mesh, std::size_t rows, std::uint32_t* corners) {
  for (std::size_t i = 0; i < rows; ++i) {
    std::ranges::copy(mesh.triangles[i], corners + 3 * i);
  }
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

plp_result plp_model_get_vertices(plp_model model, double* positions, size_t capacity, size_t* count) {
  return guarded([&] {
    require(count, "count is null");
    require(positions || capacity == 0, "positions is null and capacity is not 0");
    const auto object = model_table().pin(bits_of(model));
    require_handle(object, "model");
    const Mesh& mesh = object->model->mesh();
    copy_positions(mesh, std::min(capacity, mesh.positions.size()), positions);
    *count = mesh.positions.size();
  });
}

plp_result plp_model_get_triangles(plp_model model, uint32_t* corners, uint32_t* sources, size_t capacity,
                                   size_t* count) {
  return guarded([&] {
    require(count, "count is null");
    const auto object = model_table().pin(bits_of(model));
    require_handle(object, "model");
    const Mesh& mesh = object->model->mesh();
    const std::size_t rows = std::min(capacity, mesh.triangles.size());
    if (corners) copy_corners(mesh, rows, corners);
    if (sources) std::copy_n(mesh.source.begin(), rows, sources);
    *count = mesh.triangles.size();
  });
}
