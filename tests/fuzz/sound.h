#pragma once

#include <stdexcept>

#include "palpate/palpate.h"

namespace palpate::fuzz {

// What a target throws when the library breaks a promise.
struct Broken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool condition, const char* promise) {
  if (!condition) throw Broken(promise);
}

// A known result, and a sentence with every error.
plp_result checked(plp_result result);

// What every outcome keeps, whatever was asked: finite, unit normals, nothing beyond the cutoff (metres).
void require_sound(const plp_contacts& contacts, double cutoff);

// Steps a scene, which must succeed, and looks at the outcome.
void step(plp_scene scene, double cutoff);

// Touches two models, where the call is accepted.
void touch(plp_model a, plp_model b, const plp_pose& pose, const plp_query_options& options);

// The same of a device: no NaN to the hand.
void require_sound(const plp_device_state& state);

}  // namespace palpate::fuzz
