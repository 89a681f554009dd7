#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

struct hid_device_;

namespace palpate {

// An open device node. One thread at a time.
class HidHandle {
 public:
  // None if the system refuses.
  static std::optional<HidHandle> open(const std::string& path);

  // How many bytes of a report came within the time, 0 for none; -1 once the device has gone.
  int read(std::span<std::uint8_t> report, int timeout_ms);

  // The first byte is the report's id. These wait for the transfer, half a millisecond or a stuck bus'
  // seconds.
  bool write(std::span<const std::uint8_t> report);
  bool send_feature(std::span<const std::uint8_t> report);
  // `report[0]` is the id. How many bytes there are, the id among them; -1 if the device refuses.
  int get_feature(std::span<std::uint8_t> report);

 private:
  struct Close {
    void operator()(hid_device_* device) const;
  };

  explicit HidHandle(hid_device_* device) : device_(device) {}

  std::unique_ptr<hid_device_, Close> device_;
};

}  // namespace palpate
