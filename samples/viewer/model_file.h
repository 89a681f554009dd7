#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/cli/handles.h"
#include "samples/viewer/geometry.h"

namespace palpate::viewer {

// A corner as it is drawn: a vertex, and one of the normals that it has where surfaces meet at an edge.
struct Corner {
  glm::vec3 position;  // from the model's centre, metres
  glm::vec3 normal;
};

// A model with all that is needed to draw it.
struct ModelFile {
  std::string name;  // of the file, without its folder
  cli::OwnedModel model;
  Vec3 low, high;  // metres
  std::vector<Corner> corners;
  std::vector<std::uint32_t> triangles;  // three corners of each

  std::size_t triangle_count() const { return triangles.size() / 3; }

  Vec3 centre() const { return 0.5 * (low + high); }
  double diagonal() const { return glm::length(high - low); }
};

// Loads a glTF file, `scale` times as large, and builds its hierarchies. Throws cli::Failure.
ModelFile load_model_file(const std::string& path, double scale);

}  // namespace palpate::viewer
