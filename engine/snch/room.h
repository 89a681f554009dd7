#pragma once

#include <cstddef>
#include <vector>

namespace palpate {

// Memory of a search between two models that may not allocate while it runs.
struct Room {
  std::size_t front = 16'384;  // pairs of nodes on a kinetic front
  std::size_t minima = 4'096;
  std::size_t overlaps = 1'024;  // listed
};

// Near minima that a search finds at most whose memory is fixed.
inline constexpr std::size_t kNearRoom = 4'096;

// What a traversal of two trees keeps open: as many batches as both are deep, about a hundred.
inline constexpr std::size_t kOpenRoom = 4'096;

// Whether `count` more items fit in without allocating.
template <class T>
bool has_room(const std::vector<T>& items, std::size_t count) {
  return items.capacity() - items.size() >= count;
}

// Whether an outgrown vector should be replaced soon.
template <class T>
bool is_tight(const std::vector<T>& items) {
  return items.size() > items.capacity() / 2;
}

}  // namespace palpate
