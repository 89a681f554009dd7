#include "tests/bench/scenes.h"

#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate::bench {
namespace {

constexpr PairScene kScenes[] = {
    {"crankshaft_45k-gear_6k", "crankshaft_45k", "gear_6k", 0.5, false},
    {"spring_23k-teapot_5600", "spring_23k", "teapot_5600", 0.3, false},
    {"organic_97k-organic_2200", "organic_97k", "organic_2200", 0.4, false},
    {"data:crankshaft_45k-gear_6k", "crankshaft_45k.glb", "gear_6k.glb", 0.5, true},
    {"data:spring_23k-teapot_5600", "spring_23k.glb", "teapot_5600.glb", 2.0, true},
    {"data:horse_97k-bunny_2200", "horse_outward.glb", "bunny_2200.glb", 0.004, true},
    {"data:horse_97k-bunny_70k", "horse_outward.glb", "bunny_closed_70k.glb", 0.004, true},
};

}  // namespace

std::vector<PairScene> pair_scenes(const Effort& effort) {
  std::vector<PairScene> scenes;
  for (const PairScene& scene : kScenes) {
    if (scene.from_data && !data_folder()) continue;
    if (effort.quick && !scene.from_data && data_folder()) continue;
    scenes.push_back(scene);
  }
  return scenes;
}

ModelPair load(const PairScene& scene, double cutoff) {
  const auto a = scene.from_data ? data_model(scene.a) : asset_model(scene.a);
  const auto b = scene.from_data ? data_model(scene.b, scene.b_scale) : asset_model(scene.b, scene.b_scale);
  return {a, b, cutoff * a->bounds().diagonal()};
}

std::vector<Pose> motion_of(const ModelPair& pair, int poses, std::uint64_t seed) {
  Random random(seed);
  return sliding_motion(*pair.a, *pair.b, pair.cutoff, kSpeed * pair.a->bounds().diagonal(), poses, random);
}

}  // namespace palpate::bench
