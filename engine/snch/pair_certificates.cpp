#include "engine/snch/pair_certificates.h"

#include <algorithm>
#include <bit>

namespace palpate {
namespace {

// Lifetimes are told apart by powers of two, up to this many.
constexpr std::size_t kClasses = 9;

std::size_t class_of(double lifetime) {
  constexpr std::uint64_t kBias = 1023;                                         // of an exponent
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(lifetime) >> 52;  // not negative
  return exponent < kBias ? 0 : std::min<std::size_t>(exponent - kBias + 1, kClasses - 1);
}

// The class from which on pairs are tested with the rest.
std::size_t cheapest_border(const std::array<int, kClasses>& counts, double shortest) {
  int all = 0;
  for (int count : counts) all += count;
  std::size_t best = 0;
  double least = all / std::max(1.0, shortest), bound = 1.0;
  int due = 0;
  for (std::size_t border = 1; border < kClasses; ++border, bound *= 2.0) {
    due += counts[border - 1];
    const double cost = due / std::max(1.0, shortest) + all / bound;
    if (cost >= least) continue;
    least = cost;
    best = border;
  }
  return best;
}

}  // namespace

PairCertificates::Split PairCertificates::split(const MotionRate& rate) const {
  std::array<int, kClasses> counts{};
  std::array<std::uint8_t, FeaturePairSet::kCount> classes;
  double shortest = Certificate::kForever;
  all_.for_each([&](int pair) {
    const double lifetime = rate.lifetime(of(pair));
    const std::size_t power = class_of(lifetime);
    classes[static_cast<std::size_t>(pair)] = static_cast<std::uint8_t>(power);
    ++counts[power];
    shortest = std::min(shortest, lifetime);
  });
  const std::size_t border = cheapest_border(counts, shortest);
  Split split{{}, Certificate::forever(), Certificate::forever()};
  all_.for_each([&](int pair) {
    const bool is_due = classes[static_cast<std::size_t>(pair)] < border;
    Certificate& whole = is_due ? split.first : split.rest;
    whole = both(whole, of(pair));
    if (is_due) split.due.add(pair);
  });
  return split;
}

PairCertificates::Split PairCertificates::outlasted_by(const Certificate& rest) const {
  Split split{{}, Certificate::forever(), rest};
  all_.for_each([&](int pair) {
    const Certificate& one = of(pair);
    if (one.distance >= rest.distance && one.angle >= rest.angle) return;
    split.first = both(split.first, one);
    split.due.add(pair);
  });
  return split;
}

}  // namespace palpate
