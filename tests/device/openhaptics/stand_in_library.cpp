#include "tests/device/openhaptics/stand_in_library.h"

#include <dlfcn.h>

#include <cmath>
#include <stdexcept>

namespace palpate::test {
namespace {

const StandInControls& controls() {
  void* const library = dlopen(PALPATE_STAND_IN, RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  return *reinterpret_cast<StandInEntry>(dlsym(library, kStandInEntry))();
}

}  // namespace

StandInLibrary::StandInLibrary(bool real_time) : controls_(controls()) {
  controls_.reset(real_time);
}

double sent_force(const StandInRecord& record) {
  return std::hypot(record.force[0], record.force[1], record.force[2]);
}

}  // namespace palpate::test
