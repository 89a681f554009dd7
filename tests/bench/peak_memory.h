#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

namespace palpate::bench {

// Forgets how much memory the process has held.
inline void reset_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

// The most resident bytes of the process since then.
inline double peak_memory() {
  const std::string key = "VmHWM:";
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return 1024.0 * std::atof(line.c_str() + key.size());
  return 0.0;
}

}  // namespace palpate::bench
