#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>

#include "engine/kernel/triangle_pair.h"
#include "engine/mesh/mesh.h"
#include "engine/snch/lmd.h"

namespace palpate {

// Where a minimum was: a pair of triangles, and the feature of each that holds it.
struct Seed {
  TrianglePair triangles;
  TrianglePlace at_a;
  TrianglePlace at_b;

  Seed(const Mesh& a, const Mesh& b, const Feature& feature_a, const Feature& feature_b)
      : triangles{triangles_at(a, feature_a).front(), triangles_at(b, feature_b).front()},
        at_a(place_of(a, feature_a, triangles.a)),
        at_b(place_of(b, feature_b, triangles.b)) {}

  // From where nothing is known but the triangles.
  explicit Seed(TrianglePair pair)
      : triangles(pair), at_a{TrianglePlace::kFace}, at_b{TrianglePlace::kFace} {}

  friend auto operator<=>(const Seed&, const Seed&) = default;

 private:
  static TrianglePlace place_of(const Mesh& mesh, const Feature& feature, std::uint32_t triangle) {
    const auto index_in = [&](const TriangleIndices& parts) {
      return static_cast<std::uint8_t>(std::find(parts.begin(), parts.end(), feature.index) - parts.begin());
    };
    switch (feature.kind) {
      case FeatureKind::kVertex:
        return {index_in(mesh.triangles[triangle])};
      case FeatureKind::kEdge:
        return {static_cast<std::uint8_t>(3 + index_in(mesh.triangle_edges[triangle]))};
      default:
        return {TrianglePlace::kFace};
    }
  }
};

}  // namespace palpate
