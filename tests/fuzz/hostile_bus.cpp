#include "tests/fuzz/hostile_bus.h"

#include <hidapi.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace palpate::fuzz {
namespace {

constexpr std::chrono::milliseconds kReadersTurn{5};

// An OHHP wrench's force, µN.
double force_in(std::span<const std::uint8_t> report) {
  constexpr std::size_t kForce = 4;
  std::array<std::int32_t, 3> force{};
  if (report.size() >= kForce + sizeof force) std::memcpy(force.data(), report.data() + kForce, sizeof force);
  return 1e-6 * std::hypot(force[0], force[1], force[2]);
}

std::size_t copy(const HostileBus::Report& report, std::span<std::uint8_t> into) {
  const std::size_t count = std::min(report.size(), into.size());
  std::copy_n(report.begin(), count, into.begin());
  return count;
}

}  // namespace

HostileBus& HostileBus::the() {
  static auto* const bus = new HostileBus;  // the reader may outlast the end of main
  return *bus;
}

void HostileBus::plug(Plugged device) {
  const std::lock_guard lock(mutex_);
  waiting_ = device.first;
  plugged_ = std::move(device);
  strongest_ = 0.0;
}

void HostileBus::unplug() {
  const std::lock_guard lock(mutex_);
  plugged_.reset();
  changed_.notify_all();
}

void HostileBus::report(Report report) {
  std::unique_lock lock(mutex_);
  waiting_ = std::move(report);
  changed_.notify_all();
  changed_.wait_for(lock, kReadersTurn, [&] { return !waiting_; });
}

double HostileBus::strongest() {
  const std::lock_guard lock(mutex_);
  return strongest_;
}

std::optional<HostileBus::Plugged> HostileBus::plugged() {
  const std::lock_guard lock(mutex_);
  return plugged_;
}

// A reader that asks with a report in hand already has not shown that one yet.
int HostileBus::read(std::span<std::uint8_t> into, int timeout_ms) {
  std::unique_lock lock(mutex_);
  if (timeout_ms == 0) return plugged_ ? 0 : -1;
  changed_.wait_for(lock, std::chrono::milliseconds(1), [&] { return waiting_ || !plugged_; });
  if (!plugged_) return -1;
  if (!waiting_) return 0;
  const std::size_t count = copy(*waiting_, into);
  waiting_.reset();
  changed_.notify_all();
  return static_cast<int>(count);
}

int HostileBus::write(std::span<const std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  if (!plugged_) return -1;
  strongest_ = std::max(strongest_, force_in(report));
  return static_cast<int>(report.size());
}

int HostileBus::feature(std::span<std::uint8_t> into) {
  const std::lock_guard lock(mutex_);
  if (!plugged_ || plugged_->features.empty()) return -1;
  return static_cast<int>(copy(plugged_->features, into));
}

}  // namespace palpate::fuzz

using palpate::fuzz::HostileBus;

// There is one device, so a handle need only not be null.
struct hid_device_ {};

hid_device_info* hid_enumerate(unsigned short, unsigned short) {
  const std::optional<HostileBus::Plugged> plugged = HostileBus::the().plugged();
  if (!plugged) return nullptr;
  static char path[] = "/dev/null";  // may be read and written
  static wchar_t product[] = L"Hostile";
  auto* const info = new hid_device_info{};
  info->path = path;
  info->product_string = product;
  info->vendor_id = plugged->vendor;
  info->product_id = plugged->product;
  info->usage_page = plugged->usage_page;
  info->usage = plugged->usage;
  return info;
}

void hid_free_enumeration(hid_device_info* devices) {
  delete devices;
}

hid_device* hid_open_path(const char*) {
  return HostileBus::the().plugged() ? new hid_device_ : nullptr;
}

void hid_close(hid_device* device) {
  delete device;
}

int hid_read_timeout(hid_device*, unsigned char* data, std::size_t length, int milliseconds) {
  return HostileBus::the().read({data, length}, milliseconds);
}

int hid_write(hid_device*, const unsigned char* data, std::size_t length) {
  return HostileBus::the().write({data, length});
}

int hid_send_feature_report(hid_device*, const unsigned char*, std::size_t length) {
  return HostileBus::the().plugged() ? static_cast<int>(length) : -1;
}

int hid_get_feature_report(hid_device*, unsigned char* data, std::size_t length) {
  return HostileBus::the().feature({data, length});
}
