#include "engine/device/openhaptics/openhaptics_backend.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "engine/device/openhaptics/hd_device.h"
#include "engine/device/openhaptics/hd_library.h"

namespace palpate {
namespace {

constexpr std::string_view kDefaultName = "Default Device";

// The setup program writes one file for each device that it has paired into the folder that its variable
// names.
std::vector<std::string> paired_devices() {
  std::vector<std::string> names;
  const char* const home = std::getenv("GTDD_HOME");
  if (home) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::path(home) / "config";
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error))
      if (file->path().extension() == ".config") names.push_back(file->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  if (names.empty()) names.emplace_back(kDefaultName);
  return names;
}

DeviceInfo listed(const std::string& name, const HdLibrary& library) {
  DeviceInfo info;
  info.identity = {"openhaptics:" + name, "PHANToM through OpenHaptics", ""};
  info.condition = library.condition;
  info.advice = library.scheduler ? "whether it is connected, and what it can do, shows when it is opened"
                                  : library.advice;
  return info;
}

// What stands behind "?library=", or nothing without parameters.
Result<std::string> library_in(std::string_view parameters) {
  constexpr std::string_view kLibrary = "library=";
  if (parameters.empty()) return std::string();
  if (parameters.substr(0, kLibrary.size()) == kLibrary && parameters.size() > kLibrary.size())
    return std::string(parameters.substr(kLibrary.size()));
  return Error{ErrorCode::kInvalidArgument, "a device of OpenHaptics has no parameter \"" +
                                                std::string(parameters) + "\"; there is library=PATH"};
}

}  // namespace

std::vector<DeviceInfo> OpenHapticsBackend::enumerate() const {
  const HdLibrary library = HdLibrary::open({});
  if (!library.scheduler) return {listed(std::string(kDefaultName), library)};
  std::vector<DeviceInfo> found;
  for (const std::string& name : paired_devices()) found.push_back(listed(name, library));
  return found;
}

Result<std::unique_ptr<Device>> OpenHapticsBackend::open(std::string_view name) const {
  const std::size_t question = name.find('?');
  const std::string device(name.substr(0, question));
  const Result<std::string> path = library_in(question == name.npos ? "" : name.substr(question + 1));
  if (!path) return path.error();
  const HdLibrary library = HdLibrary::open(path.value());
  if (!library.scheduler) return Error{ErrorCode::kDevice, library.advice};
  return HdDevice::open(*library.scheduler, device, "openhaptics:" + std::string(name));
}

}  // namespace palpate
