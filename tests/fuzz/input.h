#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "palpate/palpate.h"

namespace palpate::fuzz {

// Bytes read as whatever a target wants. At their end there are zeros.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool at_end() const { return at_ >= bytes_.size(); }
  std::size_t left() const { return bytes_.size() - at_; }

  template <class T>
  T take() {
    std::array<std::uint8_t, sizeof(T)> raw{};
    const std::size_t count = std::min(sizeof(T), left());
    if (count > 0) std::memcpy(raw.data(), bytes_.data() + at_, count);
    at_ += count;
    T value;
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }

  std::uint8_t byte() { return take<std::uint8_t>(); }
  std::size_t below(std::size_t count) { return byte() % count; }

  // Mostly an ordinary number, so that most of what is made is valid; otherwise a nasty one, or any bits.
  double number() {
    constexpr double kNasty[] = {0.0,
                                 -0.0,
                                 1e300,
                                 -1e300,
                                 5e-324,
                                 1e15,
                                 1e-15,
                                 1.0 + 1e-15,
                                 -1.0,
                                 1e16,
                                 std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()};
    const std::uint8_t kind = byte();
    if (kind < 200) return (static_cast<int>(byte()) - 128) / 64.0;
    if (kind < 240) return kNasty[kind % std::size(kNasty)];
    return take<double>();
  }

  plp_pose pose() {
    plp_pose pose;
    for (double& x : pose.position) x = number();
    for (double& x : pose.orientation) x = number();
    if (byte() < 128) pose.orientation[3] = 1.0;
    return pose;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace palpate::fuzz
