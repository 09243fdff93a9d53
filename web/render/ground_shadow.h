// A soft shadow on the ground below the parts.
#pragma once

#include "render/follows.h"
#include "render/gpu_cache.h"
#include "render/program.h"
#include "render/scene.h"

namespace marrow {

class GroundShadow {
 public:
  GroundShadow();
  /// Draws into the canvas. The picture of the shadow is made again only where the bodies changed.
  void draw(const Scene& scene, GpuCache& cache, const Follows& follows, Float3 clip_scale,
            GLuint framebuffer);
  std::string log() const { return cast_.log() + blur_.log() + ground_.log(); }

 private:
  void makePicture(const Scene& scene, GpuCache& cache, const Follows& follows);

  Program cast_, blur_, ground_;
  GlTexture pictures_[2];
  GlFramebuffer framebuffers_[2];
  GlVertexArray nothing_;     // OpenGL draws nothing without one
  uint64_t fingerprint_ = 0;  // of the bodies in the picture
};

}  // namespace marrow
