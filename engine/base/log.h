#pragma once

#include <string_view>

namespace palpate {

enum class LogLevel { kError, kWarning, kInfo, kDebug };

using LogSink = void (*)(LogLevel level, const char* message, void* user);

// Installs the one receiver of log messages, or none. Safe from any thread; the old sink is not called after
// the return.
void set_log_sink(LogSink sink, void* user);

// Never called on the servo path: it locks.
void log(LogLevel level, std::string_view message);

}  // namespace palpate
