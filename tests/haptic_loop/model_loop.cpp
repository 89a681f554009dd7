#include "tests/haptic_loop/model_loop.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "engine/contact/stiffness_cap.h"
#include "engine/device/rotation_vector.h"
#include "engine/scene/query.h"
#include "tests/support/models.h"

namespace palpate::test {
namespace {

constexpr double kQuarterTurn = 1.5707963267948966;

// Models are made once, trees and all.
std::shared_ptr<const Model> shared_model(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const Model>> made;
  std::shared_ptr<const Model>& model = made[name];
  if (!model) model = asset_model(name, kModelScale);
  return model;
}

Pose turned(const DVec3& turn) {
  return {glm::mat3_cast(rotation_by(turn)), DVec3(0.0)};
}

Box box_of(const Mesh& mesh, const Pose& pose) {
  Box box;
  for (const Vec3& position : mesh.positions) box.grow(pose * mesh.frame.metres(DVec3(position)));
  return box;
}

// Bodies that are raised together towards the tool.
class Rise {
 public:
  Rise(const Model& body, const Model& tool, const Pose& world_from_tool, std::vector<Pose> poses)
      : body_(body), tool_(tool), world_from_tool_(world_from_tool), poses_(std::move(poses)) {}

  // They come from below, in steps at first, until they are `gap` away.
  std::vector<Pose> until(double gap) {
    constexpr double kPrecision = 1e-9;
    double step = 0.25 * gap;
    while (!nearer(gap)) raise(step);
    for (; step > kPrecision; step *= 0.5) raise(nearer(gap) ? -step : step);
    return poses_;
  }

 private:
  void raise(double by) {
    for (Pose& pose : poses_) pose.translation.y += by;
  }

  bool nearer(double gap) {
    QueryOptions options;
    options.law = {1.0, gap};
    for (const Pose& pose : poses_) {
      query_.run(body_, tool_, inverse(pose) * world_from_tool_, options);
      if (query_.contacts().overlap || !query_.contacts().lmds.empty()) return true;
    }
    return false;
  }

  const Model& body_;
  const Model& tool_;
  Pose world_from_tool_;
  std::vector<Pose> poses_;
  Query query_;
};

// Where bodies stand so that the tool, turned at the origin, is `gap` away from them.
std::vector<Pose> below_tool(const ModelPair& pair, Surface surface, double gap) {
  constexpr double kOpening = 0.4;  // of a gap, in widths of the tool
  const auto body = shared_model(pair.body), tool = shared_model(pair.tool);
  const Box tool_box = box_of(tool->mesh(), turned(pair.tool_turn));
  const Box body_box = box_of(body->mesh(), turned(pair.body_turn));
  const double aside = 0.5 * (body_box.size().x + kOpening * tool_box.size().x);
  std::vector<Pose> poses;
  for (const double side : surface == Surface::kGap ? std::vector{-1.0, 1.0} : std::vector{0.0}) {
    Pose pose = turned(pair.body_turn);
    pose.translation = -body_box.centre();
    pose.translation.x += side * aside;
    pose.translation.y = tool_box.low.y - body_box.high.y - 2.0 * gap;
    poses.push_back(pose);
  }
  return Rise(*body, *tool, turned(pair.tool_turn), std::move(poses)).until(gap);
}

}  // namespace

const ModelPair kModelPairs[3] = {
    {"CrankshaftGear", "crankshaft_45k", "gear_6k", {0.0, kQuarterTurn, 0.0}, {0.3, 0.2, 0.1}, false},
    {"TeapotSpring", "teapot_5600", "spring_23k", {0.0, kQuarterTurn, 0.0}, {0.3, 0.2, 0.1}, false},
    {"HorseBunny", "organic_97k", "organic_2200", {0.0, 0.4, 0.0}, {0.3, 0.2, 0.1}, true}};

ModelLoop::ModelLoop(const ModelPair& pair, Surface surface, const LoopSettings& settings)
    : settings_(settings),
      scene_(settings.scene),
      device_(
          std::make_shared<GuardedDevice>(std::make_unique<SimulatedPhantom>(settings.spec, settings.delay))),
      phantom_(*device_->simulated()) {
  for (const Pose& pose : below_tool(pair, surface, settings.scene.cutoff)) {
    scene_.add({.model = shared_model(pair.body), .pose = pose});
  }
  scene_.add({.kind = BodyKind::kTool, .model = shared_model(pair.tool), .pose = {}});
  DeviceMapping mapping;
  mapping.handle_from_tool = turned(pair.tool_turn);
  loop_.attach(device_, mapping);
  HandOrder order;
  order.impedance = settings.hand;
  device_->order_hand(std::move(order));
}

void ModelLoop::begin(HandScript script, double depth, double travel, double period) {
  constexpr double kHeight = 2e-3;  // m
  constexpr int kArming = 1000;     // ticks
  ScriptParameters parameters;
  parameters.origin.position = {0.0, kHeight, 0.0};
  parameters.depth = kHeight + depth;
  parameters.travel = travel;
  parameters.period = period;
  follow(std::make_shared<ScriptedMotion>(HandScript::kHold, parameters), true);
  device_->arm();
  for (int i = 0; i < kArming; ++i) tick();
  follow(std::make_shared<ScriptedMotion>(script, parameters), false);
}

void ModelLoop::hold() {
  ScriptParameters parameters;
  parameters.origin = motion_->at(ticks_of_motion_ * kTick);
  follow(std::make_shared<ScriptedMotion>(HandScript::kHold, parameters), false);
}

void ModelLoop::tick() {
  loop_.tick(kTick);
  ++ticks_of_motion_;
}

double ModelLoop::felt_stiffness() const {
  const double step = 1e-6 * settings_.scene.cutoff;
  return (lift_at(-step) - lift_at(step)) / (2.0 * step);
}

double ModelLoop::stiffness_cap() const {
  const double own = settings_.scene.stiffness_cap;
  return std::max(own == 0.0 ? settings_.spec.limits.max_stiffness : own, 0.0);
}

// Newtons upward of the springs that push now, were the tool higher by that many metres.
double ModelLoop::lift_at(double height) const {
  const SpringLaw law{settings_.scene.stiffness, settings_.scene.cutoff};
  std::vector<double> lifts;
  StiffnessCap cap;
  for (const Contact& contact : scene_.contacts().springs) {
    const SpringContact spring{contact.point_b, contact.normal, contact.distance + height * contact.normal.y,
                               contact.weight};
    cap.add(spring, law);
    lifts.push_back(spring_force(spring, law).y);
  }
  const std::span<const double> shares = cap.shares(stiffness_cap());
  return std::inner_product(lifts.begin(), lifts.end(), shares.begin(), 0.0);
}

void ModelLoop::follow(std::shared_ptr<const HandMotion> motion, bool place) {
  motion_ = motion;
  ticks_of_motion_ = 0;
  HandOrder order;
  order.motion = std::move(motion);
  order.place = place;
  device_->order_hand(std::move(order));
}

}  // namespace palpate::test
