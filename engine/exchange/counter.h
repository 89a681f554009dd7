#pragma once

#include <atomic>
#include <cstdint>

namespace palpate {

// A number that one thread counts up and any may read.
class Counter {
 public:
  void add(std::uint64_t count) {
    // Relaxed: it orders nothing else; only one thread writes, so none is lost.
    count_.store(count_.load(std::memory_order_relaxed) + count, std::memory_order_relaxed);
  }
  // Relaxed: it may lag behind.
  std::uint64_t value() const { return count_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> count_{0};
};

}  // namespace palpate
