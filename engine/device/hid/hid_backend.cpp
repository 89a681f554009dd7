#include "engine/device/hid/hid_backend.h"

#include <optional>
#include <string>
#include <utility>

#include "engine/device/hid/hid_advice.h"
#include "engine/device/hid/hid_bus.h"
#include "engine/device/hid/ohhp_device.h"
#include "engine/device/hid/space_mouse.h"

namespace palpate {
namespace {

DeviceInfo info_of(const HidEntry& entry) {
  DeviceInfo info;
  info.identity = {"hid:" + entry.name.text(), entry.product, entry.name.serial};
  if (entry.kind == HidKind::kSpaceMouse) info.capabilities.sensed = kAllDegrees;
  info.advice = obstacle_to(entry);
  if (info.advice.empty()) return info;
  info.condition = entry.taken ? DeviceCondition::kCannotOpen : DeviceCondition::kWithheld;
  return info;
}

// Of the kind of the first device with that name; none if there is none.
std::optional<HidEntry> entry_named(const HidName& name) {
  for (HidEntry& entry : hid_bus::entries()) {
    if (name.covers(entry.name) && entry.kind != HidKind::kOther) return std::move(entry);
  }
  return std::nullopt;
}

Result<std::unique_ptr<Device>> device_on(std::shared_ptr<HidConnection> connection) {
  if (connection->entry().kind == HidKind::kOhhp) return OhhpDevice::open(std::move(connection));
  return std::unique_ptr<Device>(std::make_unique<SpaceMouse>(std::move(connection)));
}

}  // namespace

std::vector<DeviceInfo> HidBackend::enumerate() const {
  std::vector<DeviceInfo> found;
  for (const HidEntry& entry : hid_bus::entries()) {
    if (entry.kind != HidKind::kOther) found.push_back(info_of(entry));
  }
  return found;
}

Result<std::unique_ptr<Device>> HidBackend::open(std::string_view text) const {
  const std::optional<HidName> name = HidName::parse(text);
  if (!name) return std::unique_ptr<Device>();
  const std::optional<HidEntry> entry = entry_named(*name);
  if (!entry) return std::unique_ptr<Device>();
  auto connection = hid_bus::connect(*name, entry->kind);
  if (!connection) return connection.error();
  if (!connection.value()) return std::unique_ptr<Device>();
  return device_on(std::move(connection.value()));
}

}  // namespace palpate
