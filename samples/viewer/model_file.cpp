#include "samples/viewer/model_file.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "samples/viewer/smooth_normals.h"

namespace palpate::viewer {
namespace {

using cli::check;

struct Surface {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Surface surface_of(plp_model model) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  std::size_t vertices = 0, triangles = 0;
  check(plp_model_get_vertices(model, nullptr, 0, &vertices));
  check(plp_model_get_triangles(model, nullptr, nullptr, 0, &triangles));
  Surface surface;
  surface.vertices.resize(vertices);
  surface.triangles.resize(triangles);
  check(plp_model_get_vertices(model, &surface.vertices[0].x, vertices, &vertices));
  check(plp_model_get_triangles(model, surface.triangles[0].data(), nullptr, triangles, &triangles));
  return surface;
}

cli::OwnedModel load(const std::string& path, double scale) {
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.scale = scale;
  cli::OwnedModel model;
  check(plp_model_load_file(path.c_str(), &options, model.receive()));
  return model;
}

// Gives each vertex as many corners as it has normals.
class Corners {
 public:
  Corners(const Surface& surface, const Vec3& centre) : first_(surface.vertices.size(), kNone) {
    const std::vector<glm::vec3> normals = smooth_normals(surface.vertices, surface.triangles);
    indices.reserve(normals.size());
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t vertex : triangle) {
        const glm::vec3& normal = normals[indices.size()];
        indices.push_back(corner_of(vertex, {glm::vec3(surface.vertices[vertex] - centre), normal}));
      }
  }

  std::vector<Corner> corners;
  std::vector<std::uint32_t> indices;

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  std::uint32_t corner_of(std::uint32_t vertex, const Corner& wanted) {
    for (std::uint32_t i = first_[vertex]; i != kNone; i = next_[i])
      if (corners[i].normal == wanted.normal) return i;
    const auto added = static_cast<std::uint32_t>(corners.size());
    corners.push_back(wanted);
    next_.push_back(std::exchange(first_[vertex], added));
    return added;
  }

  std::vector<std::uint32_t> first_;  // by vertex: its newest corner
  std::vector<std::uint32_t> next_;   // by corner: an older one of its vertex
};

}  // namespace

ModelFile load_model_file(const std::string& path, double scale) {
  cli::OwnedModel model = load(path, scale);
  check(plp_model_prepare(model.get()));
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  check(plp_model_get_info(model.get(), &info));
  const Vec3 low = vector_of(info.bounds_min), high = vector_of(info.bounds_max);
  Corners drawn(surface_of(model.get()), 0.5 * (low + high));
  return {.name = std::filesystem::path(path).filename().string(),
          .model = std::move(model),
          .low = low,
          .high = high,
          .corners = std::move(drawn.corners),
          .triangles = std::move(drawn.indices)};
}

}  // namespace palpate::viewer
