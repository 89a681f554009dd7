#include "engine/snch/pair_tiers.h"

#include <algorithm>
#include <bit>

namespace palpate {

bool PairTiers::untested() const {
  return std::all_of(tiers_.begin(), tiers_.end(), [](const Tier& tier) { return tier.pairs.empty(); });
}

FeaturePairSet PairTiers::due(const Until& now) const {
  FeaturePairSet due;
  for (const Tier& tier : tiers_)
    if (tier.until.has_passed(now)) due.add(tier.pairs);
  return due;
}

Until PairTiers::first() const {
  Until first = Until::never();
  for (const Tier& tier : tiers_) first = earlier(first, tier.until);
  return first;
}

// By the exponent: lifetimes are not negative, and come in no order that a branch could guess.
std::size_t PairTiers::tier_of(double lifetime) {
  constexpr std::uint64_t kBias = 1023;
  const std::uint64_t exponent = std::max(std::bit_cast<std::uint64_t>(lifetime) >> 52, kBias) - kBias;
  return std::min<std::size_t>((exponent + 1) / 2, kTiers - 1);
}

void PairTiers::renew(const PairCertificates& certificates, const MotionRate& rate,
                      const Readings& readings) {
  const bool may_touch = certificates.may_touch();
  for (Tier& tier : tiers_)
    if (may_touch || tier.until.has_passed(readings.now())) tier = {};
  std::array<Certificate, kTiers> shortest;
  shortest.fill(Certificate::forever());
  certificates.for_each([&](int pair, const Certificate& certificate) {
    const std::size_t tier = may_touch ? 0 : tier_of(rate.lifetime(certificate));
    tiers_[tier].pairs.add(pair);
    shortest[tier] = both(shortest[tier], certificate);
  });
  for (std::size_t tier = 0; tier < kTiers; ++tier)
    tiers_[tier].until = earlier(tiers_[tier].until, readings.until(shortest[tier]));
}

void PairTiers::set_back(const Readings& readings) {
  for (Tier& tier : tiers_)
    if (!tier.pairs.empty()) tier.until = readings.set_back(tier.until);
}

}  // namespace palpate
