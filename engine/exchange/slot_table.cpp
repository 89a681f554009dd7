#include "engine/exchange/slot_table.h"

#include <algorithm>
#include <cassert>

namespace palpate {
namespace {

constexpr int kSlotBits = 20;
constexpr int kKindShift = 56;
constexpr std::uint32_t kNoSlot = UINT32_MAX;

constexpr std::uint64_t kOnePin = 1;
constexpr std::uint64_t kOneReference = 1ull << 16;
constexpr std::uint32_t kMaxCount = 0xffff;
constexpr int kGenerationShift = 32;

std::uint32_t pins(std::uint64_t state) {
  return state & kMaxCount;
}

std::uint32_t references(std::uint64_t state) {
  return (state / kOneReference) & kMaxCount;
}

std::uint32_t generation(std::uint64_t state) {
  return static_cast<std::uint32_t>(state >> kGenerationShift);
}

std::uint32_t slot_of(SlotTable::Handle handle) {
  return handle & (SlotTable::kMaxSlots - 1);
}

std::uint32_t generation_of(SlotTable::Handle handle) {
  return static_cast<std::uint32_t>(handle >> kSlotBits);
}

SlotTable::Handle handle_of(std::uint8_t kind, std::uint32_t generation, std::uint32_t slot) {
  return std::uint64_t{kind} << kKindShift | std::uint64_t{generation} << kSlotBits | slot;
}

bool alive(std::uint64_t state, SlotTable::Handle handle) {
  return generation(state) == generation_of(handle) && references(state) > 0;
}

}  // namespace

SlotTable::SlotTable(std::uint8_t kind, Destroy destroy, const Limits& limits)
    : kind_(kind),
      destroy_(destroy),
      limits_{std::min(limits.slots, kMaxSlots), std::min(limits.generations, UINT32_MAX - 1)} {
  assert(kind != 0);
}

SlotTable::~SlotTable() {
  for (const auto& chunk : owned_chunks_) {
    for (Slot& slot : *chunk) {
      if (slot.object) destroy_(slot.object);
    }
  }
}

SlotTable::Handle SlotTable::create(void* object) {
  const std::lock_guard lock(mutex_);
  const std::uint32_t index = take_free_slot();
  if (index == kNoSlot) return 0;
  Slot& slot = (*owned_chunks_[index / kChunkSlots])[index % kChunkSlots];
  // Relaxed: a free slot's state is written under the mutex that is held here.
  const std::uint32_t current = generation(slot.state.load(std::memory_order_relaxed));
  slot.object = object;
  // Release: who pins the object must see it whole.
  slot.state.store((std::uint64_t{current} << kGenerationShift) + kOneReference, std::memory_order_release);
  return handle_of(kind_, current, index);
}

void* SlotTable::pin(Handle handle) {
  Slot* slot = find(handle);
  if (!slot) return nullptr;
  // Relaxed: the exchange below decides.
  std::uint64_t seen = slot->state.load(std::memory_order_relaxed);
  do {
    if (!alive(seen, handle) || pins(seen) == kMaxCount) return nullptr;
    // Acquire: pairs with the release in create(), through whatever exchanges lie between.
  } while (!slot->state.compare_exchange_weak(seen, seen + kOnePin, std::memory_order_acquire,
                                              std::memory_order_relaxed));
  return slot->object;
}

void SlotTable::unpin(Handle handle) {
  Slot* slot = find(handle);
  assert(slot);
  // Release: what this thread did to the object comes before its destruction. Acquire: if this is the last
  // pin, what others did to it comes before, too.
  const std::uint64_t before = slot->state.fetch_sub(kOnePin, std::memory_order_acq_rel);
  if (references(before) == 0 && pins(before) == 1) reclaim(*slot, slot_of(handle));
}

SlotTable::Outcome SlotTable::retain(Handle handle) {
  Slot* slot = find(handle);
  if (!slot) return Outcome::kInvalid;
  // Relaxed throughout: counting up neither reads nor publishes the object.
  std::uint64_t seen = slot->state.load(std::memory_order_relaxed);
  do {
    if (!alive(seen, handle)) return Outcome::kInvalid;
    if (references(seen) == kMaxCount) return Outcome::kFull;
  } while (!slot->state.compare_exchange_weak(seen, seen + kOneReference, std::memory_order_relaxed,
                                              std::memory_order_relaxed));
  return Outcome::kDone;
}

SlotTable::Outcome SlotTable::release(Handle handle) {
  Slot* slot = find(handle);
  if (!slot) return Outcome::kInvalid;
  // Relaxed: the exchange below decides.
  std::uint64_t seen = slot->state.load(std::memory_order_relaxed);
  do {
    if (!alive(seen, handle)) return Outcome::kInvalid;
    // Acquire and release for the same reasons as in unpin().
  } while (!slot->state.compare_exchange_weak(seen, seen - kOneReference, std::memory_order_acq_rel,
                                              std::memory_order_relaxed));
  if (references(seen) == 1 && pins(seen) == 0) reclaim(*slot, slot_of(handle));
  return Outcome::kDone;
}

SlotTable::Slot* SlotTable::find(Handle handle) const {
  const std::uint32_t index = slot_of(handle);
  if (handle != handle_of(kind_, generation_of(handle), index)) return nullptr;
  // Acquire: pairs with the release in add_chunk(), so that the slots are constructed.
  Chunk* chunk = chunks_[index / kChunkSlots].load(std::memory_order_acquire);
  return chunk ? &(*chunk)[index % kChunkSlots] : nullptr;
}

std::uint32_t SlotTable::take_free_slot() {
  if (free_.empty()) add_chunk();
  if (free_.empty()) return kNoSlot;
  const std::uint32_t index = free_.back();
  free_.pop_back();
  return index;
}

void SlotTable::add_chunk() {
  const auto begin = static_cast<std::uint32_t>(owned_chunks_.size() * kChunkSlots);
  if (begin >= limits_.slots) return;
  const std::uint32_t end = std::min(begin + kChunkSlots, limits_.slots);
  free_.reserve(end);
  owned_chunks_.reserve(owned_chunks_.size() + 1);
  auto chunk = std::make_unique<Chunk>();
  for (Slot& slot : *chunk) {
    // Relaxed: nobody else sees the chunk yet. Generations begin at 1.
    slot.state.store(1ull << kGenerationShift, std::memory_order_relaxed);
  }
  for (std::uint32_t index = end; index > begin; --index) free_.push_back(index - 1);
  // Release: see find().
  chunks_[begin / kChunkSlots].store(chunk.get(), std::memory_order_release);
  owned_chunks_.push_back(std::move(chunk));
}

void SlotTable::reclaim(Slot& slot, std::uint32_t index) {
  // Outside the lock: the destructor may release other handles. No one else reaches the slot: it has no
  // references.
  destroy_(slot.object);
  slot.object = nullptr;
  const std::lock_guard lock(mutex_);
  // Relaxed: the next create() reads it under the same mutex; until then every reader refuses both values.
  const std::uint32_t next = generation(slot.state.load(std::memory_order_relaxed)) + 1;
  slot.state.store(std::uint64_t{next} << kGenerationShift, std::memory_order_relaxed);
  if (next <= limits_.generations) free_.push_back(index);
}

}  // namespace palpate
