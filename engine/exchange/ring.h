#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

namespace palpate {

// A bounded queue from one producer to one consumer, wait-free on both sides. Allocates when it is made and
// never after.
template <class T>
class Ring {
 public:
  // Has room for at least `capacity`, which is positive.
  explicit Ring(std::size_t capacity) : items_(std::bit_ceil(capacity)) {}
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  std::size_t capacity() const { return items_.size(); }

  // The producer's: how many items it may push at least.
  std::size_t room() const {
    // As in push(): relaxed for the own side, acquire for the places that were emptied.
    return items_.size() - (tail_.load(std::memory_order_relaxed) - head_.load(std::memory_order_acquire));
  }

  // The producer's. False, and `item` stays as it is, if the ring is full.
  bool push(T&& item) {
    // Relaxed: only this side writes it.
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    // Acquire: pairs with the release in pop(), so that the place was emptied.
    if (tail - head_.load(std::memory_order_acquire) == items_.size()) return false;
    items_[tail & (items_.size() - 1)] = std::move(item);
    // Release: the consumer must see the item whole.
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }
  bool push(const T& item) { return push(T(item)); }

  // The consumer's. False, and `item` stays as it is, if the ring is empty.
  bool pop(T& item) {
    // Relaxed: only this side writes it.
    const std::size_t head = head_.load(std::memory_order_relaxed);
    // Acquire: pairs with the release in push().
    if (head == tail_.load(std::memory_order_acquire)) return false;
    item = std::move(items_[head & (items_.size() - 1)]);
    // Release: the producer may then fill the place again.
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

 private:
  std::vector<T> items_;
  // Counts that never turn back but wrap; a line of its own for each.
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace palpate
