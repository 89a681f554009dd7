#include "tests/bench/decimate.h"

#include <meshoptimizer.h>

#include "tests/support/models.h"

namespace palpate::bench {

std::shared_ptr<const Model> decimated(const Model& model, std::size_t divisor) {
  const Mesh& mesh = model.mesh();
  const std::size_t count = 3 * mesh.triangles.size();
  constexpr float kAnyError = 1.0f;
  TriangleSoup soup;
  soup.triangles.resize(mesh.triangles.size());
  const std::size_t kept = meshopt_simplify(soup.triangles.front().data(), mesh.triangles.front().data(),
                                            count, &mesh.positions.front().x, mesh.positions.size(),
                                            sizeof(Vec3), count / divisor, kAnyError, 0, nullptr);
  soup.triangles.resize(kept / 3);
  for (const Vec3& position : mesh.positions) soup.positions.push_back(mesh.frame.metres(DVec3(position)));
  return make_model(soup);
}

}  // namespace palpate::bench
