#include "tests/fuzz/hostile_bus.h"

#include <hidapi.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <new>

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
  ++number_;
  strongest_ = 0.0;
  changed_.notify_all();
}

void HostileBus::unplug() {
  const std::lock_guard lock(mutex_);
  plugged_.reset();
  changed_.notify_all();
}

void HostileBus::report(Report report) {
  std::unique_lock lock(mutex_);
  if (!plugged_) return;
  waiting_ = std::move(report);
  changed_.notify_all();
  changed_.wait_for(lock, kReadersTurn, [&] { return !waiting_; });
}

bool HostileBus::is_heard() {
  const std::lock_guard lock(mutex_);
  return !waiting_;
}

double HostileBus::strongest() {
  const std::lock_guard lock(mutex_);
  return strongest_;
}

std::optional<HostileBus::Found> HostileBus::find() {
  const std::lock_guard lock(mutex_);
  if (!plugged_) return std::nullopt;
  return Found{plugged_->identity, number_};
}

// A reader that asks with a report in hand already has not shown that one yet.
int HostileBus::read(std::uint64_t number, std::span<std::uint8_t> into, int timeout_ms) {
  std::unique_lock lock(mutex_);
  if (timeout_ms == 0) return is_there(number) ? 0 : -1;
  changed_.wait_for(lock, std::chrono::milliseconds(1), [&] { return waiting_ || !is_there(number); });
  if (!is_there(number)) return -1;
  if (!waiting_) return 0;
  const std::size_t count = copy(*waiting_, into);
  waiting_.reset();
  changed_.notify_all();
  return static_cast<int>(count);
}

int HostileBus::write(std::uint64_t number, std::span<const std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  if (!is_there(number)) return -1;
  strongest_ = std::max(strongest_, force_in(report));
  return static_cast<int>(report.size());
}

int HostileBus::feature(std::uint64_t number, std::span<std::uint8_t> into) {
  const std::lock_guard lock(mutex_);
  if (!is_there(number) || plugged_->features.empty()) return -1;
  return static_cast<int>(copy(plugged_->features, into));
}

}  // namespace palpate::fuzz

using palpate::fuzz::HostileBus;

struct hid_device_ {
  std::uint64_t number;
};

namespace {

// As hidapi does it: without memory there is none, and errno tells why.
template <class Made>
Made* made() {
  auto* const memory = new (std::nothrow) Made{};
  if (!memory) errno = ENOMEM;
  return memory;
}

}  // namespace

hid_device_info* hid_enumerate(unsigned short, unsigned short) {
  const std::optional<HostileBus::Found> found = HostileBus::the().find();
  auto* const info = found ? made<hid_device_info>() : nullptr;
  if (!info) return nullptr;
  static char path[] = "/dev/null";  // may be read and written
  static wchar_t product[] = L"Hostile";
  info->path = path;
  info->product_string = product;
  info->vendor_id = found->identity.vendor;
  info->product_id = found->identity.product;
  info->usage_page = found->identity.usage_page;
  info->usage = found->identity.usage;
  return info;
}

void hid_free_enumeration(hid_device_info* devices) {
  delete devices;
}

hid_device* hid_open_path(const char*) {
  const std::optional<HostileBus::Found> found = HostileBus::the().find();
  auto* const device = found ? made<hid_device>() : nullptr;
  if (device) device->number = found->number;
  return device;
}

void hid_close(hid_device* device) {
  delete device;
}

int hid_read_timeout(hid_device* device, unsigned char* data, std::size_t length, int milliseconds) {
  return HostileBus::the().read(device->number, {data, length}, milliseconds);
}

int hid_write(hid_device* device, const unsigned char* data, std::size_t length) {
  return HostileBus::the().write(device->number, {data, length});
}

int hid_send_feature_report(hid_device* device, const unsigned char*, std::size_t length) {
  const std::optional<HostileBus::Found> found = HostileBus::the().find();
  return found && found->number == device->number ? static_cast<int>(length) : -1;
}

int hid_get_feature_report(hid_device* device, unsigned char* data, std::size_t length) {
  return HostileBus::the().feature(device->number, {data, length});
}
