#include "tests/bench/machine.h"

#include <hwy/targets.h>
#include <fstream>

namespace palpate::bench {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

std::string simd_name() {
  const auto usable = hwy::SupportedTargets() & HWY_TARGETS;
  return hwy::TargetName(usable & -usable);  // better instruction sets have lower bits
}

}  // namespace

Machine this_machine() {
  return {processor_name(), PALPATE_BENCH_COMPILER, PALPATE_BENCH_FLAGS, simd_name()};
}

}  // namespace palpate::bench
