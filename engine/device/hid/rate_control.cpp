#include "engine/device/hid/rate_control.h"

#include <algorithm>
#include <cmath>

#include "engine/device/rotation_vector.h"

namespace palpate {

// Zero within the dead zone, and from its border on linear, so that motion begins without a jump.
double RateControl::rate(double deflection) const {
  const double beyond = std::max(std::abs(deflection) - gains_.dead_zone, 0.0) / (1.0 - gains_.dead_zone);
  return std::copysign(std::min(beyond, 1.0), deflection);
}

void RateControl::push(const std::array<double, 6>& deflection) {
  speed_ = gains_.speed * DVec3(rate(deflection[0]), rate(deflection[1]), rate(deflection[2]));
  turn_rate_ = gains_.turn_rate * DVec3(rate(deflection[3]), rate(deflection[4]), rate(deflection[5]));
}

void RateControl::step(double dt) {
  if (!(dt > 0.0)) return;
  const DVec3 next = glm::clamp(motion_.position + dt * speed_, reach_.low, reach_.high);
  motion_.linear_velocity = (next - motion_.position) / dt;
  motion_.position = next;
  motion_.angular_velocity = turn_rate_;
  motion_.orientation = glm::normalize(rotation_by(dt * turn_rate_) * motion_.orientation);
}

}  // namespace palpate
