#include "engine/device/hid/hid_handle.h"

#include <hidapi.h>

#include "engine/device/hid/hidapi_memory.h"

namespace palpate {

std::optional<HidHandle> HidHandle::open(const std::string& path) {
  hid_device* const device = given_memory([&] { return hid_open_path(path.c_str()); });
  if (!device) return std::nullopt;
  return HidHandle(device);
}

int HidHandle::read(std::span<std::uint8_t> report, int timeout_ms) {
  return hid_read_timeout(device_.get(), report.data(), report.size(), timeout_ms);
}

bool HidHandle::write(std::span<const std::uint8_t> report) {
  return hid_write(device_.get(), report.data(), report.size()) == static_cast<int>(report.size());
}

bool HidHandle::send_feature(std::span<const std::uint8_t> report) {
  return hid_send_feature_report(device_.get(), report.data(), report.size()) >= 0;
}

int HidHandle::get_feature(std::span<std::uint8_t> report) {
  return hid_get_feature_report(device_.get(), report.data(), report.size());
}

void HidHandle::Close::operator()(hid_device_* device) const {
  hid_close(device);
}

}  // namespace palpate
