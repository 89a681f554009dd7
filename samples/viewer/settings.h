#pragma once

#include <cstdint>

#include "palpate/palpate.h"

namespace palpate::viewer {

// What can be changed while a scene runs.
struct Settings {
  double cutoff = 0.0;  // metres; 0: a share of the scene's diagonal
  double stiffness = 2000.0;
  double damping = 0.5;
  double stiffness_cap = 0.0;  // 0: what the device can; negative: none
  double friction = 0.0;
  std::int32_t mode = PLP_MODE_CERTIFIED;
  std::int32_t law = PLP_LAW_SMOOTH;

  friend bool operator==(const Settings&, const Settings&) = default;
};

// As the scene of a trace was made, or a step of it had them.
template <class Recorded>
Settings settings_of(const Recorded& recorded) {
  return {recorded.cutoff,   recorded.stiffness,          recorded.damping,          recorded.stiffness_cap,
          recorded.friction, std::int32_t{recorded.mode}, std::int32_t{recorded.law}};
}

// `settings`, but for what differs between `before` and `now`.
Settings changed(Settings settings, const Settings& before, const Settings& now);

}  // namespace palpate::viewer
