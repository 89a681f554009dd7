#pragma once

#include <span>
#include <string_view>

#include "engine/mesh/triangle_soup.h"

namespace palpate {

// A model by name, generated when asked for.
struct Asset {
  std::string_view name;  // its file is <name>.glb
  TriangleSoup (*make)();
};

// Every named model, in the order of assets/README.md.
std::span<const Asset> catalogue();

// The entry of that name, or null.
const Asset* find_asset(std::string_view name);

}  // namespace palpate
