#pragma once

#include "engine/math/pose.h"
#include "engine/snch/model.h"
#include "palpate/palpate.h"
#include "samples/cli/handles.h"

namespace palpate::bench {

// The force laws by their numbers in the C ABI.
enum class Law : std::int32_t { kSprings = 0, kSmooth = 1 };

// Whether this library's scenes know more than springs.
template <class Options>
constexpr bool has_laws(const Options& options) {
  return requires {
    options.law;
  };
}

template <class Options>
void choose(Law law, Options& options) {
  if constexpr (requires { options.law; }) options.law = static_cast<std::int32_t>(law);
}

// The laws that scenes of this library have.
inline std::vector<Law> laws() {
  if (has_laws(plp_scene_options{})) return {Law::kSprings, Law::kSmooth};
  return {Law::kSprings};
}

plp_pose pose_of(const Pose& pose);

// The same surface behind the C ABI.
cli::OwnedModel public_model(const Model& model);

// A scene of the C ABI in the frame of its first body.
class TouchScene {
 public:
  TouchScene(double cutoff, plp_mode mode, Law law, unsigned global_every);

  void add_static(plp_model model, const Pose& pose);
  void add_tool(plp_model model, const DVec3& reference_point);

  void step(const Pose& world_from_tool);
  plp_contacts contacts() const;

 private:
  plp_body add(const plp_body_options& options);

  cli::OwnedScene scene_;
  plp_body tool_ = 0;
};

}  // namespace palpate::bench
