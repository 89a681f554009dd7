#pragma once

#include <memory>

#include "samples/viewer/canvas.h"
#include "samples/viewer/content.h"
#include "samples/viewer/frame_state.h"
#include "samples/viewer/glyphs.h"
#include "samples/viewer/mesh_view.h"

namespace palpate::viewer {

// Draws models and what is felt between them.
class Picture {
 public:
  // Takes models up, or what there is of them.
  void show(const Content& content);

  // `state` is null while nothing runs.
  void draw(const Content& content, const Camera& camera, const FrameState* state, int width, int height,
            GLuint framebuffer);

 private:
  void draw_models(const Content& content, const Camera& camera, const FrameState* state,
                   double aspect) const;
  void draw_ghost(const Content& content, const Camera& camera, const FrameState& state, double aspect) const;
  void draw_background() const;

  Canvas canvas_;
  MeshShader mesh_shader_;
  GlyphShader glyph_shader_;
  Shader background_shader_{kBackgroundVertex, kBackgroundFragment};
  std::unique_ptr<MeshView> scene_;
  std::unique_ptr<MeshView> tool_;

  static const char* const kBackgroundVertex;
  static const char* const kBackgroundFragment;
};

}  // namespace palpate::viewer
