#include "engine/scene/body_table.h"

#include <utility>

namespace palpate {

Body::Body(BodyOptions options) : options_(std::move(options)) {
  set_pose(options_.pose);
}

void Body::set_pose(const Pose& pose) {
  options_.pose = pose;
  sphere_ = pose * Sphere{options_.model->centre(), options_.model->radius()};
}

BodyId BodyTable::add(Body body) {
  auto placed = std::make_unique<Body>(std::move(body));
  if (free_.empty()) {
    if (slots_.size() == kMaxBodies) return 0;
    free_.reserve(slots_.size() + 1);  // so that remove() cannot throw
    slots_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t slot = free_.back();
  free_.pop_back();
  slots_[slot].body = std::move(placed);
  return id_of(slot);
}

bool BodyTable::remove(BodyId id) {
  if (!find(id)) return false;
  const auto slot = static_cast<std::uint32_t>(id);
  slots_[slot].body.reset();
  // A slot whose generations are used up retires.
  if (++slots_[slot].generation != 0) free_.push_back(slot);
  return true;
}

Body* BodyTable::find(BodyId id) {
  return const_cast<Body*>(std::as_const(*this).find(id));
}

const Body* BodyTable::find(BodyId id) const {
  const auto slot = static_cast<std::uint32_t>(id);
  return slot < slots_.size() && id_of(slot) == id ? slots_[slot].body.get() : nullptr;
}

}  // namespace palpate
