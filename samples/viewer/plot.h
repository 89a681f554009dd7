#pragma once

#include "samples/viewer/history.h"
#include "samples/viewer/quantity.h"

namespace palpate::viewer {

// A plot of the last seconds of a quantity, as wide as there is room.
void draw_plot(const Quantity& quantity, const History& history, float height, unsigned colour);

}  // namespace palpate::viewer
