#pragma once

#include <array>

#include "engine/snch/feature_pair_set.h"
#include "engine/snch/odometer.h"

namespace palpate {

// Certificates of the pairs of features of two triangles: each that the pair holds nothing. Those that were
// not asked for, and those whose features do not take part, are not among them.
class PairCertificates {
 public:
  // `apart`: while they hold the triangles do not touch, nearly.
  void clear(bool apart) {
    all_ = doubtful_ = {};
    apart_ = apart;
  }
  bool apart() const { return apart_; }

  void set(int pair, const Certificate& certificate) {
    of_[static_cast<std::size_t>(pair)] = certificate;
    all_.add(pair);
    if (!certificate.holds()) doubtful_.add(pair);
  }

  FeaturePairSet doubtful() const { return doubtful_; }  // those that may hold something now
  bool may_touch() const { return doubtful_.has(FeaturePairSet::kContact); }

  // Calls visit(pair, certificate) for each.
  template <class Visit>
  void for_each(const Visit& visit) const {
    all_.for_each([&](int pair) { visit(pair, of_[static_cast<std::size_t>(pair)]); });
  }

 private:
  std::array<Certificate, FeaturePairSet::kCount> of_;
  FeaturePairSet all_;
  FeaturePairSet doubtful_;
  bool apart_ = false;
};

}  // namespace palpate
