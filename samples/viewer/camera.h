#pragma once

#include "samples/viewer/geometry.h"

namespace palpate::viewer {

// Looks at a point and goes around it.
class Camera {
 public:
  void look_at(const Vec3& centre, double radius, const Vec3& up);

  void orbit(const glm::dvec2& pixels);
  void pan(const glm::dvec2& pixels, double height);  // of the picture, in pixels
  void zoom(double notches);

  const Vec3& target() const { return target_; }
  double distance() const { return distance_; }
  Vec3 right() const;
  Vec3 above() const;    // of the picture
  Vec3 towards() const;  // the viewer

  // From coordinates about the target to the clip space of a picture of this shape.
  glm::mat4 clip_from_target(double aspect) const;
  glm::vec3 eye() const { return glm::vec3(distance_ * towards()); }  // about the target
  double pixel(double height) const;                                  // metres of one at the target

 private:
  Vec3 target_{0.0};
  Vec3 up_{0.0, 1.0, 0.0};
  double radius_ = 1.0;
  double distance_ = 1.0;
  double around_ = 0.5;  // rad
  double over_ = 0.30;   // rad
};

}  // namespace palpate::viewer
