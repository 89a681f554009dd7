#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <thread>

#include "engine/base/clock.h"
#include "engine/device/hid/hid_connection.h"
#include "engine/exchange/bell.h"
#include "engine/exchange/flag.h"

namespace palpate {

// Of the threads that read and write a device: just below a servo's own.
constexpr int kDevicePriority = 79;

// Hears what a device reports, from the link's own thread.
class HidListener {
 public:
  // A device of the right name has been plugged in again; false: it is another one.
  virtual bool accept(HidConnection& connection) = 0;

  // A report, its id first; those that had queued up come one after the other, and then the newest counts.
  virtual void take(std::span<const std::uint8_t> report) = 0;
  virtual void show() = 0;

  // It is there, but has not reported for so long.
  virtual void silent(double /*seconds*/) {}

  // It has been pulled out.
  virtual void lost() = 0;

 protected:
  ~HidListener() = default;
};

// Keeps a device connected and reads it: a thread that waits for reports, and where the device has gone for
// the device to come back.
class HidLink {
 public:
  // The listener must outlive the link. The thread begins with start().
  HidLink(std::shared_ptr<HidConnection> connection, HidListener& listener);
  ~HidLink();
  HidLink(const HidLink&) = delete;
  HidLink& operator=(const HidLink&) = delete;

  void start();
  void stop();

  // From any thread, but it locks. Null while the device is gone.
  std::shared_ptr<HidConnection> connection();

 private:
  void run();
  bool hear(HidConnection& connection);
  void connect_again();
  bool connect();
  void set_connection(std::shared_ptr<HidConnection> connection);

  const HidEntry entry_;
  HidListener& listener_;
  Stopwatch heard_;  // since the last report
  Flag stop_;
  Bell woken_;
  std::mutex mutex_;  // guards what follows
  std::shared_ptr<HidConnection> connection_;
  std::thread thread_;
};

}  // namespace palpate
