#include "assets/catalogue.h"

#include <algorithm>

#include "assets/shapes/box.h"
#include "assets/shapes/coil_spring.h"
#include "assets/shapes/crankshaft.h"
#include "assets/shapes/gear.h"
#include "assets/shapes/helicopter.h"
#include "assets/shapes/l_bracket.h"
#include "assets/shapes/organic.h"
#include "assets/shapes/platonic.h"
#include "assets/shapes/round_solids.h"
#include "assets/shapes/saddle.h"
#include "assets/shapes/sheet.h"
#include "assets/shapes/slivers.h"
#include "assets/shapes/teapot.h"
#include "assets/shapes/voxel_solid.h"

namespace palpate {
namespace {

constexpr std::uint64_t kVoxelSeed = 7;

constexpr Asset kAssets[] = {
    {"crankshaft_45k", [] { return shapes::crankshaft(); }},
    {"gear_6k", [] { return shapes::gear(); }},
    {"spring_23k", [] { return shapes::coil_spring(); }},
    {"teapot_5600", [] { return shapes::teapot(); }},
    {"organic_97k", [] { return shapes::organic(shapes::kOrganicFine); }},
    {"organic_2200", [] { return shapes::organic(shapes::kOrganicCoarse); }},
    {"helicopter_113k", [] { return shapes::helicopter(); }},
    {"box",
     [] {
       return shapes::box({0.1, 0.1, 0.1});
     }},
    {"box_tessellated",
     [] {
       return shapes::box({0.1, 0.1, 0.1}, {16, 16, 16});
     }},
    {"flush_boxes", [] { return shapes::flush_boxes(); }},
    {"plate", [] { return shapes::plate(); }},
    {"tetrahedron", [] { return shapes::tetrahedron(); }},
    {"icosphere", [] { return shapes::icosphere(); }},
    {"cylinder", [] { return shapes::cylinder(0.05, 0.2); }},
    {"torus", [] { return shapes::torus(0.1, 0.03); }},
    {"l_bracket", [] { return shapes::l_bracket(); }},
    {"saddle", [] { return shapes::saddle(); }},
    {"fan_200", [] { return shapes::fan(200); }},
    {"nested_cavities", [] { return shapes::nested_cavities(); }},
    {"voxels", [] { return shapes::voxel_solid(kVoxelSeed, shapes::VoxelContact::kFaces); }},
    {"voxels_nonmanifold", [] { return shapes::voxel_solid(kVoxelSeed, shapes::VoxelContact::kAnything); }},
    {"slivers", [] { return shapes::slivers(); }},
    {"open_sheet", [] { return shapes::open_sheet(); }},
    {"two_sided_sheet", [] { return shapes::two_sided_sheet(); }},
    {"mobius_strip", [] { return shapes::mobius_strip(); }},
};

}  // namespace

std::span<const Asset> catalogue() {
  return kAssets;
}

const Asset* find_asset(std::string_view name) {
  const auto found = std::ranges::find(kAssets, name, &Asset::name);
  return found == std::end(kAssets) ? nullptr : found;
}

}  // namespace palpate
