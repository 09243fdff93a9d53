// Textures by the numbers that panels and scenes know them by: thumbnails, drawn once each, and
// decoded pictures.
#pragma once

#include <unordered_map>

#include "keep/shelf.h"
#include "render/gl.h"
#include "render/renderer.h"

namespace marrow {

class Textures {
 public:
  /// Makes what is new on the shelf, for this density; forgets what is gone from it.
  void update(const Shelf& shelf, double dpr, Renderer& renderer);
  /// 0 where there is none.
  GLuint find(TextureId id) const;

 private:
  GlTexture drawn(const Thumbnail& thumbnail, double dpr, Renderer& renderer);

  std::unordered_map<TextureId, GlTexture> textures_;
  double dpr_ = 0;
};

}  // namespace marrow
