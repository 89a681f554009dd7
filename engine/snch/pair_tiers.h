#pragma once

#include <array>

#include "engine/snch/pair_certificates.h"
#include "engine/snch/until.h"

namespace palpate {

// When the pairs of features of two triangles are due for a test again. Pairs whose certificates will last
// about as long share a tier and are due together, so that what moves soon does not wake the rest.
class PairTiers {
 public:
  // None was ever tested.
  bool untested() const;

  FeaturePairSet due(const Until& now) const;
  Until first() const;  // when any is due

  // Takes the certificates of those that were due; of triangles that may touch those of all, for this tick.
  void renew(const PairCertificates& certificates, const MotionRate& rate, const Readings& readings);

  // The odometer is set back to 0.
  void set_back(const Readings& readings);

 private:
  // Lifetimes below 2, 8, 32 and 128 ticks, and others.
  static constexpr std::size_t kTiers = 5;

  struct Tier {
    FeaturePairSet pairs;
    Until until = Until::never();
  };

  static std::size_t tier_of(double lifetime);

  std::array<Tier, kTiers> tiers_;
};

}  // namespace palpate
