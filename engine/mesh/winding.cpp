#include "engine/mesh/winding.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/mesh/area.h"
#include "engine/mesh/nesting.h"
#include "engine/mesh/patches.h"
#include "engine/mesh/report_notes.h"

namespace palpate {
namespace {

// Sums of areas in different orders agree to better than this; what is closer counts as equal.
constexpr double kAreaTie = 1e-9;

void reverse(TriangleIndices& triangle) {
  std::swap(triangle[1], triangle[2]);
}

// Settles which way round each patch is wound: as the larger part of its area was, or its first triangle.
void follow_majority(const CleanTriangles& surface, Patches& patches) {
  for (std::size_t patch = 0; patch < patches.triangles.size(); ++patch) {
    double area[2] = {0, 0};
    for (std::uint32_t t : patches.triangles[patch])
      area[patches.turned[t]] += glm::length(area_vector(surface.positions, surface.triangles[t]));
    if (area[1] <= area[0] * (1 + kAreaTie)) continue;
    for (std::uint32_t t : patches.triangles[patch]) patches.turned[t] = !patches.turned[t];
  }
}

// Marks the patches around an edge that do not run along it equally often both ways.
class BalanceCheck {
 public:
  BalanceCheck(const Patches& patches, std::vector<bool>& closed) : patches_(patches), closed_(closed) {}

  void operator()(std::span<const EdgeUse> uses) {
    directions_.clear();
    for (const EdgeUse& use : uses) {
      const bool ascending = use.ascending() != patches_.turned[use.triangle()];
      directions_.push_back({patches_.of_triangle[use.triangle()], ascending ? 1 : -1});
    }
    std::ranges::sort(directions_);
    for (std::size_t i = 0; i < directions_.size();) {
      const std::uint32_t patch = directions_[i].first;
      int balance = 0;
      for (; i < directions_.size() && directions_[i].first == patch; ++i) balance += directions_[i].second;
      if (balance != 0) closed_[patch] = false;
    }
  }

 private:
  const Patches& patches_;
  std::vector<bool>& closed_;
  std::vector<std::pair<std::uint32_t, int>> directions_;
};

std::vector<bool> closed_patches(const EdgeUses& edges, const Patches& patches) {
  std::vector<bool> closed(patches.triangles.size(), true);
  BalanceCheck check(patches, closed);
  edges.for_each_edge([&](std::span<const EdgeUse> uses) { check(uses); });
  return closed;
}

Shell shell_of(const CleanTriangles& surface, std::span<const std::uint32_t> triangles) {
  Shell shell{triangles, {}, 0.0};
  const DVec3 apex(surface.positions[surface.triangles[triangles.front()][0]]);
  for (std::uint32_t t : triangles) {
    for (std::uint32_t vertex : surface.triangles[t]) shell.box.grow(DVec3(surface.positions[vertex]));
    shell.volume += apex_volume(surface.positions, surface.triangles[t], apex);
  }
  return shell;
}

std::vector<Shell> shells_of(const CleanTriangles& surface, const Patches& patches,
                             const std::vector<bool>& closed) {
  std::vector<Shell> shells;
  for (std::size_t patch = 0; patch < closed.size(); ++patch)
    if (closed[patch]) shells.push_back(shell_of(surface, patches.triangles[patch]));
  std::ranges::stable_sort(shells, std::greater<>{},
                           [](const Shell& shell) { return std::abs(shell.volume); });
  return shells;
}

// Whether each shell is to face outward. `parents` come before their children.
std::vector<bool> outward_facing(const std::vector<Shell>& shells,
                                 const std::vector<std::uint32_t>& parents) {
  std::vector<bool> outward(shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const bool was_outward = shells[i].volume >= 0;
    if (parents[i] == kNoShell) {
      outward[i] = true;
    } else if (was_outward != (shells[parents[i]].volume >= 0)) {
      outward[i] = !outward[parents[i]];
    } else {
      outward[i] = !outward[parents[i]] || was_outward;
    }
  }
  return outward;
}

// Returns how many shells it turned.
std::uint64_t face_shells(CleanTriangles& surface, const std::vector<Shell>& shells,
                          std::vector<bool>& turned) {
  const std::vector<bool> outward =
      outward_facing(shells, enclosing_shells(surface.positions, surface.triangles, shells));
  std::uint64_t flipped = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (outward[i] == (shells[i].volume >= 0)) continue;
    ++flipped;
    for (std::uint32_t t : shells[i].triangles) {
      reverse(surface.triangles[t]);
      turned[t] = !turned[t];
    }
  }
  return flipped;
}

}  // namespace

void orient(CleanTriangles& surface, MeshReport& report) {
  const EdgeUses edges(surface.positions.size(), surface.triangles);
  Patches patches = patches_of(edges, surface.triangles.size());
  follow_majority(surface, patches);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (patches.turned[t]) reverse(surface.triangles[t]);
  const std::vector<Shell> shells = shells_of(surface, patches, closed_patches(edges, patches));
  report.flipped_components = face_shells(surface, shells, patches.turned);
  report.reversed_triangles = std::ranges::count(patches.turned, true);
  if (patches.one_sided > 0)
    report.notes.push_back("Kept the winding of " + counted(patches.one_sided, "part", "parts") +
                           " of the surface that, like a Möbius strip, cannot be wound consistently.");
}

}  // namespace palpate
