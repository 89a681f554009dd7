// Devices on a bus that stands before hidapi's.
#include <array>
#include <chrono>
#include <thread>

#include "samples/hid_device/report.h"
#include "tests/capi/devices.h"
#include "tests/fault/calls.h"
#include "tests/fault/device_scenarios.h"
#include "tests/fuzz/hostile_bus.h"

namespace palpate::test {
namespace {

using fuzz::HostileBus;

constexpr int kPatienceMs = 10'000;

template <std::size_t kSize>
HostileBus::Report bytes_of(const std::array<std::uint8_t, kSize>& report) {
  return {report.begin(), report.end()};
}

// A device and what it says.
struct Kind {
  const char* uri;
  HostileBus::Identity identity;
  HostileBus::Report features;
  HostileBus::Report (*report)(std::uint16_t number);
};

HostileBus::Report sample(std::uint16_t number) {
  ::palpate::hid_device::Sample sample;
  sample.flags = sample.kCalibrated | sample.kArmed | sample.kDeadMan;
  sample.sequence = number;
  sample.time_us = 1000u * number;
  return bytes_of(report_of(sample));
}

HostileBus::Report push(std::uint16_t number) {
  return {1, static_cast<std::uint8_t>(number), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
}

// A program whose scene's tool hangs on the device.
class Session {
 public:
  Session(Journey& journey, const Kind& kind) : journey_(journey), kind_(kind) { plug(); }
  ~Session() { HostileBus::the().unplug(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void run() {
    begin();
    steps();
    plug();
    if (!comes_true([] { return is_back(); })) journey_.complain("does not come back");
    steps();
    HostileBus::the().unplug();
    if (!comes_true([&] { return is_lost(); })) journey_.complain("is not missed");
    steps();
    end();
  }

 private:
  void plug() { HostileBus::the().plug({kind_.identity, kind_.features, kind_.report(++number_)}); }

  void begin() {
    std::array<plp_device_info, 8> infos;
    for (plp_device_info& info : infos) plp_device_info_init(&info, sizeof info);
    std::size_t count = 0;
    journey_("plp_device_list", [&] { return plp_device_list(infos.data(), infos.size(), &count); });
    journey_.keep(count);
    journey_("plp_device_open", [&] { return plp_device_open(kind_.uri, &device_); });
    cube_ = new_model(journey_, box(0.05f, 0.05f, 0.05f));
    scene_ = new_scene(journey_, TestScene::options_with(0.01));
    add(journey_, scene_, cube_, PLP_BODY_STATIC, at(0, -0.105, 0));
    add(journey_, scene_, cube_, PLP_BODY_TOOL, at(0, 0, 0));
    journey_("plp_scene_set_device", [&] { return plp_scene_set_device(scene_, device_, nullptr); });
    journey_("plp_device_arm", [&] { return plp_device_arm(device_); });
  }

  void steps() {
    plp_device_info info;
    plp_device_info_init(&info, sizeof info);
    for (int i = 0; i < 3; ++i) {
      HostileBus::the().report(kind_.report(++number_));
      journey_("plp_scene_step", [&] { return plp_scene_step(scene_); });
    }
    journey_("plp_device_get_info", [&] { return plp_device_get_info(device_, &info); });
  }

  void end() {
    journey_("plp_scene_set_device", [&] { return plp_scene_set_device(scene_, nullptr, nullptr); });
    journey_("plp_device_release", [&] { return plp_device_release(device_); });
    release(journey_, scene_);
    release(journey_, cube_);
  }

  // A device that finds no memory tries again, and by then there is some.
  static bool is_back() {
    if (FailingAllocation::failed()) FailingAllocation::pass();
    return HostileBus::the().is_heard();
  }

  bool is_lost() const {
    plp_device_state state;
    plp_device_state_init(&state, sizeof state);
    plp_scene_step(scene_);
    plp_device_get_state(device_, &state);
    return state.condition == PLP_CONDITION_LOST;
  }

  template <class Holds>
  static bool comes_true(Holds holds) {
    for (int i = 0; i < kPatienceMs && !holds(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return holds();
  }

  Journey& journey_;
  const Kind& kind_;
  plp_device device_ = nullptr;
  plp_model cube_ = nullptr;
  plp_scene scene_ = nullptr;
  std::uint16_t number_ = 0;
};

}  // namespace

void hid_device(Journey& journey) {
  const auto features = bytes_of(report_of(::palpate::hid_device::Features()));
  Session(journey, {"hid:1209:0001", {0x1209, 1, 0xFF48, 1}, features, sample}).run();
}

void space_mouse(Journey& journey) {
  Session(journey, {"hid:256f:c635", {0x256F, 0xC635, 1, 8}, {}, push}).run();
}

}  // namespace palpate::test
