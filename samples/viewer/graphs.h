#pragma once

#include <string>
#include <vector>

#include "samples/cli/tick.h"

namespace palpate::viewer {

// Draws the figures 5 to 8 of [JW04] of a run as one SVG file. Throws cli::Failure.
void write_graphs(const std::string& path, const std::string& title, const std::vector<cli::Tick>& ticks);

}  // namespace palpate::viewer
