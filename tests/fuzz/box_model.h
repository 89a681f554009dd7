#pragma once

#include <cstdint>

#include "palpate/palpate.h"

namespace palpate::fuzz {

constexpr std::uint64_t kBoxTriangles = 12;

// The first triangles of a box with edges of that length; null if they are refused.
plp_model box_model(float edge, std::uint64_t triangles = kBoxTriangles);

}  // namespace palpate::fuzz
