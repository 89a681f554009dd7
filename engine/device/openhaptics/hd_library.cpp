#include "engine/device/openhaptics/hd_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/device/openhaptics/hd_scheduler.h"

namespace palpate {
namespace {

constexpr const char* kVariable = "PALPATE_OPENHAPTICS_LIBRARY";

const pid_t first_process = getpid();

// In the order in which they are tried.
constexpr const char* kNames[] = {"libHD.so.3.4", "libHD.so.3.4.0", "libHD.so", "libHD.so.3.0"};

std::vector<std::string> candidates(std::string_view path) {
  if (!path.empty()) return {std::string(path)};
  const char* const named = std::getenv(kVariable);
  if (named && *named) return {named};
  return {std::begin(kNames), std::end(kNames)};
}

HdLibrary not_found(const std::string& complaints) {
  return {
      nullptr, DeviceCondition::kNoLibrary,
      "libHD.so not found: install OpenHaptics 3.4 and the driver of the device, or name the library in " +
          std::string(kVariable) + " (" + complaints + ")"};
}

HdLibrary without(const std::string& name, const char* function) {
  return {nullptr, DeviceCondition::kWrongLibrary,
          name + " has no function " + function + ": install OpenHaptics 3.4"};
}

// The name of the first function that a library lacks; null if it has all.
const char* missing_function(void* library, hd::Functions& functions) {
#define PALPATE_HD_FIND(result, name, arguments)                                 \
  functions.name = reinterpret_cast<result(*) arguments>(dlsym(library, #name)); \
  if (!functions.name) return #name;
  using hd::Boolean, hd::Callback, hd::Enum, hd::ErrorCode, hd::ErrorInfo, hd::Handle, hd::Schedule;
  PALPATE_HD_FUNCTIONS(PALPATE_HD_FIND)
#undef PALPATE_HD_FIND
  return nullptr;
}

// By the library's own handle: two names may lead to one library, which has one scheduler. Never destroyed: a
// callback may run until the process ends.
std::map<void*, std::unique_ptr<HdScheduler>>& schedulers() {
  static auto* const instance = new std::map<void*, std::unique_ptr<HdScheduler>>;
  return *instance;
}

// A process that was forked off has none of the threads that it would wait for.
void end_with_process() {
  if (getpid() != first_process) return;
  for (const auto& [library, scheduler] : schedulers())
    if (scheduler) scheduler->end_with_process();
}

HdLibrary with_functions(void* library, const std::string& name) {
  std::unique_ptr<HdScheduler>& scheduler = schedulers()[library];
  if (!scheduler) {
    hd::Functions functions;
    if (const char* const missing = missing_function(library, functions)) return without(name, missing);
    scheduler = std::make_unique<HdScheduler>(functions);
    // After the library was opened, so that it is called before the library's own end.
    if (schedulers().size() == 1) std::atexit(end_with_process);
  }
  return {scheduler.get(), DeviceCondition::kReady, ""};
}

}  // namespace

HdLibrary HdLibrary::open(std::string_view path) {
  static auto* const mutex = new std::mutex;
  const std::lock_guard lock(*mutex);
  std::string complaints;
  for (const std::string& name : candidates(path)) {
    if (void* const library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL))
      return with_functions(library, name);
    complaints += (complaints.empty() ? "" : "; ") + std::string(dlerror());
  }
  return not_found(complaints);
}

}  // namespace palpate
