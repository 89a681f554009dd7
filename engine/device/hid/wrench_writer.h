#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "engine/base/clock.h"
#include "engine/device/device_wrench.h"
#include "engine/device/hid/hid_link.h"
#include "engine/device/hid/ohhp_wrench.h"
#include "engine/exchange/bell.h"
#include "engine/exchange/counter.h"
#include "engine/exchange/flag.h"
#include "engine/exchange/triple_slot.h"

namespace palpate {

// Sends an OHHP device what it is to push with, and turns its amplifiers on and off. A transfer blocks, so it
// has a thread of its own and a mailbox of one: what the servo asked for last is sent, what it asked for
// before is forgotten. Where the servo asks for nothing more, the device is told to let go.
class WrenchWriter {
 public:
  struct Order {
    DeviceWrench wrench;
    std::uint16_t answered = 0;  // the sample it was computed from
    bool engaged = false;        // force may follow
  };

  // `link` must outlive the writer. `watchdog`: s that a wrench lives, and within which the next must come.
  WrenchWriter(HidLink& link, double watchdog) : link_(link), watchdog_(watchdog) {}
  ~WrenchWriter() { stop(); }
  WrenchWriter(const WrenchWriter&) = delete;
  WrenchWriter& operator=(const WrenchWriter&) = delete;

  void start();
  void stop();  // the device lets go; waits for a transfer that is on its way

  // The servo's; neither waits nor allocates.
  void post(const Order& order);
  std::uint64_t sent() const { return sent_.value(); }  // transfers that were completed

  // From any thread.
  void calibrate() { calibrating_.raise(); }

  // The reader's: whether the device says that its amplifiers are on.
  void hear(bool armed);

 private:
  void run();
  void send(const Order& order);
  void command(HidConnection& connection, bool engaged);
  Order after_silence();

  HidLink& link_;
  const double watchdog_;
  TripleSlot<Order> orders_;
  Bell posted_;
  Counter sent_;
  Flag calibrating_;
  Flag armed_;
  Flag stop_;
  std::optional<Stopwatch> commanded_;  // since the last arm or disarm
  int silences_ = 0;                    // how many watchdogs' times the servo has asked for nothing
  std::thread thread_;
};

}  // namespace palpate
