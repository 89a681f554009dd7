#pragma once

#include <epoxy/gl.h>

#include "samples/viewer/geometry.h"

namespace palpate::viewer {

// A program of a vertex and a fragment shader. Needs a current context from its making to its end.
class Shader {
 public:
  Shader(const char* vertex, const char* fragment);  // throws cli::Failure
  ~Shader() { glDeleteProgram(program_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  void use() const { glUseProgram(program_); }
  void set(const char* name, const glm::mat4& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, float value) const;

 private:
  GLint place(const char* name) const { return glGetUniformLocation(program_, name); }

  GLuint program_;
};

}  // namespace palpate::viewer
