#include "engine/device/hid/hid_bus.h"

#include <hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "engine/device/hid/hid_advice.h"
#include "engine/device/hid/hidapi_memory.h"
#include "engine/device/hid/ohhp.h"

namespace palpate {
namespace {

constexpr std::uint16_t kLogitech = 0x046D;  // sold the first SpaceMice
constexpr std::uint16_t k3Dconnexion = 0x256F;
constexpr std::uint16_t kSensable = 0x2988;  // 3D Systems' Touch

// Usages by the HID usage tables.
constexpr std::uint16_t kGenericDesktop = 0x01;
constexpr std::uint16_t kMultiAxisController = 0x08;

struct Bus {
  std::mutex mutex;  // guards hidapi, but for the handles, and what follows
  std::set<std::string> taken;
};

// Never destroyed: connections may outlast the end of main.
Bus& bus() {
  static auto* const the_bus = new Bus;
  return *the_bus;
}

HidKind kind_of(const hid_device_info& info) {
  if (info.usage_page == ohhp::kUsagePage && info.usage == ohhp::kUsage) return HidKind::kOhhp;
  if (info.vendor_id == kSensable) return HidKind::kVendor;
  const bool multi_axis = info.usage_page == kGenericDesktop && info.usage == kMultiAxisController;
  const bool by_maker = info.vendor_id == kLogitech || info.vendor_id == k3Dconnexion;
  return multi_axis && by_maker ? HidKind::kSpaceMouse : HidKind::kOther;
}

void append_utf8(std::uint32_t letter, std::string& text) {
  if (letter < 0x80) {
    text += static_cast<char>(letter);
  } else if (letter < 0x800) {
    text += static_cast<char>(0xC0 | letter >> 6);
    text += static_cast<char>(0x80 | (letter & 0x3F));
  } else {
    text += '?';  // no name of a device has been seen to need more
  }
}

// Letters that do not print become question marks: names end up in terminals.
std::string text_of(const wchar_t* wide) {
  std::string text;
  for (; wide && *wide; ++wide) append_utf8(*wide < 0x20 || *wide == 0x7F ? '?' : std::uint32_t(*wide), text);
  return text;
}

HidEntry entry_of(const hid_device_info& info, const std::set<std::string>& taken) {
  HidEntry entry;
  entry.name = {info.vendor_id, info.product_id, text_of(info.serial_number)};
  entry.kind = kind_of(info);
  entry.product = text_of(info.product_string);
  entry.path = info.path ? info.path : "";
  entry.permitted = access(entry.path.c_str(), R_OK | W_OK) == 0;
  entry.taken = taken.count(entry.path) > 0;
  return entry;
}

// A node with several top-level collections comes once for each: the most useful counts.
void add(HidEntry entry, std::vector<HidEntry>& entries) {
  const auto same = std::find_if(entries.begin(), entries.end(),
                                 [&](const HidEntry& other) { return other.path == entry.path; });
  if (same == entries.end()) {
    entries.push_back(std::move(entry));
  } else if (entry.kind < same->kind) {
    *same = std::move(entry);
  }
}

std::vector<HidEntry> locked_entries(const std::set<std::string>& taken) {
  std::vector<HidEntry> entries;
  const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> found(
      given_memory([] { return hid_enumerate(0, 0); }), &hid_free_enumeration);
  for (const hid_device_info* info = found.get(); info; info = info->next)
    add(entry_of(*info, taken), entries);
  std::sort(entries.begin(), entries.end(),
            [](const HidEntry& a, const HidEntry& b) { return a.path < b.path; });
  return entries;
}

std::shared_ptr<HidConnection> connected(const HidEntry& entry, std::set<std::string>& taken) {
  auto in = HidHandle::open(entry.path);
  auto out = in ? HidHandle::open(entry.path) : std::nullopt;
  if (!out) return nullptr;
  const auto place = taken.insert(entry.path).first;
  try {
    return std::make_shared<HidConnection>(entry, *std::move(in), *std::move(out));
  } catch (...) {
    taken.erase(place);
    throw;
  }
}

}  // namespace

HidConnection::~HidConnection() {
  hid_bus::give_back(entry_.path);
}

std::vector<HidEntry> hid_bus::entries() {
  const std::lock_guard lock(bus().mutex);
  return locked_entries(bus().taken);
}

Result<std::shared_ptr<HidConnection>> hid_bus::connect(const HidName& name, HidKind kind) {
  const std::lock_guard lock(bus().mutex);
  std::string obstacle;
  for (const HidEntry& entry : locked_entries(bus().taken)) {
    if (entry.kind != kind || !name.covers(entry.name)) continue;
    obstacle = obstacle_to(entry);
    if (!obstacle.empty()) continue;
    if (auto connection = connected(entry, bus().taken)) return connection;
    obstacle = "the system does not open " + entry.path;
  }
  if (obstacle.empty()) return std::shared_ptr<HidConnection>();
  return Error{ErrorCode::kDevice, "hid:" + name.text() + ": " + obstacle};
}

void hid_bus::give_back(const std::string& path) {
  const std::lock_guard lock(bus().mutex);
  bus().taken.erase(path);
}

}  // namespace palpate
