#pragma once

#include "engine/mesh/clean_triangles.h"

namespace palpate {

// Drops the marked triangles; the others keep their order. Returns how many it dropped.
std::size_t drop_triangles(CleanTriangles& surface, const std::vector<bool>& dropped);

template <class Predicate>
std::size_t drop_triangles_if(CleanTriangles& surface, const Predicate& predicate) {
  std::vector<bool> dropped(surface.triangles.size());
  for (std::uint32_t t = 0; t < dropped.size(); ++t) dropped[t] = predicate(t);
  return drop_triangles(surface, dropped);
}

// Drops vertices that no triangle uses and numbers the others in the order of their first use.
void drop_unused_vertices(CleanTriangles& surface);

}  // namespace palpate
