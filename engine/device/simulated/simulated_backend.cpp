#include "engine/device/simulated/simulated_backend.h"

#include <string>

#include "engine/device/simulated/simulated_phantom.h"

namespace palpate {

std::vector<DeviceIdentity> SimulatedBackend::enumerate() const {
  std::vector<DeviceIdentity> found;
  for (const PhantomSpec& spec : phantom_specs()) found.push_back(info_of(spec).identity);
  return found;
}

Result<std::unique_ptr<Device>> SimulatedBackend::open(std::string_view name) const {
  for (const PhantomSpec& spec : phantom_specs()) {
    if (spec.uri_name == name) return std::unique_ptr<Device>(std::make_unique<SimulatedPhantom>(spec));
  }
  return std::unique_ptr<Device>();
}

}  // namespace palpate
