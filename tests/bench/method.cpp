#include "tests/bench/method.h"

#include <algorithm>

namespace palpate::bench {
namespace {

Wrench wrench_of(const std::vector<SpringContact>& contacts, double cutoff, const DVec3& reference) {
  Wrench sum;
  for (const SpringContact& contact : contacts)
    sum += wrench_about(reference, contact.point, spring_force(contact, {kStiffness, cutoff}));
  return sum;
}

}  // namespace

Outcome outcome_of(const std::vector<SpringContact>& contacts, double cutoff, const DVec3& reference) {
  Outcome outcome;
  outcome.lmds = contacts.size();
  for (const SpringContact& contact : contacts)
    outcome.min_distance = std::min(outcome.min_distance, contact.distance);
  outcome.wrench = wrench_of(contacts, cutoff, reference);
  return outcome;
}

}  // namespace palpate::bench
