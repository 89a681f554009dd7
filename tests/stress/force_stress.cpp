#include "tests/stress/force_stress.h"

#include <cmath>
#include <functional>

#include "engine/scene/query.h"
#include "engine/scene/scene.h"
#include "tests/support/models.h"

namespace palpate::stress {
namespace {

constexpr int kComing = 6;    // steps to the pose
constexpr int kSettling = 3;  // steps there until nothing may change any more
constexpr int kHeld = 12;
constexpr int kSteps = 24;     // of a motion past the pose
constexpr int kHalvings = 26;  // of its worst step
constexpr double kStiffness = 1000.0;
constexpr double kDamping = 2.0;
constexpr double kFriction = 0.3;

bool finite(const Wrench& wrench) {
  const DVec3 sum = wrench.force + wrench.torque;
  return std::isfinite(sum.x + sum.y + sum.z);
}

bool same_bits(const Wrench& one, const Wrench& other) {
  return one.force == other.force && one.torque == other.torque;
}

SceneOptions options_of(const Case& c, Random& random) {
  SceneOptions options;
  options.cutoff = c.cutoff;
  options.stiffness = kStiffness;
  options.time_step = std::pow(10.0, random.uniform(-5.0, 0.0));
  options.mode = random.below(2) ? SearchMode::kCertified : SearchMode::kDescent;
  options.law = random.below(4) ? ForceLaw::kSmooth : ForceLaw::kSprings;
  options.damping = random.below(2) ? kDamping : 0.0;
  options.friction = random.below(2) ? kFriction : 0.0;
  options.stiffness_cap = random.below(2) ? 2.0 * kStiffness : 0.0;
  return options;
}

// Springs push with up to k c each, walls with twice that; damping and friction with what the speed gives.
bool too_strong(const Contacts& contacts, const Case& c, double speed) {
  const double springs = static_cast<double>(contacts.springs.size()) + 1.0;
  const double most = springs * (2.0 * kStiffness * c.cutoff + kDamping * speed) * (1.0 + kFriction);
  return glm::length(contacts.wrench.force) > most * (1.0 + 1e-9);
}

void hold(const Case& c, Random& random, std::shared_ptr<const Model> a, std::shared_ptr<const Model> b,
          ForceOutcome& outcome) {
  const SceneOptions options = options_of(c, random);
  Scene scene(options);
  static_cast<void>(scene.add({.model = std::move(a), .pose = {}}));
  const DVec3 along = random.direction();
  const auto coming = [&](int left) {
    return Pose{c.a_from_b.rotation, c.a_from_b.translation + along * (c.step * left)};
  };
  const BodyId tool =
      scene.add({.kind = BodyKind::kTool, .model = std::move(b), .pose = coming(kComing)}).value();
  Wrench settled;
  bool steady = true;
  for (int i = 0; i <= kComing + kHeld; ++i) {
    const int left = std::max(0, kComing - i);
    scene.set_pose(tool, coming(left));
    scene.step();
    const Wrench& wrench = scene.contacts().wrench;
    outcome.not_numbers += !finite(wrench);
    outcome.wild += too_strong(scene.contacts(), c, c.step / options.time_step);
    if (i == kComing + kSettling) settled = wrench;
    if (i > kComing + kSettling) steady &= same_bits(wrench, settled);
  }
  ++outcome.held;
  outcome.unsteady += !steady;
}

// The force and torque of unit springs under the smooth law, in k·c and k·c times the tool's radius.
class Probe {
 public:
  Probe(const Model& a, const Model& b, double cutoff) : a_(a), b_(b) {
    options_.law = {1.0, cutoff};
    options_.force_law = ForceLaw::kSmooth;
    options_.reference_point = b.centre();
  }

  Wrench at(const Pose& pose) {
    query_.run(a_, b_, pose, options_);
    // Nearer than that the force may turn around within the gap: not by a jump, but as good as.
    touched_ |= query_.contacts().overlap || query_.contacts().min_distance < 0.01 * options_.law.cutoff;
    const Wrench& wrench = query_.contacts().wrench;
    return {wrench.force / options_.law.cutoff, wrench.torque / (options_.law.cutoff * b_.radius())};
  }
  bool touched() const { return touched_; }
  const Contacts& contacts() const { return query_.contacts(); }

 private:
  const Model& a_;
  const Model& b_;
  Query query_;
  QueryOptions options_;
  bool touched_ = false;
};

double apart(const Wrench& one, const Wrench& other) {
  return std::max(glm::length(one.force - other.force), glm::length(one.torque - other.torque));
}

// The case's pose with half a cutoff between what is nearest there.
Pose drawn_apart(const Case& c, Probe& probe) {
  probe.at(c.a_from_b);
  Pose pose = c.a_from_b;
  for (const Contact& contact : probe.contacts().lmds) {
    if (contact.distance > probe.contacts().min_distance) continue;
    pose.translation += contact.normal * (0.5 * c.cutoff - contact.distance);
    break;
  }
  return pose;
}

// What is left of the largest change when the step in which it happens is halved again and again.
double largest_jump(const std::function<Pose(double)>& motion, Probe& probe) {
  std::vector<Wrench> wrenches;
  for (int i = 0; i <= kSteps; ++i) wrenches.push_back(probe.at(motion(i / double(kSteps))));
  int worst = 0;
  const auto change = [&](int i) { return apart(wrenches[i], wrenches[i + 1]); };
  for (int i = 1; i < kSteps; ++i)
    if (change(i) > change(worst)) worst = i;
  double from = worst / double(kSteps), to = (worst + 1) / double(kSteps);
  Wrench at_from = wrenches[worst], at_to = wrenches[worst + 1];
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (from + to);
    const Wrench at_middle = probe.at(motion(middle));
    const bool later = apart(at_middle, at_to) > apart(at_from, at_middle);
    (later ? from : to) = middle;
    (later ? at_from : at_to) = at_middle;
  }
  return apart(at_from, at_to);
}

void look_for_jumps(const Case& c, Random& random, const Model& a, const Model& b, ForceOutcome& outcome) {
  Probe start(a, b, c.cutoff), probe(a, b, c.cutoff);
  const Pose middle = drawn_apart(c, start);
  const double way = 0.3 * c.cutoff, turn = 0.3 * std::min(c.cutoff / b.radius(), 1.0);
  const DVec3 along = random.direction(), about = random.direction(), centre = b.centre();
  const double jump = largest_jump(
      [&](double t) {
        const DMat3 rotation = glm::mat3_cast(glm::angleAxis(turn * (t - 0.5), about)) * middle.rotation;
        return Pose{rotation, middle * centre + along * (way * (t - 0.5)) - rotation * centre};
      },
      probe);
  if (probe.touched()) return;
  ++outcome.motions;
  outcome.largest_jump = std::max(outcome.largest_jump, jump);
}

}  // namespace

void ForceOutcome::add(const ForceOutcome& other) {
  held += other.held;
  unsteady += other.unsteady;
  not_numbers += other.not_numbers;
  wild += other.wild;
  motions += other.motions;
  largest_jump = std::max(largest_jump, other.largest_jump);
}

ForceOutcome stress_force(const Case& c, Random& random) {
  const auto a = make_model(c.a), b = make_model(c.b);
  ForceOutcome outcome;
  hold(c, random, a, b, outcome);
  look_for_jumps(c, random, *a, *b, outcome);
  return outcome;
}

}  // namespace palpate::stress
