#pragma once

namespace palpate::viewer {

// An OpenGL context without any display. Its header is apart from OpenGL's: epoxy and EGL define the same
// types.
class HeadlessContext {
 public:
  HeadlessContext();  // throws cli::Failure
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  void* display_;  // EGLDisplay
  void* context_;  // EGLContext
};

}  // namespace palpate::viewer
