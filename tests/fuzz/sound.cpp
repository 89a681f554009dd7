#include "tests/fuzz/sound.h"

#include <cmath>
#include <cstring>

namespace palpate::fuzz {
namespace {

bool finite(const double (&v)[3]) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double length(const double (&v)[3]) {
  return std::hypot(v[0], v[1], v[2]);
}

void require_sound(const plp_lmd& lmd, double cutoff) {
  require(finite(lmd.point_a) && finite(lmd.point_b) && finite(lmd.normal) && finite(lmd.force),
          "a finite LMD");
  require(std::abs(length(lmd.normal) - 1.0) < 1e-9, "a unit normal");
  require(lmd.distance > 0.0 && lmd.distance <= cutoff * (1.0 + 1e-9), "a distance within the cutoff");
  require(lmd.weight > 0.0 && lmd.weight <= 1.0 + 1e-9, "a weight of at most 1");
  require(lmd.feature_a <= PLP_FEATURE_VERTEX && lmd.feature_b <= PLP_FEATURE_VERTEX, "a known feature");
}

}  // namespace

plp_result checked(plp_result result) {
  require(std::strcmp(plp_result_string(result), "unknown result") != 0, "a known result");
  require(result >= 0 || plp_last_error()[0] != '\0', "a sentence with every error");
  require(result != PLP_ERROR_INTERNAL, "no defect of the library");
  return result;
}

void require_sound(const plp_contacts& contacts, double cutoff) {
  require(finite(contacts.wrench.force) && finite(contacts.wrench.torque), "a finite wrench");
  require(contacts.lmd_count == 0 || contacts.lmds, "LMDs where there are some");
  for (std::size_t i = 0; i < contacts.lmd_count; ++i)
    require_sound(*reinterpret_cast<const plp_lmd*>(reinterpret_cast<const char*>(contacts.lmds) +
                                                    i * contacts.lmd_stride),
                  cutoff);
  for (std::size_t i = 0; i < contacts.spring_count; ++i) {
    const auto& spring = *reinterpret_cast<const plp_lmd*>(reinterpret_cast<const char*>(contacts.springs) +
                                                           i * contacts.lmd_stride);
    require(finite(spring.force) && finite(spring.point_b), "finite springs");
  }
  require(contacts.overlap == 1 || contacts.overlap_count == 0, "no overlaps listed where there is none");
}

void step(plp_scene scene, double cutoff) {
  require(checked(plp_scene_step(scene)) == PLP_OK, "a step");
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  require(checked(plp_scene_get_contacts(scene, &contacts)) == PLP_OK, "an outcome");
  require_sound(contacts, cutoff);
}

void touch(plp_model a, plp_model b, const plp_pose& pose, const plp_query_options& options) {
  plp_query_result result = nullptr;
  require(checked(plp_query_result_create(&result)) == PLP_OK, "room for a result");
  if (checked(plp_query(a, b, &pose, &options, result)) == PLP_OK) {
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    require(checked(plp_query_result_get(result, &contacts)) == PLP_OK, "an outcome");
    require_sound(contacts, options.cutoff);
  }
  plp_query_result_release(result);
}

void require_sound(const plp_device_state& state) {
  require(finite(state.applied.force) && finite(state.applied.torque), "a finite wrench on the hand");
  require(finite(state.pose.position), "a finite pose of the handle");
}

}  // namespace palpate::fuzz
