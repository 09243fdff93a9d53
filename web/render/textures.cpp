#include "render/textures.h"

#include <cmath>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace marrow {
namespace {

constexpr GLsizei kSamples = 4;

void releaseRenderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
using GlRenderbuffer = GlObject<releaseRenderbuffer>;

GlRenderbuffer makeRenderbuffer(GLenum format, GLsizei width, GLsizei height) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
  return GlRenderbuffer(name);
}

}  // namespace

GlTexture Textures::drawn(const Thumbnail& thumbnail, double dpr, Renderer& renderer) {
  Scene scene = thumbnail.scene;
  scene.dpr = dpr;
  const auto width = static_cast<GLsizei>(std::lround(scene.size.width * dpr));
  const auto height = static_cast<GLsizei>(std::lround(scene.size.height * dpr));
  GlTexture texture = makeTexture(width, height, nullptr, true);
  const GlRenderbuffer color = makeRenderbuffer(GL_RGBA8, width, height);
  const GlRenderbuffer depth = makeRenderbuffer(GL_DEPTH_COMPONENT24, width, height);
  const GlFramebuffer smooth = makeFramebuffer(), plain = makeFramebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, smooth.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.name());
  renderer.draw(scene, *this, smooth.name());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain.name());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(),
                         0);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

void Textures::update(const Shelf& shelf, double dpr, Renderer& renderer) {
  std::unordered_set<TextureId> used;
  if (dpr != dpr_) textures_.clear();
  dpr_ = dpr;
  for (const Thumbnail& thumbnail : shelf.thumbnails.all()) {
    used.insert(thumbnail.texture);
    if (!thumbnail.ready || find(thumbnail.texture)) continue;
    textures_[thumbnail.texture] = drawn(thumbnail, dpr, renderer);
  }
  for (const auto& [id, picture] : shelf.pictures.all()) {
    used.insert(id);
    if (!picture.pixels || find(id)) continue;
    const Pixels& pixels = *picture.pixels;
    textures_[id] = makeTexture(pixels.width, pixels.height, pixels.rgba.data(), true);
    glGenerateMipmap(GL_TEXTURE_2D);
  }
  for (auto it = textures_.begin(); it != textures_.end();) {
    it = used.count(it->first) > 0 ? std::next(it) : textures_.erase(it);
  }
}

GLuint Textures::find(TextureId id) const {
  const auto found = textures_.find(id);
  return found == textures_.end() ? 0 : found->second.name();
}

}  // namespace marrow
