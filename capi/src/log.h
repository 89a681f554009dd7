#pragma once

#include <string>

#include "engine/base/log.h"

namespace palpate::capi {

// Logs; a message that cannot be delivered is dropped, so that a call never fails for it.
inline void log_quietly(LogLevel level, const std::string& message) noexcept {
  try {
    log(level, message);
  } catch (...) {
    return;
  }
}

}  // namespace palpate::capi
