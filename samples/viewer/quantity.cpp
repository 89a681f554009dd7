#include "samples/viewer/quantity.h"

#include "samples/viewer/geometry.h"

namespace palpate::viewer {
namespace {

constexpr Quantity kQuantities[] = {
    {"local update", "us", [](const cli::Tick& tick) { return tick.local_us; }},
    {"triangle pairs", "",
     [](const cli::Tick& tick) { return static_cast<double>(tick.work.triangle_pairs); }},
    {"global search", "us", [](const cli::Tick& tick) { return tick.work.global_us; }},
    {"force", "N", [](const cli::Tick& tick) { return glm::length(vector_of(tick.wrench.force)); }},
    {"torque", "mN m",
     [](const cli::Tick& tick) { return 1e3 * glm::length(vector_of(tick.wrench.torque)); }},
    {"local minimum distances", "", [](const cli::Tick& tick) { return static_cast<double>(tick.lmds); }},
};

}  // namespace

std::span<const Quantity> quantities() {
  return kQuantities;
}

}  // namespace palpate::viewer
