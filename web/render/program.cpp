#include "render/program.h"

#include <cmath>
#include <string_view>

#include "shaders.h"

namespace marrow {
namespace {

#if defined(MARROW_GLES)
constexpr const char* kVersion = "#version 300 es\n";
#else
constexpr const char* kVersion = "#version 330 core\n";
#endif

/// With the files that it includes: lines of their own, before all code.
std::string sourceOf(std::string_view file) {
  constexpr std::string_view kInclude = "#include \"";
  std::string source(shaderSource(file));
  for (size_t at = source.find(kInclude); at != std::string::npos; at = source.find(kInclude)) {
    const size_t name = at + kInclude.size(), end = source.find('"', name);
    source.replace(at, end + 1 - at, sourceOf(source.substr(name, end - name)));
  }
  return source;
}

GLuint compile(GLenum stage, const char* file) {
  const std::string source = kVersion + sourceOf(file);
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

}  // namespace

void setPlace(const Program& program, const Frame& frame, Vec3 origin,
              const std::array<Vec3, 3>& axes, Vec3 target) {
  const double size = frame.scale();
  const Vec3 part_axes[] = {frame.x / size, frame.y / size, frame.z() / size};
  const Vec3 place = frame.toWorld(origin) - target;
  std::array<Vec3, 3> rotation;
  double offset[3];
  for (size_t i = 0; i < 3; ++i) {
    rotation[i] = {dot(axes[i], part_axes[0]), dot(axes[i], part_axes[1]),
                   dot(axes[i], part_axes[2])};
    offset[i] = dot(axes[i], place);
  }
  program.setRotation("u_rotation", rotation);
  program.set("u_size", static_cast<float>(size));
  program.set("u_offset", Float3{static_cast<float>(offset[0]), static_cast<float>(offset[1]),
                                 static_cast<float>(offset[2])});
}

void setViewport(const Scene& scene) {
  glViewport(0, 0, static_cast<GLsizei>(std::lround(scene.size.width * scene.dpr)),
             static_cast<GLsizei>(std::lround(scene.size.height * scene.dpr)));
}

// Nothing is asked here, so that drivers compile all programs at the same time.
Program::Program(const char* vertex_file, const char* fragment_file)
    : program_(glCreateProgram()), name_(std::string(vertex_file) + " + " + fragment_file) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_file);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_file);
  glAttachShader(program_.name(), vertex);
  glAttachShader(program_.name(), fragment);
  glLinkProgram(program_.name());
  glDeleteShader(vertex);  // gone with the program
  glDeleteShader(fragment);
}

std::string Program::log() const {
  GLint ok = 0;
  glGetProgramiv(program_.name(), GL_LINK_STATUS, &ok);
  if (ok) return {};
  std::string log = name_ + ": ";
  char message[1000] = "";
  GLuint shaders[2] = {0, 0};
  GLsizei count = 0;
  glGetAttachedShaders(program_.name(), 2, &count, shaders);
  for (GLsizei i = 0; i < count; ++i) {
    glGetShaderInfoLog(shaders[i], sizeof message, nullptr, message);
    log += message;
  }
  glGetProgramInfoLog(program_.name(), sizeof message, nullptr, message);
  return log + message + "\n";
}

GLint Program::location(const char* uniform) const {
  for (const auto& [name, place] : locations_) {
    if (name == uniform) return place;
  }
  locations_.emplace_back(uniform, glGetUniformLocation(program_.name(), uniform));
  return locations_.back().second;
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
