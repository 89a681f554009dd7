#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tests/bench/method.h"
#include "tests/bench/series.h"

namespace palpate::bench {

using Methods = std::vector<std::unique_ptr<Method>>;

// What one method did at one pose.
struct Sample {
  double us;         // elapsed; of the processor if the system gave the core to another in the meantime
  bool interrupted;  // that it did
  Outcome outcome;
};

// One method over all poses; none where it was not asked.
using Run = std::vector<std::optional<Sample>>;

Series time_us(const Run& run);
Series servo_us(const Run& run);    // without what another thread would do
Series per_lmd_us(const Run& run);  // of a descent, for each LMD that it followed
Series lmds(const Run& run);
Series node_pairs(const Run& run);      // of the engine's methods
Series triangle_pairs(const Run& run);  // the same
Series interruptions(const Run& run);

// One motion. Takes the methods by turns, a few poses each, so that a change of the machine's pace meets all
// alike, while each still works with warm caches most of the time, as a servo thread on its own core does.
std::vector<Run> run_by_turns(const Methods& methods, std::span<const Pose> poses);

}  // namespace palpate::bench
