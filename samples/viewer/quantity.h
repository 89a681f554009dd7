#pragma once

#include <span>

#include "samples/cli/tick.h"

namespace palpate::viewer {

// One number of a tick, as it is plotted.
struct Quantity {
  const char* name;
  const char* unit;
  double (*of)(const cli::Tick& tick);
};

// Those that the figures 5 to 8 of [JW04] plot, in that order, and then the rest.
std::span<const Quantity> quantities();
inline constexpr std::size_t kPaperQuantities = 4;

}  // namespace palpate::viewer
