#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate {

// How often something took how long: counts in buckets, eight to a doubling, so that a percentile is at most
// an eighth too long. Adding allocates nothing.
class Latency {
 public:
  void add(std::uint64_t nanoseconds);

  std::uint64_t count() const { return count_; }
  // The least time that `share` of all do not exceed, rounded up; microseconds. 0 of none.
  double percentile_us(double share) const;
  double max_us() const { return 1e-3 * static_cast<double>(max_); }  // exactly

 private:
  static constexpr std::size_t kPerDoubling = 8;
  static constexpr std::size_t kBuckets = kPerDoubling * 40;  // up to about two hours

  static std::size_t bucket_of(std::uint64_t nanoseconds);
  static std::uint64_t end_of(std::size_t bucket);

  std::array<std::uint32_t, kBuckets> counts_{};
  std::uint64_t count_ = 0;
  std::uint64_t max_ = 0;  // nanoseconds
};

}  // namespace palpate
