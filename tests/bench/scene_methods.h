#pragma once

#include "tests/bench/scenes.h"
#include "tests/bench/touch_scene.h"
#include "tests/bench/turns.h"

namespace palpate::bench {

// How the tick of a scene is configured.
struct SceneMode {
  std::string name;
  std::string returns;
  plp_mode mode;
  DVec3 reference_point;  // of torques, frame of the second model
  Law law = Law::kSprings;
  unsigned global_every = 10;
};

// A scene of a pair's two models. The method has the name of its mode and, unless it is springs, of its
// law.
std::unique_ptr<Method> scene_method(const ModelPair& pair, const SceneMode& mode);

}  // namespace palpate::bench
