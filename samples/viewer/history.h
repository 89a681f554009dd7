#pragma once

#include <cstddef>
#include <vector>

#include "samples/cli/tick.h"

namespace palpate::viewer {

// The newest ticks, the oldest of which make room.
class History {
 public:
  explicit History(std::size_t capacity) : ticks_(capacity) {}

  void add(const cli::Tick& tick) {
    ticks_[(first_ + size_) % ticks_.size()] = tick;
    if (size_ < ticks_.size()) {
      ++size_;
    } else {
      first_ = (first_ + 1) % ticks_.size();
    }
  }
  void clear() { first_ = size_ = 0; }

  std::size_t size() const { return size_; }
  const cli::Tick& operator[](std::size_t i) const { return ticks_[(first_ + i) % ticks_.size()]; }
  const cli::Tick& newest() const { return (*this)[size_ - 1]; }

 private:
  std::vector<cli::Tick> ticks_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace palpate::viewer
