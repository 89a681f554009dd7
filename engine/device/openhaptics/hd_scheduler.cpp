#include "engine/device/openhaptics/hd_scheduler.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "engine/base/log.h"
#include "engine/base/own_thread.h"
#include "engine/device/openhaptics/hd_device.h"
#include "engine/device/openhaptics/hd_error.h"

namespace palpate {
namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned long kRate = 1000;  // Hz, asked for
constexpr int kLeastRate = 100;        // Hz; less is no answer
// What is later by less is jitter; by more, a debugger's breakpoint or a system that slept: a tick is told.
constexpr double kLongestTick = 0.25;                     // s
constexpr std::uint64_t kSilentTicks = 2;                 // in which force surely has ended
constexpr std::chrono::milliseconds kLongestSilence{50};  // a scheduler that hangs is not waited for
constexpr std::chrono::microseconds kLookAgain{200};
constexpr std::chrono::milliseconds kKeepingPause{20};
constexpr double kTryAgain = 0.5;  // s from one attempt to take up a lost device to the next
constexpr double kTryAgainBesideOthers = 2.0;

double now() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

// While one lives, the scheduler rests.
class HdScheduler::Rest {
 public:
  explicit Rest(HdScheduler& scheduler) : scheduler_(scheduler) { scheduler_.rest(); }
  ~Rest() { scheduler_.resume(); }
  Rest(const Rest&) = delete;
  Rest& operator=(const Rest&) = delete;

 private:
  HdScheduler& scheduler_;
};

Status HdScheduler::open(HdDevice& device) {
  const std::lock_guard lock(mutex_);
  if (devices_.size() == kMostDevices)
    return Error{ErrorCode::kLimit, "no more than " + std::to_string(kMostDevices) + " devices may be open"};
  if (Status keeps = start_keeper(); !keeps) return keeps;
  devices_.reserve(kMostDevices);
  const Rest rest(*this);
  try {
    Status connected = device.connect();
    if (connected) lend(device);
    return connected;
  } catch (...) {
    device.disconnect();
    throw;
  }
}

void HdScheduler::lend(HdDevice& device) {
  devices_.push_back(&device);
  const auto free = std::find(lent_.begin(), lent_.end(), nullptr);
  *free = &device;
  loans_[static_cast<std::size_t>(free - lent_.begin())].lend(device);
}

void HdScheduler::close(HdDevice& device) {
  std::thread ended;
  {
    const std::lock_guard lock(mutex_);
    const auto lent = std::find(lent_.begin(), lent_.end(), &device);
    if (lent == lent_.end()) return;
    rest();
    loans_[static_cast<std::size_t>(lent - lent_.begin())].take_back();
    *lent = nullptr;
    std::erase(devices_, &device);
    device.disconnect();
    resume();
    if (devices_.empty()) stop_keeper(ended);
  }
  if (ended.joinable()) ended.join();
}

void HdScheduler::end_with_process() {
  std::thread ended;
  {
    const std::lock_guard lock(mutex_);
    rest();
    stop_keeper(ended);
  }
  if (ended.joinable()) ended.join();
}

Status HdScheduler::start_keeper() {
  if (keeper_.joinable()) return Done{};
  stops_keeping_ = false;
  try {
    keeper_ = std::thread([this] { keep(); });
  } catch (const std::system_error&) {
    return Error{ErrorCode::kLimit, "the system allows no more threads"};
  }
  return Done{};
}

// It ends once the lock is free.
void HdScheduler::stop_keeper(std::thread& ended) {
  stops_keeping_ = true;
  ended.swap(keeper_);
  keeps_.notify_all();
}

// Once: versions refuse it later, or have one rate only.
void HdScheduler::set_rate() {
  if (std::exchange(rate_is_set_, true)) return;
  call.hdSetSchedulerRate(kRate);
  clear_errors(call);
  int rate = 0;
  call.hdGetIntegerv(hd::kUpdateRate, &rate);
  if (clear_errors(call).code == 0 && rate >= kLeastRate) period_ = 1.0 / rate;
}

// The callback is scheduled anew each time: whether one outlives a rest differs between versions.
void HdScheduler::resume() {
  alone_ = devices_.size() <= 1;
  last_tick_ = -1.0;
  errors_ = 0;
  silent_.lower();
  if (devices_.empty() || running_) return;
  clear_errors(call);
  schedule_ = call.hdScheduleAsynchronous(&HdScheduler::on_tick, this, hd::kHighestPriority);
  call.hdStartScheduler();  // an error of it is found by the ticks, or by their absence
  running_ = true;
}

void HdScheduler::rest() {
  if (!running_) return;
  wait_for_silence();
  call.hdStopScheduler();
  call.hdUnschedule(schedule_);
  clear_errors(call);
  running_ = false;
}

void HdScheduler::wait_for_silence() {
  silent_.raise();
  const std::uint64_t until = ticks_.value() + kSilentTicks;
  const auto end = Clock::now() + kLongestSilence;
  while (ticks_.value() < until && Clock::now() < end) std::this_thread::sleep_for(kLookAgain);
}

unsigned int HdScheduler::on_tick(void* scheduler) {
  static_cast<HdScheduler*>(scheduler)->tick();
  return hd::kGoOn;
}

void HdScheduler::tick() {
  const double dt = passed();
  const bool silent = silent_.raised();
  for (Loan<HdDevice>& loan : loans_) loan.use([dt, silent](HdDevice& device) { device.tick(dt, silent); });
  ticks_.add(1);
}

double HdScheduler::passed() {
  const double time = now();
  const double passed = last_tick_ < 0.0 ? period_ : time - last_tick_;
  last_tick_ = time;
  return passed > kLongestTick ? passed : period_;
}

void HdScheduler::collect_errors(hd::Handle device) {
  for (int i = 0; i < kMostErrors; ++i) {
    hd::ErrorInfo error = call.hdGetError();
    if (error.code == 0) return;
    if (alone_ || error.device == hd::kNoDevice) error.device = device;
    if (errors_ < error_list_.size()) error_list_[errors_++] = error;
  }
}

bool HdScheduler::concerns(const hd::ErrorInfo& error, hd::Handle device) const {
  return error.device == device;
}

void HdScheduler::forget_errors(hd::Handle device) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < errors_; ++i)
    if (!concerns(error_list_[i], device)) error_list_[kept++] = error_list_[i];
  errors_ = kept;
}

void HdScheduler::keep() {
  begin_own_thread("palpate-keeper");
  std::unique_lock lock(mutex_);
  while (!stops_keeping_) {
    for (HdDevice* device : devices_) {
      try {
        if (device->is_lost()) recover(*device);
      } catch (const std::exception&) {
        // Out of memory: the device stays lost until the next attempt.
      }
    }
    keeps_.wait_for(lock, kKeepingPause);
  }
}

// An attempt changes the library's current device, so the others rest meanwhile; they are not to be troubled
// often.
void HdScheduler::recover(HdDevice& device) {
  const bool others =
      std::any_of(devices_.begin(), devices_.end(), [](HdDevice* any) { return !any->is_lost(); });
  const bool connected = device.is_connected();
  if (!connected && device.unsought(now()) < (others ? kTryAgainBesideOthers : kTryAgain)) return;
  const bool found = sought(device);
  if (found) {
    log(LogLevel::kInfo, device.info().identity.uri + " answers again");
  } else if (connected) {
    log(LogLevel::kWarning, device.info().identity.uri + " does not answer");
  }
}

bool HdScheduler::sought(HdDevice& device) {
  const Rest rest(*this);
  device.disconnect();
  return device.take_up(now());
}

}  // namespace palpate
