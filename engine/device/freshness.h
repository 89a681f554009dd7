#pragma once

#include <cstdint>

namespace palpate {

// How long ago a counter last changed.
class Freshness {
 public:
  // Lets `dt` seconds pass; true if the counter has moved on. The first one counts as new.
  bool update(std::uint64_t counter, double dt) {
    gap_ = age_ + dt;
    const bool fresh = !seen_ || counter != counter_;
    seen_ = true;
    counter_ = counter;
    age_ = fresh ? 0.0 : gap_;
    return fresh;
  }

  double age() const { return age_; }  // seconds since the last change
  double gap() const { return gap_; }  // seconds between the last two changes, where the last update was one

 private:
  std::uint64_t counter_ = 0;
  double age_ = 0.0;
  double gap_ = 0.0;
  bool seen_ = false;
};

}  // namespace palpate
