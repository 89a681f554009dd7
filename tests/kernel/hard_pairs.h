#pragma once

#include <vector>

#include "engine/math/triangle.h"

namespace palpate {

struct HardPair {
  Triangle first;
  Triangle second;
};

// Pairs of triangles of one difficulty each.
enum class Difficulty { kRandom, kNearParallel, kSlivers, kAxisAligned, kSegments, kPoints, kNear, kFar };
inline constexpr Difficulty kDifficulties[] = {
    Difficulty::kRandom,   Difficulty::kNearParallel, Difficulty::kSlivers, Difficulty::kAxisAligned,
    Difficulty::kSegments, Difficulty::kPoints,       Difficulty::kNear,    Difficulty::kFar};

const char* name_of(Difficulty difficulty);

// `scale` is the triangles' size, in whatever unit.
std::vector<HardPair> hard_pairs(Difficulty difficulty, double scale, std::size_t count, std::uint64_t seed);

}  // namespace palpate
