#include "engine/device/simulated/simulated_backend.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "engine/device/simulated/simulated_phantom.h"

namespace palpate {
namespace {

// What stands behind "?delay=", or 0 without parameters.
Result<int> delay_of(std::string_view parameters) {
  constexpr std::string_view kDelay = "delay=";
  if (parameters.empty()) return 0;
  int delay = -1;
  if (parameters.substr(0, kDelay.size()) == kDelay) {
    const char* const end = parameters.data() + parameters.size();
    const auto read = std::from_chars(parameters.data() + kDelay.size(), end, delay);
    if (read.ec != std::errc() || read.ptr != end) delay = -1;
  }
  if (delay >= 0 && delay <= SampleDelay::kLongest) return delay;
  return Error{ErrorCode::kInvalidArgument,
               "a simulated device has no parameter \"" + std::string(parameters) +
                   "\"; there is delay=0 to delay=" + std::to_string(SampleDelay::kLongest)};
}

}  // namespace

std::vector<DeviceInfo> SimulatedBackend::enumerate() const {
  std::vector<DeviceInfo> found;
  for (const PhantomSpec& spec : phantom_specs()) found.push_back(info_of(spec));
  return found;
}

Result<std::unique_ptr<Device>> SimulatedBackend::open(std::string_view name) const {
  const std::size_t question = name.find('?');
  const std::string_view model = name.substr(0, question);
  for (const PhantomSpec& spec : phantom_specs()) {
    if (spec.uri_name != model) continue;
    const Result<int> delay = delay_of(name.substr(std::min(question, name.size() - 1) + 1));
    if (!delay) return delay.error();
    return std::unique_ptr<Device>(std::make_unique<SimulatedPhantom>(spec, delay.value()));
  }
  return std::unique_ptr<Device>();
}

}  // namespace palpate
