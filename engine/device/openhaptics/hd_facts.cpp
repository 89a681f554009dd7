#include "engine/device/openhaptics/hd_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "engine/device/openhaptics/hd_error.h"

namespace palpate {
namespace {

constexpr double kMillimetre = 1e-3;        // m
constexpr double kNewtonMillimetre = 1e-3;  // N·m
constexpr double kPerMillimetre = 1e3;      // N/m and N·s/m

// A model as haptic libraries and its maker have it, whatever a device says of itself.
struct KnownModel {
  std::string_view part;  // of what the device says that it is
  double max_force;
  double continuous_force;
  double max_torque;  // where there are motors for it
  double max_stiffness;
  double max_damping;
  int buttons;
};

// The first that fits.
constexpr std::array kModels = {
    KnownModel{"Premium 3.0", 22.0, 3.0, 0.188, 1000.0, 5.0, 1},
    KnownModel{"Premium", 8.5, 1.4, 0.188, 800.0, 5.0, 1},
    KnownModel{"Touch X", 7.9, 1.75, 0.0, 1000.0, 5.0, 2},
    KnownModel{"Desktop", 7.9, 1.75, 0.0, 1000.0, 5.0, 2},
    KnownModel{"Touch", 3.3, 0.88, 0.0, 400.0, 4.0, 2},
    KnownModel{"Omni", 3.3, 0.88, 0.0, 400.0, 4.0, 2},
};
constexpr KnownModel kWeakest{"", 3.3, 0.88, 0.05, 400.0, 4.0, 4};

const KnownModel& known_model(std::string_view name) {
  for (const KnownModel& model : kModels)
    if (name.find(model.part) != std::string_view::npos) return model;
  return kWeakest;
}

std::string text(const hd::Functions& call, hd::Enum what) {
  const char* const given = call.hdGetString(what);
  return clear_errors(call).code == 0 && given ? given : "";
}

int number(const hd::Functions& call, hd::Enum what, int otherwise) {
  int given = otherwise;
  call.hdGetIntegerv(what, &given);
  return clear_errors(call).code == 0 ? given : otherwise;
}

// The device's own limit, if it has one that is one, and not more than ours.
double limit(const hd::Functions& call, hd::Enum what, double unit, double ours) {
  double given = 0.0;
  call.hdGetDoublev(what, &given);
  const double own = given * unit;
  return clear_errors(call).code == 0 && own > 0.0 ? std::min(own, ours) : ours;
}

Box workspace(const hd::Functions& call) {
  double corners[6] = {};
  call.hdGetDoublev(hd::kUsableWorkspace, corners);
  Box box;
  if (clear_errors(call).code != 0) return box;
  for (const double* corner : {corners, corners + 3})
    box.grow(kMillimetre * DVec3(corner[0], corner[1], corner[2]));
  return box;
}

bool answers_temperatures(const hd::Functions& call) {
  double temperatures[16] = {};
  call.hdGetDoublev(hd::kTemperatures, temperatures);
  return clear_errors(call).code == 0;
}

bool answers_inkwell(const hd::Functions& call) {
  hd::Boolean out = 0;
  call.hdGetBooleanv(hd::kInkwellSwitch, &out);
  return clear_errors(call).code == 0;
}

DeviceLimits limits_of(const hd::Functions& call, const KnownModel& model, bool has_torque) {
  DeviceLimits limits;
  limits.max_force = limit(call, hd::kMaxForce, 1.0, model.max_force);
  limits.continuous_force = limit(call, hd::kContinuousForce, 1.0, model.continuous_force);
  limits.max_stiffness = limit(call, hd::kMaxStiffness, kPerMillimetre, model.max_stiffness);
  limits.max_damping = limit(call, hd::kMaxDamping, kPerMillimetre, model.max_damping);
  if (has_torque) {
    const double ours = model.max_torque > 0.0 ? model.max_torque : kWeakest.max_torque;
    limits.max_torque = limit(call, hd::kMaxTorque, kNewtonMillimetre, ours);
    limits.continuous_torque = limit(call, hd::kContinuousTorque, kNewtonMillimetre, limits.max_torque);
  }
  limits.workspace = workspace(call);
  return limits;
}

}  // namespace

HdFacts read_facts(const hd::Functions& call, const std::string& uri) {
  HdFacts facts;
  const std::string name = text(call, hd::kModel);
  const KnownModel& model = known_model(name);
  const bool turns = number(call, hd::kInputDegrees, 6) >= 6;
  const bool has_torque = number(call, hd::kOutputDegrees, 3) >= 6;
  facts.calibration_styles = number(call, hd::kCalibrationStyles, 0);
  facts.has_inkwell = (facts.calibration_styles & hd::kByInkwell) != 0 && answers_inkwell(call);
  facts.has_temperatures = answers_temperatures(call);
  facts.plain_buttons = model.buttons;
  facts.info.identity = {uri, name.empty() ? "PHANToM" : name, text(call, hd::kSerial)};
  facts.info.capabilities.sensed = turns ? kAllDegrees : kTranslations;
  facts.info.capabilities.actuated = has_torque ? kAllDegrees : kTranslations;
  facts.info.capabilities.buttons = model.buttons + (facts.has_inkwell ? 1 : 0);
  facts.info.limits = limits_of(call, model, has_torque);
  return facts;
}

}  // namespace palpate
