#include "engine/scene/spring_fade.h"

#include <algorithm>

namespace palpate {

void SpringFade::advance(const Pose& body_from_tool, const HoldingStep& step) {
  for (HeldSpring& spring : fading_) {
    spring.move(body_from_tool);
    spring.share -= step.share;
  }
  std::erase_if(fading_, [&](const HeldSpring& spring) {
    constexpr double kFaded = 1e-9;
    return spring.share <= kFaded || spring.at.distance >= step.cutoff || spring.moved > step.cutoff;
  });
}

void SpringFade::add(const HeldSpring& spring, const HoldingStep& step) {
  if (fading_.size() == kMostHeld || spring.share <= step.share) return;
  fading_.push_back(spring);
  fading_.back().share -= step.share;
}

void SpringFade::add_lost(std::span<const HeldSpring> last, const SpringMatch& match,
                          const HoldingStep& step) {
  for (std::size_t begin = 0, end; begin < last.size(); begin = end) {
    end = end_of_set(last, begin, [](const HeldSpring& held) -> const Lmd& { return held.at; });
    const auto set = last.subspan(begin, end - begin);
    if (match.goes_on(begin) || (step.overlapping && becomes_wall(set))) continue;
    for (const HeldSpring& spring : set)
      if (spring.at.distance < step.cutoff && spring.moved <= step.cutoff) add(spring, step);
  }
}

bool is_late(std::span<const Lmd> set, double moved, double cutoff) {
  constexpr double kJustBegun = 0.0625;  // of the cutoff
  double compression = 0.0;
  for (const Lmd& spring : set) compression += spring.weight * (cutoff - spring.distance);
  return compression > std::max(2.0 * moved, kJustBegun * cutoff);
}

}  // namespace palpate
