#include "engine/scene/body_table.h"

#include <utility>

namespace palpate {

Body::Body(BodyOptions options) : options_(std::move(options)) {
  set_pose(options_.pose);
}

void Body::set_pose(const Pose& pose) {
  options_.pose = pose;
  moved = true;
  sphere_ = pose * Sphere{options_.model->centre(), options_.model->radius()};
}

void Body::leave() {
  if (!is_near) return;
  is_near = false;
  against_tool.ready() ? against_tool.rest() : against_tool.forget();
  springs.forget();
}

BodyId BodyTable::add(Body body) {
  auto placed = std::make_unique<Body>(std::move(body));
  const BodyId id = ids_.take();
  if (id == 0) return 0;
  placed->id = id;
  place(std::move(placed));
  return id;
}

bool BodyTable::remove(BodyId id) {
  if (!ids_.alive(id)) return false;
  take(id);
  ids_.give_back(id);
  return true;
}

void BodyTable::place(std::unique_ptr<Body> body) {
  const std::uint32_t slot = slot_of(body->id);
  if (slot >= slots_.size()) slots_.resize(slot + 1);
  if (!slots_[slot].body) ++size_;
  slots_[slot].body = std::move(body);
  may_be_near(slot);
}

std::unique_ptr<Body> BodyTable::take(BodyId id) {
  if (!find(id)) return nullptr;
  --size_;
  return std::move(slots_[slot_of(id)].body);
}

void BodyTable::move_to(Slots& larger) {
  larger.clear();
  for (Slot& slot : slots_) larger.push_back(std::move(slot));
  slots_.swap(larger);
}

Body* BodyTable::find(BodyId id) {
  return const_cast<Body*>(std::as_const(*this).find(id));
}

const Body* BodyTable::find(BodyId id) const {
  const std::uint32_t slot = slot_of(id);
  if (slot >= slots_.size()) return nullptr;
  const Body* body = slots_[slot].body.get();
  return body && body->id == id ? body : nullptr;
}

bool BodyTable::set_pose(BodyId id, const Pose& pose) {
  Body* body = find(id);
  if (!body) return false;
  body->set_pose(pose);
  may_be_near(slot_of(id));
  return true;
}

void BodyTable::may_be_near(std::uint32_t slot) {
  slots_[slot].far_until = 0.0;
  slots_[slot / kGroup * kGroup].group_until = 0.0;
}

void BodyTable::forget_far() {
  for (Slot& slot : slots_) slot.far_until = slot.group_until = 0.0;
}

}  // namespace palpate
