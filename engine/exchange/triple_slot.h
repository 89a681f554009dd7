#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace palpate {

// Hands the newest value from one writer to one reader; both are wait-free, and a value that the reader did
// not fetch in time is overwritten. Of three buffers each side owns one, the third lies between them.
template <class T>
class TripleSlot {
 public:
  TripleSlot() = default;
  TripleSlot(const TripleSlot&) = delete;
  TripleSlot& operator=(const TripleSlot&) = delete;

  // The writer's buffer: holds any older value. publish() hands it over.
  T& back() { return buffers_[back_]; }
  void publish() {
    // Release: the reader must see the value whole. Acquire: the buffer that comes back was read to the end.
    back_ = middle_.exchange(back_ | kNew, std::memory_order_acq_rel) & kIndex;
  }

  // Makes front() the newest value; false if that is what it is already.
  bool fetch() {
    // Relaxed: only asks whether the exchange is worth its while.
    if (!(middle_.load(std::memory_order_relaxed) & kNew)) return false;
    // Acquire: pairs with the release in publish(). Release: the writer may then reuse what was read.
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  // The reader's buffer: a default T before the first fetch().
  const T& front() const { return buffers_[front_]; }

  // All three, before the slot is shared: to reserve memory.
  std::array<T, 3>& buffers() { return buffers_; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kNew = 4;  // the middle one was not fetched yet

  std::array<T, 3> buffers_{};
  // A line of its own for each, so that neither side slows the other down.
  alignas(64) std::uint8_t back_ = 0;
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t front_ = 2;
};

}  // namespace palpate
