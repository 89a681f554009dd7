#include "tests/force/wrench_along.h"

#include <algorithm>
#include <stdexcept>

namespace palpate {
namespace {

bool stays_clear(const Model& a, const Model& b, const Motion& motion, double cutoff) {
  Query query;
  QueryOptions options;
  options.law.cutoff = cutoff;
  bool meets = false;
  constexpr int kLooks = 60;
  for (int i = 0; i <= kLooks; ++i) {
    query.run(a, b, motion(static_cast<double>(i) / kLooks), options);
    if (query.contacts().overlap || query.contacts().min_distance < 0.1 * cutoff) return false;
    meets |= query.contacts().min_distance < 0.6 * cutoff;
  }
  return meets;
}

// Wrenches of unit springs, relative to what one can push.
class Probe {
 public:
  Probe(const Model& a, const Model& b, double cutoff, ForceLaw law) : a_(a), b_(b) {
    options_.law = {1.0, cutoff};
    options_.force_law = law;
    options_.reference_point = b.centre();
  }

  Wrench wrench_at(const Pose& pose) {
    query_.run(a_, b_, pose, options_);
    const Wrench& wrench = query_.contacts().wrench;
    return {wrench.force / options_.law.cutoff, wrench.torque / (options_.law.cutoff * b_.radius())};
  }

 private:
  const Model& a_;
  const Model& b_;
  Query query_;
  QueryOptions options_;
};

double apart(const Wrench& one, const Wrench& other) {
  return std::max(glm::length(one.force - other.force), glm::length(one.torque - other.torque));
}

}  // namespace

std::vector<Wrench> wrenches_along(const Model& a, const Model& b, const Motion& motion, int steps,
                                   double cutoff, ForceLaw law) {
  Probe probe(a, b, cutoff, law);
  std::vector<Wrench> wrenches;
  for (int i = 0; i <= steps; ++i)
    wrenches.push_back(probe.wrench_at(motion(static_cast<double>(i) / steps)));
  return wrenches;
}

double largest_step(const std::vector<Wrench>& wrenches, std::size_t stride) {
  double most = 0.0;
  for (std::size_t i = 0; i + stride < wrenches.size(); i += stride)
    most = std::max(most, apart(wrenches[i + stride], wrenches[i]));
  return most;
}

double jump_between(const Model& a, const Model& b, const Motion& motion, double from, double to,
                    double cutoff, ForceLaw law) {
  Probe probe(a, b, cutoff, law);
  Wrench at_from = probe.wrench_at(motion(from)), at_to = probe.wrench_at(motion(to));
  constexpr int kHalvings = 24;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (from + to);
    const Wrench at_middle = probe.wrench_at(motion(middle));
    const bool later = apart(at_middle, at_to) > apart(at_from, at_middle);
    (later ? from : to) = middle;
    (later ? at_from : at_to) = at_middle;
  }
  return apart(at_from, at_to);
}

double largest_difference(const std::vector<Wrench>& one, const std::vector<Wrench>& other) {
  double most = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) most = std::max(most, apart(one[i], other[i]));
  return most;
}

Motion drift(const Model& a, const Model& b, double cutoff, double way, Random& random) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    const Pose start = place_near(a, b, 0.4 * cutoff, random);
    const DVec3 velocity = way * random.direction(), axis = random.direction(), centre = b.centre();
    const double turn = way / b.radius();
    const Motion motion = [=](double t) {
      const DMat3 rotation = glm::mat3_cast(glm::angleAxis(turn * t, axis)) * start.rotation;
      return Pose{rotation, start * centre + velocity * t - rotation * centre};
    };
    if (stays_clear(a, b, motion, cutoff)) return motion;
  }
  throw std::runtime_error("no motion stays clear");
}

}  // namespace palpate
