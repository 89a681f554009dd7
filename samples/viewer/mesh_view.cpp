#include "samples/viewer/mesh_view.h"

#include <cstddef>

namespace palpate::viewer {
namespace {

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_target;
uniform mat4 target_from_model;
out vec3 place;
out vec3 facing;
void main() {
  vec4 at = target_from_model * vec4(position, 1.0);
  place = at.xyz;
  facing = mat3(target_from_model) * normal;
  gl_Position = clip_from_target * at;
})";

constexpr const char* kFragment = R"(#version 330 core
in vec3 place;
in vec3 facing;
uniform vec3 eye;
uniform vec3 key;
uniform vec3 sky;
uniform vec3 colour;
uniform float opacity;
out vec4 shown;
void main() {
  vec3 to_eye = normalize(eye - place);
  vec3 n = normalize(facing);
  if (dot(n, to_eye) < 0.0) n = -n;
  float light = max(dot(n, key), 0.0);
  float fill = max(dot(n, normalize(sky - key)), 0.0);
  float hemisphere = 0.5 + 0.5 * dot(n, sky);
  float gleam = pow(max(dot(n, normalize(key + to_eye)), 0.0), 48.0);
  float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 3.0);
  vec3 lit = colour * (mix(vec3(0.20, 0.19, 0.22), vec3(0.36, 0.39, 0.44), hemisphere) + 0.62 * light +
                       0.12 * fill) + vec3(0.22) * gleam + vec3(0.10, 0.12, 0.15) * rim;
  shown = vec4(lit, opacity * mix(0.45, 1.0, opacity + rim));
})";

}  // namespace

MeshView::MeshView(const ModelFile& file)
    : centre_(file.centre()), count_(static_cast<GLsizei>(file.triangles.size())) {
  glGenVertexArrays(1, &layout_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
  glBindVertexArray(layout_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  const auto bytes = static_cast<GLsizeiptr>(file.corners.size() * sizeof(Corner));
  glBufferData(GL_ARRAY_BUFFER, bytes, file.corners.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                        reinterpret_cast<const void*>(offsetof(Corner, normal)));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  const auto index_bytes = static_cast<GLsizeiptr>(file.triangles.size() * sizeof(file.triangles[0]));
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, index_bytes, file.triangles.data(), GL_STATIC_DRAW);
}

MeshView::~MeshView() {
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &indices_);
  glDeleteVertexArrays(1, &layout_);
}

void MeshView::draw() const {
  glBindVertexArray(layout_);
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

MeshShader::MeshShader() : shader_(kVertex, kFragment) {}

void MeshShader::begin(const Camera& camera, double aspect) const {
  const Vec3 key = camera.towards() + 1.1 * camera.above() - 0.7 * camera.right();
  shader_.use();
  shader_.set("clip_from_target", camera.clip_from_target(aspect));
  shader_.set("eye", camera.eye());
  shader_.set("key", glm::vec3(glm::normalize(key)));
  shader_.set("sky", glm::vec3(camera.above()));
}

void MeshShader::draw(const MeshView& mesh, const Placement& placement, const Vec3& target,
                      const glm::vec3& colour, float opacity) const {
  const Placement centred = placement * Placement{mesh.centre()};
  shader_.set("target_from_model", matrix_of(centred, target));
  shader_.set("colour", colour);
  shader_.set("opacity", opacity);
  mesh.draw();
}

}  // namespace palpate::viewer
