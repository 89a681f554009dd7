#pragma once

#include <array>

#include "engine/snch/feature_pair_set.h"
#include "engine/snch/odometer.h"

namespace palpate {

// Certificates of the pairs of features of two triangles: each that the pair holds nothing. Those that were
// not asked for, and those whose features do not take part, are not among them.
class PairCertificates {
 public:
  void clear() { all_ = doubtful_ = {}; }

  void set(int pair, const Certificate& certificate) {
    of_[static_cast<std::size_t>(pair)] = certificate;
    all_.add(pair);
    if (!certificate.holds()) doubtful_.add(pair);
  }

  FeaturePairSet doubtful() const { return doubtful_; }  // those that may hold something now

  // The pairs that are due first, and how long the other ones will hold: so chosen that, at this rate of
  // motion, to test again what is due each time it is and all when the rest is takes the fewest tests.
  struct Split {
    FeaturePairSet due;
    Certificate first;
    Certificate rest;
  };
  Split split(const MotionRate& rate) const;

  // Of those that outlast `rest` nothing is due before; `first` is of the others.
  Split outlasted_by(const Certificate& rest) const;

 private:
  const Certificate& of(int pair) const { return of_[static_cast<std::size_t>(pair)]; }

  std::array<Certificate, FeaturePairSet::kCount> of_;
  FeaturePairSet all_;
  FeaturePairSet doubtful_;
};

}  // namespace palpate
