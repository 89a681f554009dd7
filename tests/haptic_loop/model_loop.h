#pragma once

#include <memory>
#include <ostream>

#include "engine/device/simulated/scripted_motion.h"
#include "engine/device/simulated/simulated_phantom.h"
#include "engine/runtime/haptic_loop.h"

namespace palpate::test {

// Two models for a simulated hand: the tool in it, the body below. Turns are rotation vectors.
struct ModelPair {
  const char* name;
  const char* body;
  const char* tool;
  DVec3 body_turn;
  DVec3 tool_turn;
  bool bumpy;  // minima come and go as one slides over the other
};
inline void PrintTo(const ModelPair& pair, std::ostream* out) {
  *out << pair.name;
}

// Stand-ins for the pairs of the literature: crankshaft and gear, spring and teapot, horse and bunny. Half of
// their size, so that a device can move one around the other.
inline constexpr double kModelScale = 0.5;
extern const ModelPair kModelPairs[3];

enum class Surface {
  kBody,  // one body
  kGap,   // two of it, with a gap between that is narrower than the tool
};

struct LoopSettings {
  PhantomSpec spec;
  HandImpedance hand;
  SceneOptions scene;
  int delay = 0;  // samples
};

// A device in a hand and a scene; the tool is a cutoff away from the surface when the handle is at the
// origin.
class ModelLoop {
 public:
  static constexpr double kTick = 1e-3;  // s

  ModelLoop(const ModelPair& pair, Surface surface, const LoopSettings& settings);

  // Takes the handle to a little above the surface, arms, and then begins: `depth` below where springs begin.
  void begin(HandScript script, double depth, double travel, double period);
  void hold();  // the hand stops where it then intends to be
  void tick();

  const Contacts& contacts() const { return scene_.contacts(); }
  const RigidMotion& motion() const { return phantom_.true_motion(); }
  double given_to_hand() const { return -phantom_.energy().by_hand; }  // J
  DeviceStatus status() { return device_->status(); }

  // N/m that is felt of all springs that push, against motion up or down.
  double felt_stiffness() const;
  double stiffness_cap() const;  // N/m that is in force; 0: none

 private:
  double lift_at(double height) const;
  void follow(std::shared_ptr<const HandMotion> motion, bool place);

  LoopSettings settings_;
  Scene scene_;
  std::shared_ptr<GuardedDevice> device_;
  const SimulatedPhantom& phantom_;
  HapticLoop loop_{scene_};
  std::shared_ptr<const HandMotion> motion_;
  int ticks_of_motion_ = 0;
};

}  // namespace palpate::test
