#include "samples/viewer/glyphs.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace palpate::viewer {
namespace {

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec3 unit;  // x and y across, z from 0 to 1 along the axis
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
layout(location = 3) in vec2 radii;
layout(location = 4) in vec4 tint;
uniform mat4 clip_from_target;
out vec3 place;
out vec4 colour;
void main() {
  vec3 axis = to - from;
  vec3 w = normalize(axis);
  vec3 u = normalize(cross(w, abs(w.x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 1, 0)));
  vec3 v = cross(w, u);
  place = from + unit.z * axis + mix(radii.x, radii.y, unit.z) * (unit.x * u + unit.y * v);
  colour = tint;
  gl_Position = clip_from_target * vec4(place, 1.0);
})";

// Mostly its own colour, so that what a line says by it can be read from every side.
constexpr const char* kFragment = R"(#version 330 core
in vec3 place;
in vec4 colour;
uniform vec3 eye;
uniform float opacity;
out vec4 shown;
void main() {
  vec3 n = normalize(cross(dFdx(place), dFdy(place)));
  float facing = abs(dot(n, normalize(eye - place)));
  shown = vec4(colour.rgb * (0.72 + 0.28 * facing), colour.a * opacity);
})";

constexpr int kAround = 14;

// A ring of corners for each point of an outline: how far out, and how far along the axis.
std::vector<glm::vec3> revolved(const std::vector<glm::vec2>& outline) {
  const auto corner = [&](const glm::vec2& point, int i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
    return glm::vec3(point.x * std::cos(angle), point.x * std::sin(angle), point.y);
  };
  std::vector<glm::vec3> triangles;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
    for (int i = 0; i < kAround; ++i) {
      const glm::vec3 a = corner(outline[k], i), b = corner(outline[k], i + 1);
      const glm::vec3 c = corner(outline[k + 1], i), d = corner(outline[k + 1], i + 1);
      triangles.insert(triangles.end(), {a, b, d, a, d, c});
    }
  }
  return triangles;
}

std::vector<glm::vec2> ball_outline() {
  constexpr int kSteps = 8;
  std::vector<glm::vec2> outline;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / kSteps;
    outline.emplace_back(std::sin(angle), 0.5f - 0.5f * std::cos(angle));
  }
  return outline;
}

void instance_attribute(GLuint index, GLint numbers, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, numbers, GL_FLOAT, GL_FALSE, sizeof(Rod),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(index, 1);
}

}  // namespace

void Glyphs::rod(const Vec3& from, const Vec3& to, double radius, const Colour& colour) {
  rods_.push_back(
      {glm::vec3(from - target_), glm::vec3(to - target_), glm::vec2(static_cast<float>(radius)), colour});
}

void Glyphs::ball(const Vec3& centre, double radius, const Colour& colour) {
  const Vec3 up(0.0, 0.0, radius);
  balls_.push_back({glm::vec3(centre - up - target_), glm::vec3(centre + up - target_),
                    glm::vec2(static_cast<float>(radius)), colour});
}

void Glyphs::arrow(const Vec3& from, const Vec3& to, double radius, const Colour& colour) {
  const double length = glm::length(to - from);
  if (!(length > 0.0)) return;
  const double head = std::min(6.0 * radius, 0.5 * length);
  const Vec3 neck = to - head / length * (to - from);
  rod(from, neck, radius, colour);
  cone(neck, to, 2.6 * radius, colour);
}

void Glyphs::turn(const Vec3& centre, const Vec3& axis, double ring, double angle, double radius,
                  const Colour& colour) {
  constexpr int kPieces = 24;
  const Vec3 w = glm::normalize(axis);
  const Vec3 u = glm::normalize(glm::cross(w, std::abs(w.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  const Vec3 v = glm::cross(w, u);
  const auto point = [&](double at) { return centre + ring * (std::cos(at) * u + std::sin(at) * v); };
  const double head = std::min(6.0 * radius / ring, 0.5 * angle);
  for (int i = 0; i < kPieces; ++i) {
    const double share = (angle - head) / kPieces;
    rod(point(share * i), point(share * (i + 1)), radius, colour);
  }
  cone(point(angle - head), point(angle), 2.6 * radius, colour);
}

void Glyphs::cone(const Vec3& from, const Vec3& to, double radius, const Colour& colour) {
  rods_.push_back({glm::vec3(from - target_), glm::vec3(to - target_), glm::vec2(radius, 0.0), colour});
}

GlyphShader::GlyphShader() : shader_(kVertex, kFragment) {
  glGenBuffers(1, &instances_);
  rod_ = form_of({{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}});
  ball_ = form_of(ball_outline());
}

GlyphShader::~GlyphShader() {
  for (const Form& form : {rod_, ball_}) {
    glDeleteBuffers(1, &form.vertices);
    glDeleteVertexArrays(1, &form.layout);
  }
  glDeleteBuffers(1, &instances_);
}

GlyphShader::Form GlyphShader::form_of(const std::vector<glm::vec2>& outline) const {
  const std::vector<glm::vec3> triangles = revolved(outline);
  Form form{0, 0, static_cast<GLsizei>(triangles.size())};
  glGenVertexArrays(1, &form.layout);
  glGenBuffers(1, &form.vertices);
  glBindVertexArray(form.layout);
  glBindBuffer(GL_ARRAY_BUFFER, form.vertices);
  const auto bytes = static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec3));
  glBufferData(GL_ARRAY_BUFFER, bytes, triangles.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  instance_attribute(1, 3, offsetof(Rod, from));
  instance_attribute(2, 3, offsetof(Rod, to));
  instance_attribute(3, 2, offsetof(Rod, radii));
  instance_attribute(4, 4, offsetof(Rod, colour));
  return form;
}

void GlyphShader::draw(const Glyphs& glyphs, const Camera& camera, double aspect) const {
  constexpr float kHidden = 0.35f;
  shader_.use();
  shader_.set("clip_from_target", camera.clip_from_target(aspect));
  shader_.set("eye", camera.eye());
  shader_.set("opacity", kHidden);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_FALSE);
  draw(rod_, glyphs.rods());
  draw(ball_, glyphs.balls());
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  shader_.set("opacity", 1.0f);
  draw(rod_, glyphs.rods());
  draw(ball_, glyphs.balls());
}

void GlyphShader::draw(const Form& form, const std::vector<Rod>& rods) const {
  if (rods.empty()) return;
  glBindVertexArray(form.layout);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(rods.size() * sizeof(Rod)), rods.data(),
               GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLES, 0, form.count, static_cast<GLsizei>(rods.size()));
}

}  // namespace palpate::viewer
