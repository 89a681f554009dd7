#pragma once

#include "engine/snch/lmd_search.h"

namespace palpate {

// One search with a fresh memory.
inline LmdSet find_lmds(const Model& a, const Model& b, const Pose& a_from_b, double cutoff) {
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = cutoff;
  search.run(a, b, a_from_b, options, found);
  return found;
}

inline Pose shifted(const DVec3& by) {
  return {DMat3(1.0), by};
}

inline Pose turned(const DVec3& axis, double angle, const DVec3& by = DVec3(0.0)) {
  return {glm::mat3_cast(glm::angleAxis(angle, glm::normalize(axis))), by};
}

// Sum of (cutoff − distance) · weight · normal: the force of unit springs.
inline DVec3 unit_spring_force(const LmdSet& found, double cutoff) {
  DVec3 force(0.0);
  for (const Lmd& lmd : found.lmds) force += lmd.weight * (cutoff - lmd.distance) * lmd.normal;
  return force;
}

inline DVec3 unit_spring_torque(const LmdSet& found, double cutoff, const DVec3& about) {
  DVec3 torque(0.0);
  for (const Lmd& lmd : found.lmds)
    torque += glm::cross(lmd.point_b - about, lmd.weight * (cutoff - lmd.distance) * lmd.normal);
  return torque;
}

}  // namespace palpate
