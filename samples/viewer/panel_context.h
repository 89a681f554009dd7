#pragma once

namespace palpate::viewer {

// Dear ImGui with OpenGL 3 behind it, a legible font and calm colours. Needs a current OpenGL context.
class PanelContext {
 public:
  PanelContext();
  ~PanelContext();
  PanelContext(const PanelContext&) = delete;
  PanelContext& operator=(const PanelContext&) = delete;
};

}  // namespace palpate::viewer
