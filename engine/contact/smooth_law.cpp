#include "engine/contact/smooth_law.h"

#include <algorithm>

namespace palpate {
namespace {

// Points closer than the first share fully, beyond the second not at all; in cutoffs.
constexpr double kSharedWithin = 1.0;
constexpr double kSharedUpTo = 2.0;

// The same for directions: squared chords of about 0.15 and 0.3 radians.
constexpr double kOneDirection = 0.15 * 0.15;
constexpr double kOtherDirection = 0.3 * 0.3;

// A contact counts for others when it is this part of the cutoff below it, so that none jumps when one comes.
constexpr double kEntering = 0.125;

// From 1 at `low` to 0 at `high` without a kink.
double falling(double x, double low, double high) {
  const double t = std::clamp((high - x) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// How much two contacts are one. In squared distances, which have no kink where the points meet.
double kinship(const NearContact& one, const NearContact& other, double cutoff) {
  const DVec3 turn = one.direction - other.direction;
  const double by_direction = falling(glm::dot(turn, turn), kOneDirection, kOtherDirection);
  if (!(by_direction > 0.0)) return 0.0;
  const DVec3 apart_a = one.point_a - other.point_a, apart_b = one.point_b - other.point_b;
  const double squared = std::max(glm::dot(apart_a, apart_a), glm::dot(apart_b, apart_b)) / (cutoff * cutoff);
  return by_direction * falling(squared, kSharedWithin * kSharedWithin, kSharedUpTo * kSharedUpTo);
}

double presence(const NearContact& contact, double cutoff) {
  return contact.weight * falling(contact.distance, (1.0 - kEntering) * cutoff, cutoff);
}

}  // namespace

void SmoothLaw::reserve(std::size_t contacts) {
  order_.reserve(contacts);
  sums_.reserve(contacts);
  factors_.reserve(contacts);
}

std::span<const double> SmoothLaw::share(std::span<const NearContact> contacts, double cutoff) {
  sort_along_x(contacts);
  sums_.resize(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) sums_[i] = contacts[i].weight;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const NearContact& one = contacts[order_[k]];
    for (std::size_t l = k + 1; l < order_.size(); ++l) {
      const NearContact& other = contacts[order_[l]];
      if (other.point_a.x - one.point_a.x >= kSharedUpTo * cutoff) break;
      const double shared = kinship(one, other, cutoff);
      if (!(shared > 0.0)) continue;
      sums_[order_[k]] += presence(other, cutoff) * shared;
      sums_[order_[l]] += presence(one, cutoff) * shared;
    }
  }
  factors_.resize(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    factors_[i] = contacts[i].weight / std::max(1.0, sums_[i]);
  return factors_;
}

// So that a contact is compared with those near it alone.
void SmoothLaw::sort_along_x(std::span<const NearContact> contacts) {
  order_.resize(contacts.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t one, std::uint32_t other) {
    const double x = contacts[one].point_a.x, other_x = contacts[other].point_a.x;
    return x != other_x ? x < other_x : one < other;
  });
}

}  // namespace palpate
