// A linked pair of shaders from shaders/.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "render/gl.h"
#include "render/scene.h"

namespace marrow {

class Program;
/// Sets u_rotation, u_size and u_offset for a mesh that lies around `origin` of a part's frame,
/// seen along `axes` (rows) from `target`.
void setPlace(const Program& program, const Frame& frame, Vec3 origin,
              const std::array<Vec3, 3>& axes, Vec3 target);
/// The whole canvas.
void setViewport(const Scene& scene);

class Program {
 public:
  /// Names of files in shaders/, such as "part.vert". A shader that does not compile is our own
  /// mistake: the program then draws nothing and `log()` says why.
  Program(const char* vertex_file, const char* fragment_file);

  void use() const { glUseProgram(program_.name()); }
  /// Waits until the shaders are compiled; why they could not be, empty when they could.
  std::string log() const;

  // The program must be in use; a name it does not have is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, float x, float y) const;
  void set(const char* uniform, Float3 value) const;
  void set(const char* uniform, float x, float y, float z, float w) const;
  void set(const char* uniform, Rgba value) const;
  void setRotation(const char* uniform, const std::array<Vec3, 3>& rows) const;

 private:
  GLint location(const char* uniform) const;

  GlProgram program_;
  std::string name_;
  // By the address of the name: asking OpenGL every time takes longer than drawing a small part.
  mutable std::vector<std::pair<const char*, GLint>> locations_;
};

}  // namespace marrow
