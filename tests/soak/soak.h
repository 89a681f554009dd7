#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace palpate::test {

// Two models of the catalogue; the second slides over the first.
struct SoakPair {
  const char* scene;
  const char* tool;
  double tool_scale = 1.0;
};

struct SoakOptions {
  std::vector<SoakPair> pairs;  // in every mode and by every law
  double seconds = 3600.0;
  unsigned threads = 2;
  int poses = 500;  // of a way, which is gone to and fro
  std::uint64_t seed = 1;
};

struct SoakProgress {
  double seconds = 0.0;
  std::uint64_t ticks = 0;
  std::int64_t resident_bytes = 0;
};

struct SoakOutcome {
  SoakProgress warm;  // once every scene has gone its way twice
  SoakProgress end;
  std::int64_t most_resident_bytes = 0;
  std::uint64_t touching_ticks = 0;
  std::vector<std::string> wrong;  // what differs from a scene that was made afresh
};

// Steps scenes for as long as it is told, and then asks each for what a fresh one would say at the same
// place. `report` is called every ten seconds, and at the end.
SoakOutcome soak(const SoakOptions& options, const std::function<void(const SoakProgress&)>& report);

}  // namespace palpate::test
