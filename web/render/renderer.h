// Draws a Scene. Holds nothing that cannot be made again: throw it away with a lost context.
#pragma once

#include <string>

#include "render/follows.h"
#include "render/gpu_cache.h"
#include "render/ground_shadow.h"
#include "render/instances.h"
#include "render/program.h"
#include "render/scene.h"

namespace marrow {

class Textures;

class Renderer {
 public:
  /// The context must be current.
  Renderer();
  /// Into a framebuffer, 0: the canvas.
  void draw(const Scene& scene, const Textures& textures, GLuint framebuffer = 0);
  /// Why a shader did not compile; empty when all did.
  std::string log() const;

 private:
  void drawBackground();
  void drawPictures(const Scene& scene, const Textures& textures);
  void drawBodies(const Scene& scene);
  template <typename Prepare>
  void drawFigure(const Program& program, const Scene& scene, const Prepare& prepare);
  void drawWireframe(const Scene& scene);
  void drawSheets(const Scene& scene);
  void drawProxy(const Scene& scene);
  void drawBones(const Scene& scene);
  void drawSegments(const std::vector<Scene::Segment>& segments, const Camera& camera,
                    const Scene& scene);
  void setView(const Program& program, const Camera& camera, const Scene& scene) const;

  Program background_, part_, wire_, sheet_, picture_, segment_, bone_, ball_, cone_;
  Instances segments_, octahedra_, balls_, tubes_;
  Follows follows_;
  GroundShadow shadow_;
  GpuCache cache_;
  GlVertexArray nothing_;
};

}  // namespace marrow
