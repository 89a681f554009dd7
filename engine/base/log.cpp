#include "engine/base/log.h"

#include <mutex>
#include <string>

namespace palpate {
namespace {

struct Receiver {
  std::mutex mutex;
  LogSink sink = nullptr;
  void* user = nullptr;
};

Receiver& receiver() {
  static Receiver instance;
  return instance;
}

}  // namespace

void set_log_sink(LogSink sink, void* user) {
  Receiver& to = receiver();
  const std::lock_guard lock(to.mutex);
  to.sink = sink;
  to.user = user;
}

void log(LogLevel level, std::string_view message) {
  Receiver& to = receiver();
  const std::lock_guard lock(to.mutex);
  if (to.sink) to.sink(level, std::string(message).c_str(), to.user);
}

}  // namespace palpate
