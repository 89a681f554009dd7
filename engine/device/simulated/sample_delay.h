#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/device/device_state.h"

namespace palpate {

// Gives back samples a whole number of samples late.
class SampleDelay {
 public:
  static constexpr int kLongest = 8;

  // `samples` is brought into 0 to kLongest.
  explicit SampleDelay(int samples) : samples_(static_cast<std::size_t>(std::clamp(samples, 0, kLongest))) {}

  // As if `state` had been measured all along.
  void fill(const DeviceState& state) { held_.fill(state); }

  void push(const DeviceState& state) {
    newest_ = (newest_ + 1) % held_.size();
    held_[newest_] = state;
  }

  const DeviceState& delayed() const { return held_[(newest_ + held_.size() - samples_) % held_.size()]; }

 private:
  std::array<DeviceState, kLongest + 1> held_{};
  std::size_t newest_ = 0;
  std::size_t samples_;
};

}  // namespace palpate
