#include "engine/mesh/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace palpate {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

std::uint64_t hash(const Vec3& p) {
  const auto x = std::bit_cast<std::uint32_t>(p.x), y = std::bit_cast<std::uint32_t>(p.y);
  return mix(mix(std::uint64_t{x} << 32 | y) + std::bit_cast<std::uint32_t>(p.z));
}

// Turns −0 into 0, so that equal positions have equal bits.
Vec3 without_negative_zero(const Vec3& p) {
  return p + 0.0f;
}

// Numbers positions of different bits in the order in which they come: a hash table with open addressing, at
// most half full.
class PositionTable {
 public:
  explicit PositionTable(std::size_t most) : slots_(std::bit_ceil(2 * most + 1), kNone) {}

  std::uint32_t number_of(const Vec3& position) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(position) & mask;
    while (slots_[slot] != kNone && positions_[slots_[slot]] != position) slot = (slot + 1) & mask;
    if (slots_[slot] == kNone) {
      slots_[slot] = static_cast<std::uint32_t>(positions_.size());
      positions_.push_back(position);
    }
    return slots_[slot];
  }
  std::vector<Vec3>& positions() { return positions_; }

 private:
  std::vector<std::uint32_t> slots_;
  std::vector<Vec3> positions_;
};

// The vertices kept so far, in cubic cells that are not smaller than the tolerance; cells share buckets.
class NearGrid {
 public:
  NearGrid(double tolerance, std::size_t most)
      : tolerance_(tolerance),
        cell_(std::max(kMargin * tolerance, kMinCell)),
        heads_(std::bit_ceil(most + 1), kNone) {}

  // The lowest-numbered vertex within the tolerance of `position`, or kNone.
  std::uint32_t find(const Vec3& position) const {
    std::uint32_t earliest = kNone;
    const std::array<double, 3> centre = cell_of(position);
    for (int i = 0; i < 27; ++i) {
      const int column = i % 3, row = i / 3 % 3, layer = i / 9;
      const std::array<double, 3> cell{centre[0] + column - 1, centre[1] + row - 1, centre[2] + layer - 1};
      for (std::uint32_t v = heads_[bucket(cell)]; v != kNone; v = next_[v])
        if (v < earliest && glm::distance(DVec3(positions_[v]), DVec3(position)) <= tolerance_) earliest = v;
    }
    return earliest;
  }
  std::uint32_t add(const Vec3& position) {
    const auto number = static_cast<std::uint32_t>(positions_.size());
    std::uint32_t& head = heads_[bucket(cell_of(position))];
    positions_.push_back(position);
    next_.push_back(head);
    head = number;
    return number;
  }
  std::vector<Vec3>& positions() { return positions_; }

 private:
  // Cell numbers stay below 2^41, so they are exact integers; the margin covers the rounding of the division.
  static constexpr double kMinCell = 1.0 / (1ull << 40);
  static constexpr double kMargin = 1.001;

  std::array<double, 3> cell_of(const Vec3& p) const {
    return {std::floor(p.x / cell_), std::floor(p.y / cell_), std::floor(p.z / cell_)};
  }
  std::size_t bucket(const std::array<double, 3>& cell) const {
    std::uint64_t sum = 0;
    for (double coordinate : cell)
      sum = mix(sum + static_cast<std::uint64_t>(static_cast<std::int64_t>(coordinate)));
    return sum & (heads_.size() - 1);
  }

  double tolerance_;
  double cell_;
  std::vector<std::uint32_t> heads_;  // by bucket: the newest vertex
  std::vector<std::uint32_t> next_;   // by vertex: an older one of its bucket
  std::vector<Vec3> positions_;
};

}  // namespace

CleanTriangles weld_equal(const TriangleSoup& soup, const ModelFrame& frame) {
  CleanTriangles surface;
  surface.frame = frame;
  surface.triangles = soup.triangles;
  PositionTable table(std::min(soup.positions.size(), 3 * soup.triangles.size()));
  std::vector<std::uint32_t> number_of(soup.positions.size(), kNone);
  for (TriangleIndices& triangle : surface.triangles) {
    for (std::uint32_t& vertex : triangle) {
      std::uint32_t& number = number_of[vertex];
      if (number == kNone)
        number = table.number_of(without_negative_zero(frame.normalised(soup.positions[vertex])));
      vertex = number;
    }
  }
  surface.positions = std::move(table.positions());
  surface.double_sided = soup.double_sided;
  surface.double_sided.resize(soup.triangles.size());
  surface.source.resize(soup.triangles.size());
  std::iota(surface.source.begin(), surface.source.end(), 0u);
  return surface;
}

std::uint64_t weld_near(CleanTriangles& surface, double tolerance) {
  NearGrid grid(tolerance, surface.positions.size());
  std::vector<std::uint32_t> number_of;
  number_of.reserve(surface.positions.size());
  for (const Vec3& position : surface.positions) {
    const std::uint32_t near = grid.find(position);
    number_of.push_back(near != kNone ? near : grid.add(position));
  }
  for (TriangleIndices& triangle : surface.triangles)
    for (std::uint32_t& vertex : triangle) vertex = number_of[vertex];
  surface.positions = std::move(grid.positions());
  return number_of.size() - surface.positions.size();
}

}  // namespace palpate
