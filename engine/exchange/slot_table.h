#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace palpate {

// Objects of one kind behind opaque 64-bit handles. A handle is never an address and never 0; one that is
// stale or of another kind is refused. Looking up takes no lock: it pins the object, and an object that is
// released meanwhile is destroyed by its last pin. Creating and destroying lock.
//
// A handle is, from its highest bit: kind 8 bits, zero 4, generation 32, slot 20.
class SlotTable {
 public:
  using Handle = std::uint64_t;
  using Destroy = void (*)(void* object);

  enum class Outcome { kDone, kInvalid, kFull };

  static constexpr std::uint32_t kMaxSlots = 1u << 20;

  struct Limits {
    std::uint32_t slots = kMaxSlots;  // at most kMaxSlots
    std::uint32_t generations =
        UINT32_MAX - 1;  // a slot retires after so many objects, so no handle comes twice
  };

  // `kind` is not 0 and differs between the tables of a program.
  SlotTable(std::uint8_t kind, Destroy destroy, const Limits& limits);
  SlotTable(std::uint8_t kind, Destroy destroy) : SlotTable(kind, destroy, Limits{}) {}
  ~SlotTable();  // destroys what is left; nothing may be pinned
  SlotTable(const SlotTable&) = delete;
  SlotTable& operator=(const SlotTable&) = delete;

  // Takes `object` with one reference; 0 if the table is full, and then does not take it. Throws
  // std::bad_alloc.
  Handle create(void* object);

  // The object of a handle, kept alive until unpin(); null if the handle is invalid or pinned 65,535 times.
  void* pin(Handle handle);
  void unpin(Handle handle);

  Outcome retain(Handle handle);  // kFull: 65,535 references
  Outcome release(Handle handle);

 private:
  static constexpr std::uint32_t kChunkSlots = 1024;

  struct Slot {
    std::atomic<std::uint64_t> state{0};  // from its highest bit: generation 32 bits, references 16, pins 16
    void* object = nullptr;               // written only by who creates or destroys
  };
  using Chunk = std::array<Slot, kChunkSlots>;

  Slot* find(Handle handle) const;
  std::uint32_t take_free_slot();
  void add_chunk();
  void reclaim(Slot& slot, std::uint32_t index);

  const std::uint8_t kind_;
  const Destroy destroy_;
  const Limits limits_;
  // Chunks never move or vanish before the table does, so that a reader needs no lock.
  std::array<std::atomic<Chunk*>, kMaxSlots / kChunkSlots> chunks_{};

  std::mutex mutex_;  // guards what follows
  std::vector<std::unique_ptr<Chunk>> owned_chunks_;
  std::vector<std::uint32_t> free_;  // has room for every slot, so that giving one back cannot throw
};

}  // namespace palpate
