#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/math/pose.h"
#include "engine/snch/model.h"
#include "tests/bench/effort.h"

namespace palpate::bench {

// Two models by name: one stands still, the other slides over it.
struct PairScene {
  const char* name;
  const char* a;
  const char* b;
  double b_scale;
  bool from_data;  // below PALPATE_DATA; otherwise generated
};

// The scenes that can be loaded here, a few of them with little effort.
std::vector<PairScene> pair_scenes(const Effort& effort);

// Two models that touch.
struct ModelPair {
  std::shared_ptr<const Model> a;
  std::shared_ptr<const Model> b;
  double cutoff;  // metres
};

inline constexpr double kSpeed = 0.33;  // diagonals of the first model a second
inline constexpr std::uint64_t kSeed = 77;

// `cutoff` is a share of the first model's diagonal.
ModelPair load(const PairScene& scene, double cutoff);

// Poses of the second model in the frame of the first, a millisecond apart: 0.1 m/s on a model 0.3 m across,
// without overlap. The seed chooses where the motion begins and where it goes.
std::vector<Pose> motion_of(const ModelPair& pair, int poses, std::uint64_t seed = kSeed);

}  // namespace palpate::bench
