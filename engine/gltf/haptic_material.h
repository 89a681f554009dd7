#pragma once

#include <optional>

namespace palpate {

// How a body of a file feels, as far as the file says.
struct HapticMaterial {
  std::optional<double> stiffness;  // N/m, not negative
  std::optional<double> damping;    // N·s/m, not negative
  std::optional<double> friction;   // Coulomb's coefficient, not negative
};

// What `first` says and, where it says nothing, `second`.
inline HapticMaterial first_of(const HapticMaterial& first, const HapticMaterial& second) {
  return {first.stiffness ? first.stiffness : second.stiffness,
          first.damping ? first.damping : second.damping, first.friction ? first.friction : second.friction};
}

}  // namespace palpate
