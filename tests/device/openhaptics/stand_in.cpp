// A stand-in for the vendor's libHD: the same functions, and devices that are simulated.

#include "tests/device/openhaptics/stand_in.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "engine/exchange/flag.h"
#include "tests/device/openhaptics/stand_in_device.h"

namespace palpate::test {
namespace {

using hd::Boolean, hd::Callback, hd::Enum, hd::ErrorCode, hd::ErrorInfo, hd::Handle, hd::Schedule;

constexpr int kRate = 1000;
constexpr Handle kFirstHandle = 3;  // so that it is not mistaken for an index
constexpr std::size_t kMostErrors = 64;

struct Library {
  std::recursive_mutex mutex;  // of all that follows
  std::array<std::unique_ptr<StandInDevice>, StandInControls::kDevices> devices;
  Handle current = hd::kNoDevice;
  std::vector<ErrorInfo> errors;
  Callback callback = nullptr;
  void* user = nullptr;
  bool scheduled = false;
  bool started = false;
  bool real_time = false;
  int starts = 0;

  std::mutex ticking;  // held by whoever ticks: stopping waits for the end of a tick
  Flag stop;
  Flag stalls;
  std::thread thread;
};

Library& library() {
  static auto* const instance = new Library;
  return *instance;
}

StandInDevice* device_of(Handle handle) {
  const std::size_t index = handle - kFirstHandle;
  return index < library().devices.size() ? library().devices[index].get() : nullptr;
}

StandInDevice* current() {
  return device_of(library().current);
}

void fail(ErrorCode code, Handle device) {
  std::vector<ErrorInfo>& errors = library().errors;
  if (code != 0 && errors.size() < kMostErrors) errors.push_back({code, 7, device});
}

void tick() {
  Library& all = library();
  const std::lock_guard ticks(all.ticking);
  Callback callback = nullptr;
  {
    const std::lock_guard lock(all.mutex);
    for (const auto& device : all.devices) device->step();
    if (all.started && all.scheduled) callback = all.callback;
  }
  if (!callback || callback(all.user) == hd::kGoOn) return;
  const std::lock_guard lock(all.mutex);
  all.scheduled = false;
}

void run() {
  auto due = std::chrono::steady_clock::now();
  while (!library().stop.raised()) {
    due = std::max(due + std::chrono::milliseconds(1), std::chrono::steady_clock::now());
    std::this_thread::sleep_until(due);
    if (!library().stalls.raised()) tick();
  }
}

void reset(bool real_time) {
  Library& all = library();
  const std::lock_guard lock(all.mutex);
  all.devices[0] = std::make_unique<StandInDevice>("Default Device", "PHANTOM Premium 1.5 6DOF",
                                                   premium6dof_spec(), hd::kByEncoderReset);
  all.devices[1] = std::make_unique<StandInDevice>("Left", "Touch", touch_spec(), hd::kByInkwell);
  all.errors.clear();
  all.current = hd::kNoDevice;
  all.starts = 0;
  all.real_time = real_time;
  all.stalls.lower();
}

void tick_often(int count) {
  for (int i = 0; i < count; ++i) tick();
}

void stall(bool stalls) {
  if (stalls) {
    library().stalls.raise();
  } else {
    library().stalls.lower();
  }
}

StandInRecord record(int device) {
  const std::lock_guard lock(library().mutex);
  return library().devices[static_cast<std::size_t>(device)]->record();
}

void set(int device, const StandInFaults& faults) {
  const std::lock_guard lock(library().mutex);
  library().devices[static_cast<std::size_t>(device)]->set(faults);
}

int starts() {
  const std::lock_guard lock(library().mutex);
  return library().starts;
}

// Calls a function of the current device and keeps its error.
template <class Call>
void with_current(Call call) {
  const std::lock_guard lock(library().mutex);
  StandInDevice* const device = current();
  fail(device && device->is_open() ? call(*device) : 0x0104, library().current);
}

}  // namespace
}  // namespace palpate::test

using namespace palpate;
using namespace palpate::test;

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED const StandInControls* palpate_stand_in() {
  static const StandInControls controls{reset, tick_often, stall, record, set, starts};
  return &controls;
}

EXPORTED Handle hdInitDevice(const char* name) {
  const std::lock_guard lock(library().mutex);
  const std::string_view wanted = name ? name : "Default Device";
  for (Handle handle = kFirstHandle; StandInDevice* const device = device_of(handle); ++handle) {
    if (wanted != device->name()) continue;
    ErrorCode error = device->is_open() ? hd::kAlreadyOpen : device->faults.opening_error;
    if (device->faults.unplugged) error = hd::kCommunication;
    fail(error, hd::kNoDevice);
    if (error) return hd::kNoDevice;
    device->open();
    library().current = handle;
    return handle;
  }
  fail(hd::kCommunication, hd::kNoDevice);
  return hd::kNoDevice;
}

EXPORTED void hdDisableDevice(Handle handle) {
  const std::lock_guard lock(library().mutex);
  if (StandInDevice* const device = device_of(handle)) device->close();
}

EXPORTED void hdMakeCurrentDevice(Handle handle) {
  const std::lock_guard lock(library().mutex);
  library().current = handle;
}

EXPORTED void hdBeginFrame(Handle handle) {
  const std::lock_guard lock(library().mutex);
  library().current = handle;
  with_current([](StandInDevice& device) { return device.begin_frame(); });
  if (StandInDevice* const device = device_of(handle))
    fail(std::exchange(device->faults.stray_error, 0),
         handle == kFirstHandle ? kFirstHandle + 1 : kFirstHandle);
}

EXPORTED void hdEndFrame(Handle handle) {
  const std::lock_guard lock(library().mutex);
  library().current = handle;
  with_current([](StandInDevice& device) { return device.end_frame(); });
}

EXPORTED ErrorInfo hdGetError() {
  const std::lock_guard lock(library().mutex);
  std::vector<ErrorInfo>& errors = library().errors;
  if (errors.empty()) return {0, 0, hd::kNoDevice};
  const ErrorInfo newest = errors.back();
  errors.pop_back();
  return newest;
}

EXPORTED const char* hdGetErrorString(ErrorCode code) {
  return code == hd::kFrame ? "stand-in frame error" : "stand-in error";
}

EXPORTED void hdEnable(Enum what) {
  if (what == hd::kForceOutput) with_current([](StandInDevice& device) { return device.set_output(true); });
}

EXPORTED void hdDisable(Enum what) {
  if (what == hd::kForceOutput) with_current([](StandInDevice& device) { return device.set_output(false); });
}

EXPORTED void hdGetDoublev(Enum what, double* numbers) {
  with_current([=](StandInDevice& device) { return device.get_doubles(what, numbers); });
}

EXPORTED void hdGetIntegerv(Enum what, int* number) {
  if (what == hd::kUpdateRate) {
    *number = kRate;
    return;
  }
  with_current([=](StandInDevice& device) { return device.get_integer(what, number); });
}

EXPORTED void hdGetBooleanv(Enum what, Boolean* truth) {
  with_current([=](StandInDevice& device) { return device.get_boolean(what, truth); });
}

EXPORTED const char* hdGetString(Enum what) {
  const char* text = "";
  with_current([&](StandInDevice& device) {
    text = what == hd::kModel ? device.model() : "S-1234";
    return ErrorCode{0};
  });
  return text;
}

EXPORTED void hdSetDoublev(Enum what, const double* numbers) {
  with_current([=](StandInDevice& device) { return device.set_doubles(what, numbers); });
}

EXPORTED Enum hdCheckCalibration() {
  Enum calibration = hd::kCalibrationByHand;
  with_current([&](StandInDevice& device) {
    calibration = device.faults.calibration;
    return ErrorCode{0};
  });
  return calibration;
}

EXPORTED void hdUpdateCalibration(Enum style) {
  with_current([=](StandInDevice& device) {
    if (device.in_frame()) return hd::kFrame;
    device.update_calibration(static_cast<int>(style));
    return ErrorCode{0};
  });
}

EXPORTED void hdStartScheduler() {
  Library& all = library();
  const std::lock_guard lock(all.mutex);
  all.started = true;
  ++all.starts;
  if (!all.real_time) return;
  all.stop.lower();
  all.thread = std::thread(run);
}

EXPORTED void hdStopScheduler() {
  Library& all = library();
  all.stop.raise();
  if (all.thread.joinable()) all.thread.join();
  const std::lock_guard ticks(all.ticking);
  const std::lock_guard lock(all.mutex);
  all.started = false;
}

EXPORTED void hdSetSchedulerRate(unsigned long rate) {
  if (rate != static_cast<unsigned long>(kRate)) fail(0x0101, hd::kNoDevice);
}

EXPORTED Schedule hdScheduleAsynchronous(Callback callback, void* user, unsigned short) {
  Library& all = library();
  const std::lock_guard lock(all.mutex);
  all.callback = callback;
  all.user = user;
  all.scheduled = true;
  return 1;
}

#ifndef PALPATE_STAND_IN_LACKS_A_FUNCTION
EXPORTED void hdUnschedule(Schedule) {
  const std::lock_guard lock(library().mutex);
  library().scheduled = false;
}
#endif
