#include "engine/scene/spring_match.h"

#include <algorithm>

namespace palpate {
namespace {

constexpr double kAlike = 0.9;  // cosine between directions that are nearly the same

bool same_features(const Lmd& one, const Lmd& other) {
  return one.feature_a == other.feature_a && one.feature_b == other.feature_b;
}

double squared_length(const DVec3& v) {
  return glm::dot(v, v);
}

// Squared, metres.
double gap(const Lmd& one, const Lmd& other) {
  return std::max(squared_length(one.point_a - other.point_a), squared_length(one.point_b - other.point_b));
}

// Springs slide over curved surfaces faster than the models move.
double reach_of(double moved, double cutoff) {
  return std::max(4.0 * moved, 0.25 * cutoff);
}

}  // namespace

bool is_beside(const HeldSpring& held, const Lmd& present, double reach) {
  if (glm::dot(held.at.normal, present.normal) < kAlike) return false;
  return same_features(held.at, present) || gap(held.at, present) <= reach * reach;
}

void SpringMatch::reserve(std::size_t springs) {
  before_.reserve(springs);
  after_.reserve(springs);
}

void SpringMatch::run(std::span<const HeldSpring> last, std::span<const Lmd> present, double cutoff) {
  before_.assign(present.size(), kNone);
  after_.assign(last.size(), kNone);
  match_features(last, present);
  spread_over_sets(last, present);
  match_nearest(last, present, cutoff);
  spread_over_sets(last, present);
}

// Both lists have much the same order, so that the next is mostly the one sought.
void SpringMatch::match_features(std::span<const HeldSpring> last, std::span<const Lmd> present) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < present.size(); ++k) {
    for (std::size_t tried = 0; tried < last.size(); ++tried) {
      const std::size_t i = next + tried < last.size() ? next + tried : next + tried - last.size();
      if (after_[i] != kNone || !same_features(last[i].at, present[k])) continue;
      join(i, k);
      next = i + 1 < last.size() ? i + 1 : 0;
      break;
    }
  }
}

void SpringMatch::match_nearest(std::span<const HeldSpring> last, std::span<const Lmd> present,
                                double cutoff) {
  for (std::size_t k = 0; k < present.size(); ++k) {
    if (before_[k] != kNone) continue;
    std::size_t nearest = last.size();
    double least = 0.0;
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (after_[i] != kNone || !is_beside(last[i], present[k], reach_of(last[i].moved, cutoff))) continue;
      const double here = gap(last[i].at, present[k]);
      if (nearest == last.size() || here < least) nearest = i, least = here;
    }
    if (nearest < last.size()) join(nearest, k);
  }
}

void SpringMatch::join(std::size_t last, std::size_t present) {
  after_[last] = static_cast<std::uint32_t>(present);
  before_[present] = static_cast<std::uint32_t>(last);
}

// A plateau goes on as a whole, though its points may be others.
void SpringMatch::spread_over_sets(std::span<const HeldSpring> last, std::span<const Lmd> present) {
  const auto spread = [](std::vector<std::uint32_t>& links, const auto& items, const auto& lmd_of) {
    for (std::size_t begin = 0, end; begin < items.size(); begin = end) {
      end = end_of_set(items, begin, lmd_of);
      const auto first = links.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto behind = links.begin() + static_cast<std::ptrdiff_t>(end);
      const auto linked = std::find_if(first, behind, [](std::uint32_t link) { return link != kNone; });
      if (linked != behind) std::replace(first, behind, kNone, *linked);
    }
  };
  spread(after_, last, [](const HeldSpring& held) -> const Lmd& { return held.at; });
  spread(before_, present, [](const Lmd& lmd) -> const Lmd& { return lmd; });
}

}  // namespace palpate
