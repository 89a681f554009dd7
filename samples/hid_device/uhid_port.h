#pragma once

#include <chrono>
#include <string>

#include "samples/hid_device/haptic_device.h"

namespace palpate::hid_device {

// A device that the kernel believes to be plugged in, through /dev/uhid. Pulled out when this is destroyed.
class UhidPort {
 public:
  // Throws std::runtime_error with a sentence if the kernel refuses.
  UhidPort(std::uint16_t vendor, std::uint16_t product, const std::string& serial);
  ~UhidPort();
  UhidPort(const UhidPort&) = delete;
  UhidPort& operator=(const UhidPort&) = delete;

  // Gives what hosts send until then to the device, and answers them.
  void serve(HapticDevice& device, std::chrono::steady_clock::time_point until);

  // Sends a report to those who listen.
  void send(Bytes report);

 private:
  bool serve_one(HapticDevice& device);

  int file_;
};

}  // namespace palpate::hid_device
