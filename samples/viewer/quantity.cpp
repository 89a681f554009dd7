#include "samples/viewer/quantity.h"

#include "samples/viewer/geometry.h"

namespace palpate::viewer {
namespace {

// Without the search from scratch, if one was made within the tick rather than beside it.
double local_update(const cli::Tick& tick) {
  const double rest = tick.local_us - tick.work.global_us;
  return rest > 0.0 ? rest : tick.local_us;
}

constexpr Quantity kQuantities[] = {
    {"local update", "us", local_update},
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
