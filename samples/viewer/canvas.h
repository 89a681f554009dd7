#pragma once

#include <epoxy/gl.h>

namespace palpate::viewer {

// What the scene is drawn on, smoothed over several samples a pixel.
class Canvas {
 public:
  Canvas() = default;
  ~Canvas() { release(); }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // Begins a picture of this size.
  void begin(int width, int height);

  // Copies it to a framebuffer of the same size and leaves that bound.
  void finish(GLuint framebuffer) const;

 private:
  void resize(int width, int height);
  void release();

  int width_ = 0;
  int height_ = 0;
  GLuint framebuffer_ = 0;
  GLuint colour_ = 0;
  GLuint depth_ = 0;
};

}  // namespace palpate::viewer
