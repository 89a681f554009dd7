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
  slots_[slot] = std::move(body);
}

std::unique_ptr<Body> BodyTable::take(BodyId id) {
  return find(id) ? std::move(slots_[slot_of(id)]) : nullptr;
}

void BodyTable::move_to(Slots& larger) {
  larger.clear();
  for (std::unique_ptr<Body>& body : slots_) larger.push_back(std::move(body));
  slots_.swap(larger);
}

Body* BodyTable::find(BodyId id) {
  return const_cast<Body*>(std::as_const(*this).find(id));
}

const Body* BodyTable::find(BodyId id) const {
  const std::uint32_t slot = slot_of(id);
  return slot < slots_.size() && slots_[slot] && slots_[slot]->id == id ? slots_[slot].get() : nullptr;
}

}  // namespace palpate
