#pragma once

#include "samples/viewer/camera.h"
#include "samples/viewer/model_file.h"
#include "samples/viewer/shader.h"

namespace palpate::viewer {

// The triangles of a model in the memory of the graphics processor.
class MeshView {
 public:
  explicit MeshView(const ModelFile& file);
  ~MeshView();
  MeshView(const MeshView&) = delete;
  MeshView& operator=(const MeshView&) = delete;

  const Vec3& centre() const { return centre_; }
  void draw() const;

 private:
  Vec3 centre_;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLuint layout_ = 0;
  GLsizei count_;
};

// How surfaces are lit: a key light from above the viewer's shoulder, sky and ground, and a gleam.
class MeshShader {
 public:
  MeshShader();

  void begin(const Camera& camera, double aspect) const;
  void draw(const MeshView& mesh, const Placement& placement, const Vec3& target, const glm::vec3& colour,
            float opacity) const;

 private:
  Shader shader_;
};

}  // namespace palpate::viewer
