#include "samples/viewer/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace palpate::viewer {
namespace {

constexpr double kFieldOfView = 0.6;  // rad, of the picture's height

}  // namespace

void Camera::look_at(const Vec3& centre, double radius, const Vec3& up) {
  target_ = centre;
  radius_ = radius;
  up_ = up;
  distance_ = 1.05 * radius / std::sin(0.5 * kFieldOfView);
}

void Camera::orbit(const glm::dvec2& pixels) {
  constexpr double kRadiansAPixel = 0.008;
  constexpr double kSteepest = 1.5;
  around_ -= kRadiansAPixel * pixels.x;
  over_ = std::clamp(over_ + kRadiansAPixel * pixels.y, -kSteepest, kSteepest);
}

void Camera::pan(const glm::dvec2& pixels, double height) {
  target_ += pixel(height) * (-pixels.x * right() + pixels.y * above());
}

void Camera::zoom(double notches) {
  constexpr double kANotch = 0.88;
  distance_ = std::clamp(distance_ * std::pow(kANotch, notches), 0.02 * radius_, 20.0 * radius_);
}

Vec3 Camera::towards() const {
  // Two directions that lie flat: z and x where y is up.
  const Vec3 front = std::abs(up_.z) > 0.5 ? Vec3(0.0, -1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  const Vec3 side = glm::cross(up_, front);
  return std::cos(over_) * (std::cos(around_) * front + std::sin(around_) * side) + std::sin(over_) * up_;
}

Vec3 Camera::right() const {
  return glm::normalize(glm::cross(up_, towards()));
}

Vec3 Camera::above() const {
  return glm::cross(towards(), right());
}

glm::mat4 Camera::clip_from_target(double aspect) const {
  const double near = 0.02 * distance_, far = distance_ + 10.0 * radius_;
  const glm::dmat4 view = glm::lookAt(distance_ * towards(), Vec3(0.0), up_);
  return glm::mat4(glm::perspective(kFieldOfView, aspect, near, far) * view);
}

double Camera::pixel(double height) const {
  return 2.0 * distance_ * std::tan(0.5 * kFieldOfView) / height;
}

}  // namespace palpate::viewer
