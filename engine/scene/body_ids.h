#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/contacts.h"

namespace palpate {

inline std::uint32_t slot_of(BodyId id) {
  return static_cast<std::uint32_t>(id);
}

// Hands out ids: a slot and the slot's generation, so that the id of a body that was removed stays invalid.
class BodyIds {
 public:
  static constexpr std::size_t kMaxBodies = 1u << 24;

  BodyId take();  // 0 if there are too many
  void give_back(BodyId id);
  void give_back_unused(BodyId id);  // that nobody was told; may be handed out again
  bool alive(BodyId id) const;

 private:
  struct Slot {
    std::uint32_t generation = 1;
    bool taken = false;
  };

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
};

}  // namespace palpate
