#include "engine/scene/pair_springs.h"

#include <algorithm>
#include <utility>

namespace palpate {
namespace {

double share_of_step(const SpringSituation& situation) {
  return situation.fade_time > situation.time_step ? situation.time_step / situation.fade_time : 1.0;
}

// A hand does not go farther than the cutoff in one step: then it was put there, and has no velocity.
DVec3 velocity_at(const DVec3& point, const StepMotion& motion, const SpringSituation& situation) {
  const DVec3 moved = motion.at(point);
  if (!(glm::length(moved) <= situation.cutoff)) return DVec3(0.0);
  return moved / situation.time_step;
}

}  // namespace

void PairSprings::reserve(std::size_t springs) {
  last_.reserve(springs);
  shares_.reserve(springs);
  match_.reserve(springs);
  walls_.reserve();
  fade_.reserve();
  list_.reserve(springs + 2 * kMostHeld);
}

std::size_t PairSprings::make_room(std::size_t present) {
  if (present > last_.capacity()) reserve(2 * present);
  return present + last_.size() + walls_.list().size() + fade_.list().size();
}

void PairSprings::move_to(PairSprings& larger) {
  larger = *this;
  std::swap(*this, larger);
}

void PairSprings::forget() {
  known_ = changing_ = false;
  last_.clear();
  walls_.forget();
  fade_.forget();
}

void PairSprings::update(std::span<const Lmd> present, const SpringSituation& situation) {
  if (may_lose_ && !situation.may_lose) {  // from now on nothing is lost: what fades ends here
    fade_.forget();
    changing_ = false;
  }
  motion_ = known_ ? StepMotion(pose_, situation.body_from_tool) : StepMotion();
  shares_.assign(present.size(), 1.0);
  if (known_ && is_holding(situation))
    hold(present, situation, {situation.cutoff, share_of_step(situation), situation.overlapping});
  remember(present, situation);
  make_list(situation);
}

bool PairSprings::is_holding(const SpringSituation& situation) const {
  return situation.overlapping || situation.may_lose || changing_ || is_walled() || !fade_.list().empty();
}

void PairSprings::hold(std::span<const Lmd> present, const SpringSituation& situation,
                       const HoldingStep& step) {
  for (HeldSpring& spring : last_) spring.move(situation.body_from_tool);
  match_.run(last_, present, situation.cutoff);
  fade_.advance(situation.body_from_tool, step);
  walls_.advance(situation.body_from_tool, step);
  walls_.release(present, match_, step);
  end_walls(present, situation, step);
  if (step.overlapping) walls_.hold(last_, match_, step);
  if (situation.may_lose) fade_.add_lost(last_, match_, step);
  share_out(present, step);
}

// A wall hands over to the LMD at its place. After sliding they may differ: then one fades and the other
// comes.
void PairSprings::end_walls(std::span<const Lmd> present, const SpringSituation& situation,
                            const HoldingStep& step) {
  comes_in_ = situation.may_lose;
  if (walls_.released().empty()) return;
  comes_in_ = !replaces_walls(present, step);
  if (comes_in_)
    for (const HeldSpring& wall : walls_.released()) fade_.add(wall, step);
}

// Whether what is new pushes as the walls that ended did, as far as the motion explains.
bool PairSprings::replaces_walls(std::span<const Lmd> present, const HoldingStep& step) const {
  DVec3 change(0.0);
  double moved = 0.0;
  for (const HeldSpring& wall : walls_.released()) {
    change -= wall.share * wall.at.weight * (step.cutoff - wall.at.distance) * wall.at.normal;
    moved = std::max(moved, wall.moved);
  }
  for (std::size_t k = 0; k < present.size(); ++k)
    if (match_.is_new(k))
      change += present[k].weight * (step.cutoff - present[k].distance) * present[k].normal;
  return glm::length(change) <= moved + 1e-9 * step.cutoff;
}

void PairSprings::share_out(std::span<const Lmd> present, const HoldingStep& step) {
  for (std::size_t begin = 0, end; begin < present.size(); begin = end) {
    end = end_of_set(present, begin, [](const Lmd& lmd) -> const Lmd& { return lmd; });
    const double share = share_of(present.subspan(begin, end - begin), begin, step);
    std::fill(shares_.begin() + static_cast<std::ptrdiff_t>(begin),
              shares_.begin() + static_cast<std::ptrdiff_t>(end), share);
  }
}

double PairSprings::share_of(std::span<const Lmd> set, std::size_t begin, const HoldingStep& step) const {
  if (!match_.is_new(begin)) return std::min(1.0, last_[match_.before(begin)].share + step.share);
  const double moved = glm::length(motion_.at(set.front().point_b));
  return comes_in_ && moved <= step.cutoff && is_late(set, moved, step.cutoff) ? step.share : 1.0;
}

void PairSprings::remember(std::span<const Lmd> present, const SpringSituation& situation) {
  const Pose tool_from_body = inverse(situation.body_from_tool);
  last_.clear();
  changing_ = false;
  for (std::size_t k = 0; k < present.size(); ++k) {
    last_.push_back({present[k], tool_from_body * present[k].point_b, shares_[k]});
    changing_ |= shares_[k] < 1.0;
  }
  pose_ = situation.body_from_tool;
  may_lose_ = situation.may_lose;
  known_ = true;
}

void PairSprings::make_list(const SpringSituation& situation) {
  list_.clear();
  const auto add = [&](const HeldSpring& spring, bool is_held) {
    Lmd at = spring.at;
    at.weight *= spring.share;
    list_.push_back({at, velocity_at(at.point_b, motion_, situation), is_held});
  };
  for (const HeldSpring& spring : last_) add(spring, false);
  for (const HeldSpring& wall : walls_.list()) add(wall, true);
  for (const HeldSpring& spring : fade_.list()) add(spring, true);
}

}  // namespace palpate
