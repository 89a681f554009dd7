#include "samples/viewer/picture.h"

#include "samples/viewer/contact_glyphs.h"

namespace palpate::viewer {
namespace {

constexpr glm::vec3 kSceneColour{0.60f, 0.65f, 0.70f};
constexpr glm::vec3 kToolColour{0.95f, 0.62f, 0.22f};
constexpr glm::vec3 kGhostColour{0.55f, 0.78f, 1.0f};
constexpr float kGhostOpacity = 0.22f;

// A ghost that lies in the tool is only noise.
bool apart(const Placement& a, const Placement& b, double size) {
  const Quat turn = glm::conjugate(a.orientation) * b.orientation;
  const double angle = 2.0 * glm::length(Vec3(turn.x, turn.y, turn.z));
  return glm::length(a.position - b.position) + angle * size > 0.004 * size;
}

}  // namespace

const char* const Picture::kBackgroundVertex = R"(#version 330 core
out float height;
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  height = corner.y;
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
})";

const char* const Picture::kBackgroundFragment = R"(#version 330 core
in float height;
out vec4 shown;
void main() {
  shown = vec4(mix(vec3(0.16, 0.18, 0.21), vec3(0.07, 0.08, 0.10), height), 1.0);
})";

void Picture::show(const Content& content) {
  scene_ = content.scene ? std::make_unique<MeshView>(*content.scene) : nullptr;
  tool_ = content.tool ? std::make_unique<MeshView>(*content.tool) : nullptr;
}

void Picture::draw(const Content& content, const Camera& camera, const FrameState* state, int width,
                   int height, GLuint framebuffer) {
  const double aspect = static_cast<double>(width) / height;
  canvas_.begin(width, height);
  glDisable(GL_SCISSOR_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  draw_background();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw_models(content, camera, state, aspect);
  if (state && content.complete()) {
    Glyphs contacts(camera.target()), arrows(camera.target());
    add_contacts(*state, content, camera.pixel(height), contacts);
    add_wrench(*state, content, camera.pixel(height), arrows);
    glyph_shader_.draw(contacts, camera, aspect);
    draw_ghost(content, camera, *state, aspect);
    // Nothing hides what is felt.
    glClear(GL_DEPTH_BUFFER_BIT);
    glyph_shader_.draw(arrows, camera, aspect);
  }
  canvas_.finish(framebuffer);
}

void Picture::draw_models(const Content& content, const Camera& camera, const FrameState* state,
                          double aspect) const {
  const Vec3& target = camera.target();
  const Placement tool = state ? state->tool : content.place.start;
  mesh_shader_.begin(camera, aspect);
  if (scene_) mesh_shader_.draw(*scene_, {}, target, kSceneColour, 1.0f);
  if (tool_) mesh_shader_.draw(*tool_, tool, target, kToolColour, 1.0f);
}

void Picture::draw_ghost(const Content& content, const Camera& camera, const FrameState& state,
                         double aspect) const {
  if (!state.wanted || !apart(state.tool, *state.wanted, content.tool->diagonal())) return;
  const Vec3& target = camera.target();
  mesh_shader_.begin(camera, aspect);
  // Only the nearest surface of the ghost: first its depth alone.
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  mesh_shader_.draw(*tool_, *state.wanted, target, kGhostColour, kGhostOpacity);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  mesh_shader_.draw(*tool_, *state.wanted, target, kGhostColour, kGhostOpacity);
  glDepthFunc(GL_LESS);
}

void Picture::draw_background() const {
  GLuint layout = 0;
  glGenVertexArrays(1, &layout);
  glBindVertexArray(layout);
  glDisable(GL_DEPTH_TEST);
  background_shader_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDeleteVertexArrays(1, &layout);
}

}  // namespace palpate::viewer
