#include "engine/base/log.h"

#include <mutex>

#include "palpate/palpate.h"

namespace palpate::capi {
namespace {

struct Receiver {
  plp_log_callback callback = nullptr;
  void* user = nullptr;
};

// Hands one message over. An exception of a callback ends here: it has no business in the caller of this
// library.
void deliver(LogLevel level, const char* message, void* user) {
  const auto& to = *static_cast<const Receiver*>(user);
  try {
    to.callback(static_cast<plp_log_level>(level), message, to.user);
  } catch (...) {
    return;
  }
}

// Two places, because the old receiver may be in use until the new one is installed.
class ReceiverSwitch {
 public:
  void install(const Receiver& receiver) {
    const std::lock_guard lock(mutex_);
    current_ = 1 - current_;
    receivers_[current_] = receiver;
    set_log_sink(receiver.callback ? deliver : nullptr, &receivers_[current_]);
  }

 private:
  std::mutex mutex_;
  Receiver receivers_[2];
  int current_ = 0;
};

static_assert(static_cast<int>(LogLevel::kError) == PLP_LOG_ERROR);
static_assert(static_cast<int>(LogLevel::kWarning) == PLP_LOG_WARNING);
static_assert(static_cast<int>(LogLevel::kInfo) == PLP_LOG_INFO);
static_assert(static_cast<int>(LogLevel::kDebug) == PLP_LOG_DEBUG);

}  // namespace
}  // namespace palpate::capi

void plp_set_log_callback(plp_log_callback callback, void* user) {
  static palpate::capi::ReceiverSwitch receivers;
  receivers.install({callback, user});
}
