#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene/held_spring.h"

namespace palpate {

// Whether `present` is about where `held` is, and in nearly its direction. `reach` in metres.
bool is_beside(const HeldSpring& held, const Lmd& present, double reach);

// Which springs of the last step go on in this one: those on the same features, then sets with the nearest
// points. The order of both lists decides what is as near. Keeps its memory.
class SpringMatch {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  void reserve(std::size_t springs);
  // `last` has been moved to the present pose.
  void run(std::span<const HeldSpring> last, std::span<const Lmd> present, double cutoff);

  bool goes_on(std::size_t last) const { return after_[last] != kNone; }
  bool is_new(std::size_t present) const { return before_[present] == kNone; }
  std::uint32_t before(std::size_t present) const { return before_[present]; }

 private:
  void match_features(std::span<const HeldSpring> last, std::span<const Lmd> present);
  void match_nearest(std::span<const HeldSpring> last, std::span<const Lmd> present, double cutoff);
  void join(std::size_t last, std::size_t present);
  void spread_over_sets(std::span<const HeldSpring> last, std::span<const Lmd> present);

  std::vector<std::uint32_t> before_;  // of each present spring, the one of the last step
  std::vector<std::uint32_t> after_;   // of each spring of the last step, the present one
};

}  // namespace palpate
