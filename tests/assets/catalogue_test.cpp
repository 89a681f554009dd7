// What every named model promises: its counts, exact float32 positions, one closed outward surface where it
// says so.
#include "assets/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "assets/glb_writer.h"
#include "engine/math/box.h"
#include "surface_check.h"

namespace palpate::test {
namespace {

enum class Kind { kSolid, kOpen, kNonManifold, kOneSided };

struct Promise {
  const char* name;
  std::size_t triangles;
  std::size_t vertices;
  Kind kind;
  std::size_t components;
};

void PrintTo(const Promise& promise, std::ostream* out) {
  *out << promise.name;
}

constexpr Promise kPromises[] = {
    {"crankshaft_45k", 45000, 22502, Kind::kSolid, 1},
    {"gear_6k", 6300, 3150, Kind::kSolid, 1},
    {"spring_23k", 23500, 11752, Kind::kSolid, 1},
    {"teapot_5600", 5600, 2880, Kind::kOpen, 3},
    {"organic_97k", 97000, 48502, Kind::kSolid, 1},
    {"organic_2200", 2200, 1102, Kind::kSolid, 1},
    {"helicopter_113k", 113000, 56536, Kind::kSolid, 18},
    {"box", 12, 8, Kind::kSolid, 1},
    {"box_tessellated", 3072, 1538, Kind::kSolid, 1},
    {"flush_boxes", 24, 16, Kind::kSolid, 2},
    {"plate", 2496, 1250, Kind::kSolid, 1},
    {"tetrahedron", 4, 4, Kind::kSolid, 1},
    {"icosphere", 1280, 642, Kind::kSolid, 1},
    {"cylinder", 864, 434, Kind::kSolid, 1},
    {"torus", 4096, 2048, Kind::kSolid, 1},
    {"l_bracket", 20, 12, Kind::kSolid, 1},
    {"saddle", 2496, 1250, Kind::kSolid, 1},
    {"fan_200", 400, 202, Kind::kSolid, 1},
    {"nested_cavities", 11520, 5768, Kind::kSolid, 4},
    {"voxels", 1104, 554, Kind::kSolid, 2},
    {"voxels_nonmanifold", 1224, 541, Kind::kNonManifold, 2},
    {"slivers", 168, 86, Kind::kSolid, 1},
    {"open_sheet", 2048, 1089, Kind::kOpen, 1},
    {"two_sided_sheet", 2048, 1089, Kind::kOpen, 1},
    {"mobius_strip", 1920, 1080, Kind::kOneSided, 1},
};

std::uint64_t fnv1a(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return hash;
}

// Looks at the bits: GCC 12 may take (double)(float)x for x, and a comparison of the two would pass for any
// x.
bool is_float32(double value) {
  constexpr std::uint64_t kBitsBeyondFloat32 = (std::uint64_t{1} << 29) - 1;
  return (std::bit_cast<std::uint64_t>(value) & kBitsBeyondFloat32) == 0 &&
         (value == 0.0 || std::isnormal(float(value)));
}

class NamedModel : public testing::TestWithParam<Promise> {
 protected:
  TriangleSoup make() const { return find_asset(GetParam().name)->make(); }
};

class NamedSolid : public NamedModel {};

constexpr double kFold = -0.999;  // cosine between the normals of two triangles that lie on one another

std::vector<Promise> solids() {
  std::vector<Promise> result;
  std::ranges::copy_if(kPromises, std::back_inserter(result),
                       [](const Promise& p) { return p.kind == Kind::kSolid; });
  return result;
}

TEST(Catalogue, HoldsThePromisedModelsInOrder) {
  ASSERT_EQ(catalogue().size(), std::size(kPromises));
  for (std::size_t i = 0; i < std::size(kPromises); ++i) EXPECT_EQ(catalogue()[i].name, kPromises[i].name);
}

TEST(Catalogue, UnknownNameIsNull) {
  EXPECT_EQ(find_asset("no such model"), nullptr);
}

TEST_P(NamedModel, HasThePromisedCounts) {
  const TriangleSoup soup = make();
  EXPECT_EQ(soup.triangles.size(), GetParam().triangles);
  EXPECT_EQ(soup.positions.size(), GetParam().vertices);
  std::printf("%s: %zu triangles, %zu vertices\n", GetParam().name, soup.triangles.size(),
              soup.positions.size());
}

TEST_P(NamedModel, IsExactInFloat32AndUsesEveryVertex) {
  const TriangleSoup soup = make();
  for (const DVec3& p : soup.positions) {
    for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(is_float32(p[axis])) << p[axis];
  }
  std::vector<bool> used(soup.positions.size(), false);
  for (const auto& triangle : soup.triangles) {
    for (const auto corner : triangle) {
      ASSERT_LT(corner, used.size());
      used[corner] = true;
    }
  }
  EXPECT_TRUE(std::ranges::all_of(used, [](bool u) { return u; }));
}

TEST_P(NamedModel, IsHandHeldAroundTheOrigin) {
  Box bounds;
  for (const DVec3& p : make().positions) bounds.grow(p);
  const auto size = bounds.size();
  EXPECT_GE(std::max({size.x, size.y, size.z}), 0.09);
  EXPECT_LE(std::max({size.x, size.y, size.z}), 0.32);
  EXPECT_LE(glm::length(bounds.centre()), 0.15 * bounds.diagonal());
}

TEST_P(NamedModel, IsTheSurfaceItSays) {
  const SurfaceCheck check = check_surface(make());
  EXPECT_EQ(check.volumes.size(), GetParam().components);
  EXPECT_EQ(check.equal_positions, 0u);
  switch (GetParam().kind) {
    case Kind::kSolid:
      EXPECT_TRUE(check.closed_manifold())
          << check.degenerate_triangles << " degenerate, " << check.boundary_edges << " boundary, "
          << check.nonmanifold_edges << " non-manifold, " << check.inconsistent_edges << " inconsistent, "
          << check.pinched_vertices << " pinched";
      break;
    case Kind::kOpen:
      EXPECT_GT(check.boundary_edges, 0u);
      EXPECT_EQ(check.nonmanifold_edges + check.inconsistent_edges, 0u);
      break;
    case Kind::kNonManifold:
      EXPECT_EQ(check.boundary_edges, 0u);
      EXPECT_GT(check.nonmanifold_edges, 0u);
      EXPECT_GT(check.pinched_vertices, 0u);
      break;
    case Kind::kOneSided:
      EXPECT_GT(check.boundary_edges, 0u);
      EXPECT_GT(check.inconsistent_edges, 0u);
      EXPECT_EQ(check.nonmanifold_edges, 0u);
      break;
  }
}

TEST_P(NamedSolid, FacesOutwardWithoutFolds) {
  const SurfaceCheck check = check_surface(make());
  const auto inward = std::ranges::count_if(check.volumes, [](double volume) { return volume <= 0.0; });
  EXPECT_EQ(inward, std::string(GetParam().name) == "nested_cavities" ? 2 : 0);
  EXPECT_GT(check.sharpest_edge, kFold);
}

TEST_P(NamedModel, HasTheSameBytesEveryTime) {
  const std::uint64_t first = fnv1a(glb_bytes(make(), GetParam().name));
  EXPECT_EQ(first, fnv1a(glb_bytes(make(), GetParam().name)));
}

std::string name_of(const testing::TestParamInfo<Promise>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Assets, NamedModel, testing::ValuesIn(kPromises), name_of);
INSTANTIATE_TEST_SUITE_P(Assets, NamedSolid, testing::ValuesIn(solids()), name_of);

}  // namespace
}  // namespace palpate::test
