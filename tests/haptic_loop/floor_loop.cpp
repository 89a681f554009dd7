#include "tests/haptic_loop/floor_loop.h"

#include <stdexcept>

#include "tests/support/models.h"

namespace palpate::test {

FloorLoop::FloorLoop(double stiffness)
    : device_(new FaultyDevice),
      guarded_(std::make_shared<GuardedDevice>(std::unique_ptr<Device>(device_))),
      scene_({.cutoff = kCutoff, .stiffness = stiffness, .stiffness_cap = -1.0, .law = ForceLaw::kSprings}) {
  const auto box = asset_model("box");
  Pose below;
  below.translation.y = -0.1 - 0.5 * kCutoff;
  floor_ = scene_.add({.model = box, .pose = below}).value();
  scene_.add({.kind = BodyKind::kTool, .model = box, .pose = {}});
  loop_.attach(guarded_, {});
}

void FloorLoop::tick_until_armed() {
  guarded_->arm();
  for (int i = 0; i < 2000; ++i) tick();
  if (status().safety.state != SafetyState::kArmed) throw std::logic_error("the device did not arm");
}

}  // namespace palpate::test
