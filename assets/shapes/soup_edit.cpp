#include "assets/shapes/soup_edit.h"

#include <map>
#include <utility>

namespace palpate::shapes {
namespace {

// GCC 12's vectoriser takes (double)(float)x for x (-O2 and up); a volatile float it has to store. +0 turns
// −0 to 0.
double rounded_to_float32(double value) {
  const volatile float narrow = static_cast<float>(value);
  return narrow + 0.0;
}

}  // namespace

void append(TriangleSoup& soup, const TriangleSoup& part) {
  const auto base = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), part.positions.begin(), part.positions.end());
  for (const auto& [a, b, c] : part.triangles) soup.triangles.push_back({base + a, base + b, base + c});
}

void turn_inside_out(TriangleSoup& soup) {
  for (auto& [a, b, c] : soup.triangles) std::swap(b, c);
}

void translate(TriangleSoup& soup, const DVec3& offset) {
  for (auto& position : soup.positions) position += offset;
}

TriangleSoup rounded_to_float32(TriangleSoup soup) {
  for (auto& p : soup.positions) {
    p = {rounded_to_float32(p.x), rounded_to_float32(p.y), rounded_to_float32(p.z)};
  }
  return soup;
}

TriangleSoup welded(const TriangleSoup& soup) {
  const TriangleSoup rounded = rounded_to_float32(soup);
  std::map<std::array<double, 3>, std::uint32_t> vertex_at;
  TriangleSoup result;
  result.double_sided = rounded.double_sided;
  for (const auto& triangle : rounded.triangles) {
    TriangleIndices corners{};
    for (int k = 0; k < 3; ++k) {
      const DVec3& p = rounded.positions[triangle[k]];
      const auto next = static_cast<std::uint32_t>(result.positions.size());
      const auto [entry, is_new] = vertex_at.try_emplace({p.x, p.y, p.z}, next);
      if (is_new) result.positions.push_back(p);
      corners[k] = entry->second;
    }
    result.triangles.push_back(corners);
  }
  return result;
}

}  // namespace palpate::shapes
