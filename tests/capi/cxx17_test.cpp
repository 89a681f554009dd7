// Compiled as C++17, the oldest standard that the public header promises.
#include <palpate/palpate.h>

#include <type_traits>

static_assert(__cplusplus == 201703L);
static_assert(std::is_trivially_copyable_v<plp_contacts> && std::is_standard_layout_v<plp_contacts>);
static_assert(std::is_trivially_copyable_v<plp_model_info> && std::is_standard_layout_v<plp_model_info>);
static_assert(!std::is_convertible_v<plp_model, plp_scene>, "handles of different kinds do not mix");

int main() {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  options.cutoff = 0.1;
  plp_scene scene = nullptr;
  const bool works = plp_scene_create(&options, &scene) == PLP_OK && plp_scene_step(scene) == PLP_OK &&
                     plp_scene_release(scene) == PLP_OK;
  return works ? 0 : 1;
}
