#pragma once

#include <concepts>
#include <cstdint>

namespace palpate {

// A counter of few bits that wraps, continued in 64. It goes wrong only where a whole turn is missed.
template <std::unsigned_integral T>
class Unwrapped {
 public:
  // How far the counter has moved on since the one before; the first one has not moved.
  T advance(T counter) {
    const T step = seen_ ? static_cast<T>(counter - last_) : T{0};
    last_ = counter;
    seen_ = true;
    total_ += step;
    return step;
  }

  // The next counter is a first one again, `step` after the last.
  void restart(std::uint64_t step) {
    seen_ = false;
    total_ += step;
  }

  std::uint64_t total() const { return total_; }

 private:
  std::uint64_t total_ = 0;
  T last_ = 0;
  bool seen_ = false;
};

}  // namespace palpate
