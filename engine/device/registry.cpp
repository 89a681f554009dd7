#include "engine/device/registry.h"

#include <string>
#include <utility>

#include "engine/device/hid/hid_backend.h"
#include "engine/device/openhaptics/openhaptics_backend.h"
#include "engine/device/simulated/simulated_backend.h"

namespace palpate {
namespace {

template <class Backend>
std::unique_ptr<DeviceBackend> make() {
  return std::make_unique<Backend>();
}

// Every build has these; the first one's first device is the default.
constexpr std::unique_ptr<DeviceBackend> (*kStandard[])() = {
    make<SimulatedBackend>,
    make<OpenHapticsBackend>,
    make<HidBackend>,
};

}  // namespace

DeviceRegistry DeviceRegistry::standard() {
  DeviceRegistry registry;
  for (const auto make_backend : kStandard) registry.add(make_backend());
  return registry;
}

void DeviceRegistry::add(std::unique_ptr<DeviceBackend> backend) {
  backends_.push_back(std::move(backend));
}

std::vector<DeviceInfo> DeviceRegistry::enumerate() const {
  std::vector<DeviceInfo> all;
  for (const auto& backend : backends_) {
    const std::vector<DeviceInfo> found = backend->enumerate();
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

Result<std::unique_ptr<Device>> DeviceRegistry::open(std::string_view uri) const {
  if (uri.empty()) uri = kDefaultDeviceUri;
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos) return unknown(uri);
  const DeviceBackend* backend = find(uri.substr(0, colon));
  if (!backend) return unknown(uri);
  Result<std::unique_ptr<Device>> opened = backend->open(uri.substr(colon + 1));
  if (opened && !opened.value()) return unknown(uri);
  return opened;
}

const DeviceBackend* DeviceRegistry::find(std::string_view scheme) const {
  for (const auto& backend : backends_) {
    if (backend->scheme() == scheme) return backend.get();
  }
  return nullptr;
}

Error DeviceRegistry::unknown(std::string_view uri) const {
  std::string message = "no device \"" + std::string(uri) + "\"; there are";
  const char* separator = " ";
  for (const DeviceInfo& info : enumerate()) {
    if (!is_openable(info.condition)) continue;
    message += separator + info.identity.uri;
    separator = ", ";
  }
  return {ErrorCode::kDevice, message};
}

}  // namespace palpate
