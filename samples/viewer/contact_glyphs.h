#pragma once

#include "samples/viewer/content.h"
#include "samples/viewer/frame_state.h"
#include "samples/viewer/glyphs.h"

namespace palpate::viewer {

// LMDs as lines coloured by distance, with their points and normals. `pixel` is how large one is at the
// camera's target, metres.
void add_contacts(const FrameState& state, const Content& content, double pixel, Glyphs& glyphs);

// The force on the tool as an arrow from its middle, and its torque as one around that.
void add_wrench(const FrameState& state, const Content& content, double pixel, Glyphs& glyphs);

// From red, at no distance, over yellow to green at the cutoff.
Colour colour_of_distance(double share);

inline constexpr Colour kForceColour{0.16f, 0.66f, 1.0f, 1.0f};
inline constexpr Colour kTorqueColour{0.80f, 0.42f, 1.0f, 1.0f};

}  // namespace palpate::viewer
