#include "render/program.h"

#include "shaders.h"

namespace marrow {
namespace {

#if defined(MARROW_GLES)
constexpr const char* kVersion = "#version 300 es\n";
#else
constexpr const char* kVersion = "#version 330 core\n";
#endif

GLuint compile(GLenum stage, const char* file, std::string& log) {
  const std::string source = kVersion + std::string(shaderSource(file));
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    char message[1000] = "";
    glGetShaderInfoLog(shader, sizeof message, nullptr, message);
    log += std::string(file) + ": " + message;
  }
  return shader;
}

}  // namespace

Program::Program(const char* vertex_file, const char* fragment_file) : program_(glCreateProgram()) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_file, log_);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_file, log_);
  glAttachShader(program_.name(), vertex);
  glAttachShader(program_.name(), fragment);
  glLinkProgram(program_.name());
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = 0;
  glGetProgramiv(program_.name(), GL_LINK_STATUS, &ok);
  if (!ok && log_.empty()) {
    char message[1000] = "";
    glGetProgramInfoLog(program_.name(), sizeof message, nullptr, message);
    log_ = std::string(vertex_file) + ": " + message;
  }
}

void Program::set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }

void Program::set(const char* uniform, float value) const { glUniform1f(location(uniform), value); }

void Program::set(const char* uniform, float x, float y) const {
  glUniform2f(location(uniform), x, y);
}

void Program::set(const char* uniform, Float3 value) const {
  glUniform3f(location(uniform), value.x, value.y, value.z);
}

void Program::set(const char* uniform, float x, float y, float z, float w) const {
  glUniform4f(location(uniform), x, y, z, w);
}

void Program::set(const char* uniform, Rgba value) const {
  glUniform4f(location(uniform), value.r, value.g, value.b, value.a);
}

void Program::setRotation(const char* uniform, const std::array<Vec3, 3>& rows) const {
  float columns[9];
  for (size_t row = 0; row < 3; ++row) {
    columns[row] = static_cast<float>(rows[row].x);
    columns[3 + row] = static_cast<float>(rows[row].y);
    columns[6 + row] = static_cast<float>(rows[row].z);
  }
  glUniformMatrix3fv(location(uniform), 1, GL_FALSE, columns);
}

}  // namespace marrow
