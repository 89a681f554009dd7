#include "engine/gltf/mesh_reader.h"

#include <cmath>

#include "engine/gltf/load_error.h"
#include "engine/gltf/morph_targets.h"
#include "engine/gltf/primitive_source.h"
#include "engine/gltf/vertex_selection.h"

namespace palpate::gltf {
namespace {

TriangleMode triangle_mode(int mode) {
  switch (mode) {
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      return TriangleMode::kStrip;
    case TINYGLTF_MODE_TRIANGLE_FAN:
      return TriangleMode::kFan;
    default:
      return TriangleMode::kList;
  }
}

std::vector<DVec3> select(const AttributeTable& table, const VertexSelection& selection) {
  std::vector<DVec3> positions;
  positions.reserve(selection.size());
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const double* row = table.row(selection[i]);
    positions.emplace_back(row[0], row[1], row[2]);
  }
  return positions;
}

void check_finite(const std::vector<DVec3>& positions, const VertexSelection& selection) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const DVec3& p = positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      fail(ErrorCode::kNonFinite, "vertex ", selection[i], " is not finite");
  }
}

void append(const std::vector<DVec3>& positions, const std::vector<TriangleIndices>& triangles,
            bool double_sided, TriangleSoup& soup) {
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), positions.begin(), positions.end());
  if (double_sided) soup.double_sided.resize(soup.triangles.size(), false);
  for (const TriangleIndices& triangle : triangles)
    soup.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  if (double_sided || !soup.double_sided.empty())
    soup.double_sided.resize(soup.triangles.size(), double_sided);
}

}  // namespace

TriangleSoup MeshReader::read(int mesh, const std::vector<double>& weights, const Skin* skin) {
  const auto at = static_cast<std::size_t>(mesh);
  if (at >= document_.model.meshes.size()) fail(ErrorCode::kBadFormat, "mesh ", mesh, " does not exist");
  const std::vector<tinygltf::Primitive>& primitives = document_.model.meshes[at].primitives;
  TriangleSoup soup;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const std::string place = sentence("mesh ", mesh, " primitive");
    within(place.c_str(), i, [&] {
      if (holds_triangles(primitives[i], sentence(place, ' ', i)))
        read_primitive(primitives[i], document_.primitive_extras[at][i], weights, skin, soup);
    });
  }
  return soup;
}

bool MeshReader::holds_triangles(const tinygltf::Primitive& primitive, const std::string& place) {
  if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    fail(ErrorCode::kBadFormat, "mode ", primitive.mode, " is not known");
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    ++skipped_;
    notes_.push_back(place + " holds points or lines and was skipped.");
    return false;
  }
  if (primitive.attributes.contains("POSITION")) return true;
  notes_.push_back(place + " has no positions and was skipped.");
  return false;
}

void MeshReader::read_primitive(const tinygltf::Primitive& primitive, const PrimitiveExtra& extra,
                                const std::vector<double>& weights, const Skin* skin, TriangleSoup& soup) {
  const PrimitiveSource source(primitive, extra, accessors_, budget_);
  const auto table = source.positions();
  const std::size_t vertices = table->rows();
  std::vector<TriangleIndices> triangles = source.triangles(triangle_mode(primitive.mode), vertices);
  budget_.require_triangles(soup.triangles.size() + triangles.size());

  const VertexSelection selection(vertices, triangles);
  std::vector<DVec3> positions = select(*table, selection);
  apply_morph_targets(primitive, weights, accessors_, vertices, selection, positions);
  if (skin != nullptr) skin->apply(source, vertices, selection, positions, triangles);
  check_finite(positions, selection);
  append(positions, triangles, is_double_sided(primitive), soup);
}

bool MeshReader::is_double_sided(const tinygltf::Primitive& primitive) const {
  if (primitive.material < 0) return false;
  const auto at = static_cast<std::size_t>(primitive.material);
  if (at >= document_.model.materials.size())
    fail(ErrorCode::kBadFormat, "material ", primitive.material, " does not exist");
  return document_.model.materials[at].doubleSided;
}

}  // namespace palpate::gltf
