#pragma once

#include <memory>
#include <vector>

#include "engine/scene/scene.h"

namespace palpate {

// A scene seen by the global search: what may soon come near the tool.
struct Survey {
  struct NearBody {
    BodyId id;
    std::shared_ptr<const Model> model;
    Pose pose;
  };

  SceneOptions options;
  BodyId tool = 0;  // 0: none
  std::shared_ptr<const Model> tool_model;
  Pose tool_pose;
  std::uint64_t step = 0;  // whose tool pose it is
  std::vector<NearBody> near;
};

}  // namespace palpate
