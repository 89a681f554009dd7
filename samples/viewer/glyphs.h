#pragma once

#include <vector>

#include "samples/viewer/camera.h"
#include "samples/viewer/shader.h"

namespace palpate::viewer {

using Colour = glm::vec4;

// One instance of a round shape as the shader takes it: along an axis, about the camera's target.
struct Rod {
  glm::vec3 from;
  glm::vec3 to;
  glm::vec2 radii;  // at both ends
  Colour colour;
};

// Rods, balls and arrows to be drawn; all in the scene's frame, metres.
class Glyphs {
 public:
  explicit Glyphs(const Vec3& target) : target_(target) {}

  void rod(const Vec3& from, const Vec3& to, double radius, const Colour& colour);
  void ball(const Vec3& centre, double radius, const Colour& colour);
  void arrow(const Vec3& from, const Vec3& to, double radius, const Colour& colour);
  // Around an axis through `centre`, counter-clockwise seen against it, an arrow of `angle` rad.
  void turn(const Vec3& centre, const Vec3& axis, double ring, double angle, double radius,
            const Colour& colour);

  const std::vector<Rod>& rods() const { return rods_; }
  const std::vector<Rod>& balls() const { return balls_; }

 private:
  void cone(const Vec3& from, const Vec3& to, double radius, const Colour& colour);

  Vec3 target_;
  std::vector<Rod> rods_;
  std::vector<Rod> balls_;
};

// Draws glyphs, and faintly where a surface hides them.
class GlyphShader {
 public:
  GlyphShader();
  ~GlyphShader();
  GlyphShader(const GlyphShader&) = delete;
  GlyphShader& operator=(const GlyphShader&) = delete;

  void draw(const Glyphs& glyphs, const Camera& camera, double aspect) const;

 private:
  // A surface of revolution in the memory of the graphics processor, and the layout of its instances.
  struct Form {
    GLuint layout;
    GLuint vertices;
    GLsizei count;
  };
  Form form_of(const std::vector<glm::vec2>& outline) const;
  void draw(const Form& form, const std::vector<Rod>& rods) const;

  Shader shader_;
  GLuint instances_ = 0;
  Form rod_{};
  Form ball_{};
};

}  // namespace palpate::viewer
