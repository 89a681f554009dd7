#include "samples/viewer/contact_glyphs.h"

#include <algorithm>

namespace palpate::viewer {
namespace {

constexpr Colour kNormalColour{0.93f, 0.95f, 0.98f, 0.8f};

// How long an arrow is for a wrench that the device, or a hand, could hardly hold.
double share_of(double amount, double most) {
  return std::min(1.0, amount / most);
}

void add_lmd(const plp_lmd& lmd, double cutoff, double normal, double pixel, Glyphs& glyphs) {
  const Vec3 a = vector_of(lmd.point_a), b = vector_of(lmd.point_b);
  const Colour colour = colour_of_distance(lmd.distance / cutoff);
  glyphs.rod(a, b, 2.2 * pixel, colour);
  glyphs.ball(a, 4.5 * pixel, colour);
  glyphs.ball(b, 4.5 * pixel, colour);
  glyphs.rod(b, b + normal * vector_of(lmd.normal), 1.1 * pixel, kNormalColour);
}

}  // namespace

Colour colour_of_distance(double share) {
  const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
  return {std::min(1.0f, 2.0f - 2.0f * s), std::min(0.9f, 0.15f + 1.5f * s), 0.15f, 1.0f};
}

void add_contacts(const FrameState& state, const Content& content, double pixel, Glyphs& glyphs) {
  const double size = std::min(content.scene->diagonal(), content.tool->diagonal());
  for (const plp_lmd& lmd : state.lmds) add_lmd(lmd, state.cutoff, 0.08 * size, pixel, glyphs);
}

void add_wrench(const FrameState& state, const Content& content, double pixel, Glyphs& glyphs) {
  constexpr double kMostForce = 8.0;   // N: the arrow is at its longest
  constexpr double kMostTorque = 0.3;  // N·m: the arrow goes round
  constexpr double kWholeTurn = 5.2;   // rad
  const double size = std::min(content.scene->diagonal(), content.tool->diagonal());
  const Vec3 centre = state.tool * content.tool->centre();
  const Vec3 force = vector_of(state.contacts.wrench.force), torque = vector_of(state.contacts.wrench.torque);
  const double newtons = glm::length(force), newton_metres = glm::length(torque);
  if (newtons > 1e-3) {
    const double length = (0.25 + 0.75 * share_of(newtons, kMostForce)) * size;
    glyphs.arrow(centre, centre + length / newtons * force, 3.5 * pixel, kForceColour);
  }
  if (newton_metres > 1e-5) {
    const double angle = (0.15 + 0.85 * share_of(newton_metres, kMostTorque)) * kWholeTurn;
    glyphs.turn(centre, torque, 0.28 * size, angle, 3.0 * pixel, kTorqueColour);
  }
}

}  // namespace palpate::viewer
