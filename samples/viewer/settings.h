#pragma once

#include <cstdint>

#include "palpate/palpate.h"

namespace palpate::viewer {

// What can be changed while a scene runs.
struct Settings {
  double cutoff = 0.0;  // metres; 0: a share of the scene's diagonal
  double stiffness = 1000.0;
  double damping = 0.5;
  double stiffness_cap = 1000.0;  // 0: none
  double friction = 0.0;
  std::int32_t mode = PLP_MODE_CERTIFIED;
  std::int32_t law = PLP_LAW_SMOOTH;

  friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace palpate::viewer
