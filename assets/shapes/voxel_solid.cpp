#include "assets/shapes/voxel_solid.h"

#include <array>

#include "assets/shapes/random_numbers.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

constexpr int kSide = 8;  // cells along an edge of the block
constexpr double kCell = 0.02;

using Cell = std::array<int, 3>;

class VoxelGrid {
 public:
  bool filled(const Cell& at) const { return inside(at) && cells_[slot(at)]; }
  void fill(const Cell& at) { cells_[slot(at)] = true; }
  static bool inside(const Cell& at) {
    return at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < kSide && at[1] < kSide && at[2] < kSide;
  }

 private:
  static std::size_t slot(const Cell& at) {
    const auto x = static_cast<std::size_t>(at[0]), y = static_cast<std::size_t>(at[1]);
    return (static_cast<std::size_t>(at[2]) * kSide + y) * kSide + x;
  }
  std::array<bool, std::size_t{kSide} * kSide * kSide> cells_{};
};

// Calls visit(Cell) for every cell from `low` to `high`, the latter excluded.
template <class Visit>
void for_each_cell(int low, int high, Visit visit) {
  for (int z = low; z < high; ++z) {
    for (int y = low; y < high; ++y) {
      for (int x = low; x < high; ++x) visit(Cell{x, y, z});
    }
  }
}

// Cell k of the eight around a lattice point; bit i of k is the step along axis i.
Cell around(const Cell& corner, unsigned k) {
  return {corner[0] - 1 + int(k & 1u), corner[1] - 1 + int(k >> 1 & 1u), corner[2] - 1 + int(k >> 2 & 1u)};
}

// Whether the cells of a set of the eight are joined through common faces.
bool is_connected(unsigned set) {
  unsigned reached = set & (~set + 1u);
  for (int step = 0; step < 8; ++step) {
    unsigned grown = reached;
    for (unsigned k = 0; k < 8; ++k) {
      if (reached >> k & 1u) grown |= 1u << (k ^ 1u) | 1u << (k ^ 2u) | 1u << (k ^ 4u);
    }
    reached = grown & set;
  }
  return reached == set;
}

unsigned filled_around(const VoxelGrid& grid, const Cell& corner) {
  unsigned set = 0;
  for (unsigned k = 0; k < 8; ++k) set |= unsigned(grid.filled(around(corner, k))) << k;
  return set;
}

// The surface is a disc around a lattice point iff the filled cells there hang together, and the empty ones
// too; an edge where cells touch only along it shows as a broken set at its ends.
bool fill_pinches(VoxelGrid& grid) {
  bool changed = false;
  for_each_cell(0, kSide + 1, [&](const Cell& corner) {
    const unsigned set = filled_around(grid, corner);
    if (is_connected(set) && is_connected(~set & 0xffu)) return;
    for (unsigned k = 0; k < 8; ++k) {
      const Cell cell = around(corner, k);
      if (!VoxelGrid::inside(cell) || grid.filled(cell)) continue;
      grid.fill(cell);
      changed = true;
      return;
    }
  });
  return changed;
}

VoxelGrid random_grid(std::uint64_t seed) {
  constexpr double kDensity = 0.25;
  RandomNumbers random(seed);
  VoxelGrid grid;
  for_each_cell(0, kSide, [&](const Cell& cell) {
    if (random.unit() < kDensity) grid.fill(cell);
  });
  return grid;
}

// The face of a filled cell towards +axis or −axis.
void add_face(TriangleSoup& soup, const Cell& cell, int axis, int sign) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const auto base = static_cast<std::uint32_t>(soup.positions.size());
  for (const auto& [du, dv] : {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}}) {
    DVec3 corner(cell[0], cell[1], cell[2]);
    corner[axis] += sign > 0 ? 1 : 0;
    corner[u] += du;
    corner[v] += dv;
    soup.positions.push_back((corner - DVec3(0.5 * kSide)) * kCell);
  }
  TriangleSoup quad;
  quad.triangles = {{base, base + 1, base + 2}, {base, base + 2, base + 3}};
  if (sign < 0) turn_inside_out(quad);
  soup.triangles.insert(soup.triangles.end(), quad.triangles.begin(), quad.triangles.end());
}

}  // namespace

TriangleSoup voxel_solid(std::uint64_t seed, VoxelContact contact) {
  VoxelGrid grid = random_grid(seed);
  while (contact == VoxelContact::kFaces && fill_pinches(grid)) {
  }
  TriangleSoup soup;
  for_each_cell(0, kSide, [&](const Cell& cell) {
    if (!grid.filled(cell)) return;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int sign : {-1, 1}) {
        Cell neighbour = cell;
        neighbour[axis] += sign;
        if (!grid.filled(neighbour)) add_face(soup, cell, axis, sign);
      }
    }
  });
  return welded(soup);
}

}  // namespace palpate::shapes
