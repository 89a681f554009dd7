#include "engine/mesh/geometry_hash.h"

#include <bit>

namespace palpate {
namespace {

// Not cryptographic: a multiplication and a shift for each word.
class Hash {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 32;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t geometry_hash(const Mesh& mesh) {
  Hash hash;
  hash.add(static_cast<double>(mesh.frame.scale));
  for (int i = 0; i < 3; ++i) hash.add(static_cast<double>(mesh.frame.origin[i]));
  hash.add(std::uint64_t{mesh.positions.size()});
  for (const Vec3& position : mesh.positions)
    for (int i = 0; i < 3; ++i) hash.add(std::uint64_t{std::bit_cast<std::uint32_t>(position[i])});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) hash.add(std::uint64_t{vertex});
    hash.add(std::uint64_t{!mesh.double_sided.empty() && mesh.double_sided[t]});
  }
  return hash.value();
}

}  // namespace palpate
