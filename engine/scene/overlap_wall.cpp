#include "engine/scene/overlap_wall.h"

#include <algorithm>

namespace palpate {
namespace {

bool is_there_again(const HeldSpring& wall, std::span<const Lmd> present, const SpringMatch& match,
                    double cutoff) {
  const double reach = std::max(4.0 * wall.moved, 0.125 * cutoff);
  for (std::size_t k = 0; k < present.size(); ++k)
    if (match.is_new(k) && is_beside(wall, present[k], reach)) return true;
  return false;
}

}  // namespace

void OverlapWall::advance(const Pose& body_from_tool, const HoldingStep& step) {
  for (HeldSpring& wall : walls_) {
    wall.move(body_from_tool);
    wall.share = std::min(1.0, wall.share + step.share);
  }
  std::erase_if(walls_, [&](const HeldSpring& wall) {
    return wall.at.distance >= step.cutoff || wall.moved > step.cutoff;
  });
}

void OverlapWall::release(std::span<const Lmd> present, const SpringMatch& match, const HoldingStep& step) {
  released_.clear();
  std::erase_if(walls_, [&](const HeldSpring& wall) {
    if (step.overlapping && !is_there_again(wall, present, match, step.cutoff)) return false;
    released_.push_back(wall);
    return true;
  });
}

void OverlapWall::hold(std::span<const HeldSpring> last, const SpringMatch& match, const HoldingStep& step) {
  for (std::size_t begin = 0, end; begin < last.size(); begin = end) {
    end = end_of_set(last, begin, [](const HeldSpring& held) -> const Lmd& { return held.at; });
    if (!match.goes_on(begin)) hold_set(last.subspan(begin, end - begin), step);
  }
}

// A plateau that goes in by some of its points is gone as a whole: those carry all of it.
void OverlapWall::hold_set(std::span<const HeldSpring> set, const HoldingStep& step) {
  double all = 0.0, inside = 0.0;
  for (const HeldSpring& spring : set) {
    all += spring.at.weight;
    if (spring.may_have_crossed()) inside += spring.at.weight;
  }
  for (const HeldSpring& spring : set) {
    if (!spring.may_have_crossed() || spring.moved > step.cutoff || walls_.size() == kMostHeld) continue;
    walls_.push_back(spring);
    walls_.back().at.weight *= all / inside;
    walls_.back().share = std::min(1.0, spring.share + step.share);
  }
}

}  // namespace palpate
