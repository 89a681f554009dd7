#pragma once

#include <epoxy/gl.h>

namespace palpate::viewer {

// What a context without a window draws on.
class HeadlessFramebuffer {
 public:
  HeadlessFramebuffer(int width, int height);
  ~HeadlessFramebuffer();
  HeadlessFramebuffer(const HeadlessFramebuffer&) = delete;
  HeadlessFramebuffer& operator=(const HeadlessFramebuffer&) = delete;

  GLuint name() const { return framebuffer_; }

 private:
  GLuint framebuffer_ = 0;
  GLuint colour_ = 0;
};

}  // namespace palpate::viewer
