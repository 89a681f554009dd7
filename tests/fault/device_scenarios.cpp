#include "tests/fault/device_scenarios.h"

#include "tests/capi/devices.h"
#include "tests/device/openhaptics/stand_in_library.h"
#include "tests/fault/calls.h"

namespace palpate::test {
namespace {

void use_device(Journey& journey, const char* uri, bool simulated) {
  std::size_t count = 0;
  plp_device device = nullptr;
  journey("plp_device_list", [&] { return plp_device_list(nullptr, 0, &count); });
  journey("plp_device_open", [&] { return plp_device_open(uri, &device); });
  const plp_model cube = new_model(journey, box(0.05f, 0.05f, 0.05f));
  const plp_scene scene = new_scene(journey, TestScene::options_with(0.01));
  add(journey, scene, cube, PLP_BODY_STATIC, at(0, -0.105, 0));
  add(journey, scene, cube, PLP_BODY_TOOL, at(0, 0, 0));
  const plp_device_mapping mapping = device_mapping();
  const plp_safety_limits limits = safety_limits();
  plp_device_info info;
  plp_device_info_init(&info, sizeof info);
  journey("plp_scene_set_device", [&] { return plp_scene_set_device(scene, device, &mapping); });
  journey("plp_device_get_info", [&] { return plp_device_get_info(device, &info); });
  journey("plp_device_set_limits", [&] { return plp_device_set_limits(device, &limits); });
  if (simulated) {
    const plp_hand_options hand = hand_options();
    const double times[2] = {0.0, 1.0};
    const plp_pose poses[2] = {at(0, 0, 0), at(0, 0.001, 0)};
    journey("plp_device_set_hand", [&] { return plp_device_set_hand(device, &hand); });
    journey("plp_device_set_hand_poses", [&] { return plp_device_set_hand_poses(device, times, poses, 2); });
    journey("plp_device_place_in_hand", [&] { return plp_device_place_in_hand(device); });
  }
  journey("plp_device_arm", [&] { return plp_device_arm(device); });
  plp_device_state state;
  plp_device_state_init(&state, sizeof state);
  // A step that fails is a tick to its device, too: where the handle goes is not compared.
  for (int i = 0; i < 5; ++i) journey("plp_scene_step", [&] { return plp_scene_step(scene); });
  journey("plp_device_get_state", [&] { return plp_device_get_state(device, &state); });
  journey("plp_device_disarm", [&] { return plp_device_disarm(device); });
  journey("plp_scene_set_device", [&] { return plp_scene_set_device(scene, nullptr, nullptr); });
  journey("plp_device_release", [&] { return plp_device_release(device); });
  release(journey, scene);
  release(journey, cube);
}

}  // namespace

void simulated_device(Journey& journey) {
  use_device(journey, "sim:premium6dof", true);
}

void openhaptics_device(Journey& journey) {
  const StandInLibrary library;
  use_device(journey, StandInLibrary::uri("Default Device").c_str(), false);
}

}  // namespace palpate::test
