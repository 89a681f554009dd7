#include "engine/scene/spring_forces.h"

#include "engine/contact/damping.h"
#include "engine/contact/friction.h"

namespace palpate {
namespace {

SpringContact spring_of(const Contact& contact) {
  return {contact.point_b, contact.normal, contact.distance, contact.weight};
}

}  // namespace

void SpringForces::reserve(std::size_t springs) {
  pushes_.reserve(springs);
  cap_.reserve(springs);
}

void SpringForces::clear() {
  pushes_.clear();
  cap_.clear();
}

void SpringForces::add(std::span<const PairSpring> springs, const ContactPair& pair, std::uint32_t first_set,
                       Contacts& contacts) {
  for (const PairSpring& spring : springs) {
    if (!contacts.has_room_for_spring()) {
      contacts.status |= kStatusCut;
      return;
    }
    Contact contact = contact_of(spring.at, pair, first_set);
    if (spring.is_held || first_set == kNoSet) contact.set = kNoSet;
    contacts.springs.push_back(contact);
    pushes_.push_back({pair.world_from_body.rotation * spring.velocity, pair.law});
    cap_.add(spring_of(contact), pair.law);
  }
}

// What a spring yields to the cap, its damping and friction yield as well.
void SpringForces::finish(double stiffness_cap, const DVec3& reference, Contacts& contacts) {
  const std::span<const double> shares = cap_.shares(stiffness_cap);
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    Contact& contact = contacts.springs[i];
    const auto& [velocity, law] = pushes_[i];
    const double speed = glm::dot(velocity, contact.normal);
    contact.force += damping_force(spring_of(contact), -speed, law) * contact.normal;
    contact.force *= shares[i];
    contact.force += friction_force(glm::dot(contact.force, contact.normal), shares[i] * contact.weight,
                                    velocity - speed * contact.normal, law.friction);
    contacts.wrench += wrench_about(reference, contact.point_b, contact.force);
  }
}

}  // namespace palpate
