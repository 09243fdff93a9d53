// OpenGL ES 3.0 or the part of desktop OpenGL 3.3 that is the same.
#pragma once

#if defined(MARROW_GLES)
#include <GLES3/gl3.h>
#elif defined(__APPLE__)
#include <OpenGL/gl3.h>
#else
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#endif

#include <utility>

namespace marrow {

/// Owns one OpenGL object; 0 is none.
template <void (*release)(GLuint)>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (name_) release(name_);
  }
  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

inline void releaseBuffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void releaseVertexArray(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void releaseTexture(GLuint name) { glDeleteTextures(1, &name); }
inline void releaseFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void releaseProgram(GLuint name) { glDeleteProgram(name); }

using GlBuffer = GlObject<releaseBuffer>;
using GlVertexArray = GlObject<releaseVertexArray>;
using GlTexture = GlObject<releaseTexture>;
using GlFramebuffer = GlObject<releaseFramebuffer>;
using GlProgram = GlObject<releaseProgram>;

inline GlBuffer makeBuffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return GlBuffer(name);
}
inline GlVertexArray makeVertexArray() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return GlVertexArray(name);
}

/// Of `width` × `height` pixels, RGBA from the top or nothing yet; left bound. Smooth, and its edge
/// goes on. Mipmaps, where wanted, are the caller's to make.
inline GlTexture makeTexture(GLsizei width, GLsizei height, const void* rgba, bool mipmaps) {
  GLuint name = 0;
  glGenTextures(1, &name);
  GlTexture texture(name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}
inline GlFramebuffer makeFramebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return GlFramebuffer(name);
}

}  // namespace marrow
