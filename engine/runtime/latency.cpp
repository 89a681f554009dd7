#include "engine/runtime/latency.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace palpate {

void Latency::add(std::uint64_t nanoseconds) {
  ++counts_[bucket_of(nanoseconds)];
  ++count_;
  max_ = std::max(max_, nanoseconds);
}

double Latency::percentile_us(double share) const {
  if (count_ == 0) return 0.0;
  const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
  std::uint64_t passed = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    passed += counts_[bucket];
    if (passed >= std::max<std::uint64_t>(rank, 1))
      return 1e-3 * static_cast<double>(std::min(end_of(bucket), max_));
  }
  return max_us();
}

// Below kPerDoubling a bucket is one nanosecond; from there on the highest bit and the three after it.
std::size_t Latency::bucket_of(std::uint64_t nanoseconds) {
  if (nanoseconds < kPerDoubling) return nanoseconds;
  const int shift = static_cast<int>(std::bit_width(nanoseconds)) - 4;
  const std::size_t bucket = kPerDoubling * static_cast<std::size_t>(shift) + (nanoseconds >> shift);
  return std::min(bucket, kBuckets - 1);
}

// The largest time in a bucket.
std::uint64_t Latency::end_of(std::size_t bucket) {
  if (bucket < kPerDoubling) return bucket;
  const std::size_t shift = bucket / kPerDoubling - 1;
  return ((kPerDoubling + bucket % kPerDoubling + 1) << shift) - 1;
}

}  // namespace palpate
