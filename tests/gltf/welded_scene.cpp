#include "tests/gltf/welded_scene.h"

namespace palpate::test {

WeldedScene weld(const GltfScene& scene) {
  const TriangleSoup soup = bake(scene);
  WeldedScene welded;
  welded.triangles = soup.triangles.size();
  for (const TriangleIndices& triangle : soup.triangles) {
    for (const std::uint32_t corner : triangle) {
      const DVec3& p = soup.positions[corner];
      // +0 turns −0 into 0.
      welded.vertices.insert(
          {static_cast<float>(p.x) + 0.0f, static_cast<float>(p.y) + 0.0f, static_cast<float>(p.z) + 0.0f});
      welded.box.grow(p);
    }
  }
  return welded;
}

}  // namespace palpate::test
