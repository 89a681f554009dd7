#pragma once

#include <memory>
#include <utility>

#include "engine/scene/scene.h"

namespace palpate {

// A scene of one body and the tool that a hand moves by poses.
class PressedScene {
 public:
  static constexpr double kCutoff = 0.01, kStiffness = 1000.0;

  PressedScene(std::shared_ptr<const Model> body, std::shared_ptr<const Model> tool, const Pose& start,
               SceneOptions options = options_with(SearchMode::kCertified))
      : scene_(options) {
    BodyOptions still;
    still.model = std::move(body);
    static_cast<void>(scene_.add(std::move(still)));
    BodyOptions held;
    held.kind = BodyKind::kTool;
    held.model = std::move(tool);
    held.pose = start;
    tool_ = scene_.add(std::move(held)).value();
  }

  static SceneOptions options_with(SearchMode mode) {
    SceneOptions options;
    options.cutoff = kCutoff;
    options.stiffness = kStiffness;
    options.mode = mode;
    options.law = ForceLaw::kSprings;
    options.fade_time = 0.02;
    return options;
  }

  const Contacts& step_to(const Pose& pose) {
    scene_.set_pose(tool_, pose);
    scene_.step();
    return scene_.contacts();
  }
  Scene& scene() { return scene_; }

 private:
  Scene scene_;
  BodyId tool_ = 0;
};

}  // namespace palpate
