#include "engine/scene/body_ids.h"

namespace palpate {

BodyId BodyIds::take() {
  if (free_.empty()) {
    if (slots_.size() == kMaxBodies) return 0;
    free_.reserve(slots_.size() + 1);  // so that give_back() cannot throw
    slots_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t slot = free_.back();
  free_.pop_back();
  slots_[slot].taken = true;
  return BodyId{slots_[slot].generation} << 32 | slot;
}

void BodyIds::give_back_unused(BodyId id) {
  slots_[slot_of(id)].taken = false;
  free_.push_back(slot_of(id));
}

void BodyIds::give_back(BodyId id) {
  Slot& slot = slots_[slot_of(id)];
  slot.taken = false;
  // A slot whose generations are used up retires.
  if (++slot.generation != 0) free_.push_back(slot_of(id));
}

bool BodyIds::alive(BodyId id) const {
  const std::uint32_t slot = slot_of(id);
  return slot < slots_.size() && slots_[slot].taken && slots_[slot].generation == id >> 32;
}

}  // namespace palpate
