#include <array>
#include <vector>

#include "tests/fuzz/box_model.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/sound.h"
#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

constexpr std::size_t kMostCalls = 64;

// What a program holds: living handles, and dead ones that it goes on using.
class Program {
 public:
  explicit Program(Input& input) : input_(input) {}

  ~Program() {
    for (plp_scene scene : scenes_) plp_scene_release(scene);
    for (plp_device device : devices_) plp_device_release(device);
    for (plp_model model : models_) plp_model_release(model);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void run() {
    for (std::size_t i = 0; i < kMostCalls && !input_.at_end(); ++i) call();
  }

 private:
  void call() {
    switch (input_.byte() % 24) {
      case 0:
        return make_model();
      case 1:
        return void(checked(plp_model_release(one_of(models_))));
      case 2:
        return make_scene();
      case 3:
        return void(checked(plp_scene_release(one_of(scenes_))));
      case 4:
      case 5:
        return add_body();
      case 6:
        return void(checked(plp_scene_remove_body(one_of(scenes_), one_of(bodies_))));
      case 7:
      case 8:
        return set_pose();
      case 9:
        return get_pose();
      case 10:
        return void(checked(plp_scene_set_cutoff(one_of(scenes_), cutoff())));
      case 11:
        return void(checked(plp_scene_set_stiffness(one_of(scenes_), input_.number())));
      case 12:
        return void(checked(plp_scene_set_mode(one_of(scenes_), small())));
      case 13:
        return void(checked(plp_scene_set_law(one_of(scenes_), small())));
      case 14:
        return set_force();
      case 15:
      case 16:
      case 17:
        return step();
      case 18:
        return start();
      case 19:
        return void(checked(plp_scene_stop(one_of(scenes_))));
      case 20:
        return open_device();
      case 21:
        return use_device();
      case 22:
        return set_device();
      default:
        return void(checked(plp_model_prepare(one_of(models_))));
    }
  }

  template <class Handle>
  Handle one_of(const std::vector<Handle>& handles) {
    const std::uint8_t which = input_.byte();
    if (handles.empty() || which == 255) return {};
    return handles[which % handles.size()];
  }

  std::int32_t small() { return static_cast<std::int32_t>(input_.byte() % 5) - 1; }

  // Larger ones would only be slow. What is refused stays out of require_sound's way.
  double cutoff() {
    const double cutoff = input_.number();
    if (cutoff > largest_cutoff_ && cutoff <= 1e15) largest_cutoff_ = cutoff;
    return cutoff;
  }

  void make_model() {
    const plp_model model = box_model(1.0f, 1 + input_.below(kBoxTriangles));
    if (model) models_.push_back(model);
  }

  void make_scene() {
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    options.cutoff = cutoff();
    options.mode = small();
    options.law = small();
    options.global_every = input_.byte();
    options.damping = input_.byte() < 200 ? 0.0 : input_.number();
    options.stiffness_cap = input_.byte() < 128 ? 0.0 : input_.number();
    options.friction = input_.byte() < 200 ? 0.0 : input_.number();
    options.tick_budget = input_.byte() < 200 ? 0 : input_.byte();
    options.threads = input_.byte() < 250 ? 0 : 2;
    plp_scene scene = nullptr;
    if (checked(plp_scene_create(&options, &scene)) >= 0) scenes_.push_back(scene);
  }

  void add_body() {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = one_of(models_);
    const std::uint8_t kind = input_.byte() % 4;
    std::memcpy(&options.kind, std::array<std::int32_t, 1>{kind}.data(), sizeof options.kind);
    options.pose = input_.pose();
    options.stiffness = input_.byte() < 200 ? 0.0 : input_.number();
    options.friction = input_.byte() < 200 ? 0.0 : input_.number();
    plp_body body = 0;
    if (checked(plp_scene_add_body(one_of(scenes_), &options, &body)) >= 0) bodies_.push_back(body);
  }

  void set_pose() {
    const plp_pose pose = input_.pose();
    checked(plp_scene_set_pose(one_of(scenes_), one_of(bodies_), &pose));
  }

  void get_pose() {
    plp_pose pose;
    if (checked(plp_scene_get_pose(one_of(scenes_), one_of(bodies_), &pose)) >= 0)
      for (const double x : pose.position) require(x - x == 0.0, "a finite pose");
  }

  void set_force() {
    const plp_scene scene = one_of(scenes_);
    switch (input_.byte() % 3) {
      case 0:
        return void(checked(plp_scene_set_damping(scene, input_.number())));
      case 1:
        return void(checked(plp_scene_set_stiffness_cap(scene, input_.number())));
      default:
        return void(checked(plp_scene_set_friction(scene, input_.number())));
    }
  }

  void step() {
    const plp_scene scene = one_of(scenes_);
    checked(plp_scene_step(scene));
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    if (checked(plp_scene_get_contacts(scene, &contacts)) >= 0) require_sound(contacts, largest_cutoff_);
  }

  void start() {
    plp_servo_options options;
    plp_servo_options_init(&options, sizeof options);
    options.priority = -1;
    if (input_.byte() > 200) options.rate = input_.number();
    checked(plp_scene_start(one_of(scenes_), &options));
  }

  void open_device() {
    constexpr const char* kUris[] = {
        nullptr,  "", "sim:touch", "sim:premium6dof", "sim:nothing", "sim:touch?delay=3", "sim:touch?delay=9",
        "nothing"};
    plp_device device = nullptr;
    if (checked(plp_device_open(kUris[input_.below(std::size(kUris))], &device)) >= 0)
      devices_.push_back(device);
  }

  void use_device() {
    const plp_device device = one_of(devices_);
    switch (input_.byte() % 6) {
      case 0:
        return void(checked(plp_device_arm(device)));
      case 1:
        return void(checked(plp_device_disarm(device)));
      case 2:
        return void(checked(plp_device_release(device)));
      case 3:
        return set_hand(device);
      case 4:
        return void(checked(plp_device_place_in_hand(device)));
      default:
        return read(device);
    }
  }

  void set_hand(plp_device device) {
    plp_hand_options options;
    plp_hand_options_init(&options, sizeof options);
    options.script = small();
    options.grip = small();
    options.depth = input_.number();
    options.period = input_.byte() < 200 ? 0.1 : input_.number();
    checked(plp_device_set_hand(device, &options));
  }

  void read(plp_device device) {
    plp_device_state state;
    plp_device_state_init(&state, sizeof state);
    if (checked(plp_device_get_state(device, &state)) >= 0) require_sound(state);
  }

  void set_device() {
    plp_device_mapping mapping;
    plp_device_mapping_init(&mapping, sizeof mapping);
    mapping.scene_from_base = input_.pose();
    if (input_.byte() > 200) mapping.motion_scale = input_.number();
    if (input_.byte() > 200) mapping.force_scale = input_.number();
    checked(plp_scene_set_device(one_of(scenes_), one_of(devices_), &mapping));
  }

  Input& input_;
  std::vector<plp_model> models_;
  std::vector<plp_scene> scenes_;
  std::vector<plp_body> bodies_;
  std::vector<plp_device> devices_;
  double largest_cutoff_ = 0.0;
};

}  // namespace

void calls(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  Program(input).run();
}

}  // namespace palpate::fuzz
