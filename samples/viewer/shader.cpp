#include "samples/viewer/shader.h"

#include <array>
#include <string>

#include "samples/cli/failure.h"

namespace palpate::viewer {
namespace {

GLuint compiled(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw cli::Failure("OpenGL refuses a shader: " + std::string(log.data()));
}

}  // namespace

Shader::Shader(const char* vertex, const char* fragment) : program_(glCreateProgram()) {
  const GLuint parts[] = {compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)};
  for (const GLuint part : parts) glAttachShader(program_, part);
  glLinkProgram(program_);
  for (const GLuint part : parts) glDeleteShader(part);
  GLint done = GL_FALSE;
  glGetProgramiv(program_, GL_LINK_STATUS, &done);
  if (!done) throw cli::Failure("OpenGL cannot link a program");
}

void Shader::set(const char* name, const glm::mat4& value) const {
  glUniformMatrix4fv(place(name), 1, GL_FALSE, &value[0][0]);
}

void Shader::set(const char* name, const glm::vec3& value) const {
  glUniform3fv(place(name), 1, &value[0]);
}

void Shader::set(const char* name, float value) const {
  glUniform1f(place(name), value);
}

}  // namespace palpate::viewer
