#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/device/hid/crc8.h"
#include "tests/fuzz/box_model.h"
#include "tests/fuzz/hostile_bus.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/sound.h"
#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

constexpr std::size_t kReport = 64;  // bytes of a feature report and of a sample
constexpr std::size_t kMostEvents = 48;
constexpr float kCube = 0.1f;  // m

HostileBus::Report bytes_of(Input& input, std::size_t count) {
  HostileBus::Report bytes(count);
  for (std::uint8_t& byte : bytes) byte = input.byte();
  return bytes;
}

// With the checksum that a whole report ends in; otherwise hardly any would get further.
HostileBus::Report sealed(HostileBus::Report report) {
  if (!report.empty()) report.back() = crc8(std::span(report).first(report.size() - 1));
  return report;
}

template <class Number>
void put(HostileBus::Report& report, std::size_t at, Number number) {
  std::memcpy(report.data() + at, &number, sizeof number);
}

// A haptic device of 5 N, or one like it.
HostileBus::Report features(Input& input) {
  HostileBus::Report report{3, 'O',  'H', 'H', 'P', 1, 63, 63,   input.byte(),
                            4, 0xE8, 3,   20,  0,   0, 0,  0x88, 0x13};
  report.resize(kReport);
  put(report, 20, std::uint32_t{2'000});
  put(report, 24, std::uint32_t{500'000});
  put(report, 32, std::uint32_t{2'000});
  for (std::size_t i = input.below(4); i > 0; --i) report[input.below(kReport)] = input.byte();
  return input.byte() < 240 ? sealed(report) : bytes_of(input, input.below(kReport + 8));
}

// A device that is calibrated, armed and held at the origin.
HostileBus::Report resting_sample() {
  HostileBus::Report report(kReport);
  report[0] = 1;
  report[1] = 7;
  put(report, 2, std::uint16_t{1});
  put(report, 32, std::int32_t{1 << 30});
  return sealed(report);
}

HostileBus::Plugged device(Input& input) {
  if (input.byte() < 64) return {{0x256F, 0xC635, 1, 8}, {}, {}};
  return {{0x1209, 1, 0xFF48, 1}, features(input), resting_sample()};
}

// A program whose scene's tool hangs on a device on the bus.
class Session {
 public:
  explicit Session(Input& input) : input_(input), model_(box_model(kCube)) {}

  ~Session() {
    plp_scene_release(scene_);
    plp_device_release(device_);
    plp_model_release(model_);
    HostileBus::the().unplug();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void run() {
    HostileBus::Plugged plugged = device(input_);
    const char* const uri = plugged.features.empty() ? "hid:256f:c635" : "hid:1209:0001";
    HostileBus::the().plug(std::move(plugged));
    if (checked(plp_device_open(uri, &device_)) < 0) return require(!device_, "no device after an error");
    begin();
    for (std::size_t i = 0; i < kMostEvents && !input_.at_end(); ++i) {
      happen();
      tick();
    }
    require(HostileBus::the().strongest() <= most_force_ + 1e-5, "no more force than the device's own limit");
  }

 private:
  // The tool's cube rests five millimetres above another.
  void begin() {
    plp_device_info info;
    plp_device_info_init(&info, sizeof info);
    require(checked(plp_device_get_info(device_, &info)) == PLP_OK, "an info");
    require(std::isfinite(info.max_force) && info.max_force >= 0.0 && info.max_force <= 50.0,
            "a limit of force");
    most_force_ = info.max_force;
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    options.cutoff = kCutoff;
    options.mode = PLP_MODE_GLOBAL;
    options.time_step = 0.01;  // so that force has faded in before the events end
    require(checked(plp_scene_create(&options, &scene_)) == PLP_OK, "a scene");
    add(PLP_BODY_STATIC, -0.105);
    add(PLP_BODY_TOOL, 0.0);
    require(checked(plp_scene_set_device(scene_, device_, nullptr)) == PLP_OK, "a device for the scene");
    checked(plp_device_arm(device_));
  }

  void add(plp_body_kind kind, double height) {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = model_;
    options.kind = kind;
    options.pose.position[1] = height;
    plp_body body = 0;
    require(checked(plp_scene_add_body(scene_, &options, &body)) == PLP_OK, "a body");
  }

  void happen() {
    switch (input_.byte() % 16) {
      case 0:
        return void(checked(plp_device_arm(device_)));
      case 1:
        return void(checked(plp_device_disarm(device_)));
      case 2:
        return void(checked(plp_device_calibrate(device_)));
      case 3:
        return HostileBus::the().report(bytes_of(input_, input_.below(kReport + 8)));
      case 4:
        return HostileBus::the().report(sealed(bytes_of(input_, kReport)));
      case 5:
        return HostileBus::the().unplug();
      case 6:
        return;  // silence
      case 7:
        return HostileBus::the().report(push());
      default:
        return HostileBus::the().report(sample());
    }
  }

  // Of a SpaceMouse.
  HostileBus::Report push() {
    HostileBus::Report report = bytes_of(input_, 13);
    report[0] = static_cast<std::uint8_t>(1 + input_.below(3));
    return report;
  }

  // Held near the other cube; mostly.
  HostileBus::Report sample() {
    HostileBus::Report report = resting_sample();
    if (input_.byte() >= 200) report[1] = input_.byte();
    sequence_ = static_cast<std::uint16_t>(sequence_ + (input_.byte() < 220 ? 1 : input_.byte()));
    put(report, 2, sequence_);
    put(report, 4, time_us_ += 1'000);
    for (std::size_t i = 0; i < 3; ++i)
      put(report, 8 + 4 * i, static_cast<std::int32_t>(200 * (static_cast<int>(input_.byte()) - 128)));
    for (std::size_t i = input_.byte() < 200 ? 0 : input_.below(4); i > 0; --i)
      report[input_.below(kReport)] = input_.byte();
    return sealed(report);
  }

  void tick() {
    step(scene_, kCutoff);
    plp_device_state state;
    plp_device_state_init(&state, sizeof state);
    require(checked(plp_device_get_state(device_, &state)) == PLP_OK, "a state");
    require_sound(state);
    const double* const force = state.applied.force;
    require(std::hypot(force[0], force[1], force[2]) <= most_force_ * (1.0 + 1e-9),
            "a force within the limit");
  }

  static constexpr double kCutoff = 0.02;

  Input& input_;
  plp_model model_;
  plp_scene scene_ = nullptr;
  plp_device device_ = nullptr;
  double most_force_ = 0.0;
  std::uint16_t sequence_ = 1;
  std::uint32_t time_us_ = 0;
};

}  // namespace

void hid(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  Session(input).run();
}

}  // namespace palpate::fuzz
