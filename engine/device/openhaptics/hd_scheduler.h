#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/result.h"
#include "engine/device/openhaptics/hd_abi.h"
#include "engine/exchange/counter.h"
#include "engine/exchange/flag.h"
#include "engine/exchange/loan.h"

namespace palpate {

class HdDevice;

// The one scheduler of a vendor's library: a callback on its thread ticks every open device, and a keeper of
// our own takes up devices that were lost. While a device is opened, closed or taken up the scheduler rests,
// and the others have no force for that time. Never destroyed.
class HdScheduler {
 public:
  static constexpr std::size_t kMostDevices = 8;

  explicit HdScheduler(const hd::Functions& functions) : call(functions) {}
  HdScheduler(const HdScheduler&) = delete;
  HdScheduler& operator=(const HdScheduler&) = delete;

  const hd::Functions call;

  // From any thread. Errors: kDevice, kLimit (too many).
  Status open(HdDevice& device);
  void close(HdDevice& device);

  // What has no time left to close its devices. No scheduler's function is called after it.
  void end_with_process();

  // For a device that is being opened, while the scheduler rests.
  void set_rate();
  double rate_hz() const { return 1.0 / period_; }

  // The callback's thread's.

  // Takes the errors of a device from the library's stack, where those of others may lie, too.
  template <class Take>
  void take_errors(hd::Handle device, Take&& take) {
    collect_errors(device);
    for (std::size_t i = 0; i < errors_; ++i)
      if (concerns(error_list_[i], device)) take(error_list_[i].code);
    forget_errors(device);
  }

 private:
  class Rest;

  static unsigned int on_tick(void* scheduler);
  void tick();
  double passed();

  void collect_errors(hd::Handle device);
  bool concerns(const hd::ErrorInfo& error, hd::Handle device) const;
  void forget_errors(hd::Handle device);

  void lend(HdDevice& device);
  Status start_keeper();
  void stop_keeper(std::thread& ended);
  void rest();
  void resume();
  void wait_for_silence();

  void keep();
  void recover(HdDevice& device);
  bool sought(HdDevice& device);  // and found

  std::mutex mutex_;  // guards what follows
  std::vector<HdDevice*> devices_;
  std::array<Loan<HdDevice>, kMostDevices> loans_;  // of devices_, and free ones
  std::array<HdDevice*, kMostDevices> lent_{};
  hd::Schedule schedule_ = 0;
  bool running_ = false;
  bool rate_is_set_ = false;
  bool stops_keeping_ = false;
  std::condition_variable keeps_;
  std::thread keeper_;

  Flag silent_;    // no device gives force: the scheduler is about to rest
  Counter ticks_;  // to see that silence has begun

  // The callback's thread's, and the others' while the scheduler rests.
  double period_ = 1e-3;     // s
  double last_tick_ = -1.0;  // s; negative: none since it rested
  bool alone_ = true;        // no more than one device is open
  std::array<hd::ErrorInfo, 32> error_list_{};
  std::size_t errors_ = 0;
};

}  // namespace palpate
