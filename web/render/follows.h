// The joints that vertices follow, for shaders that include skin.glsl.
#pragma once

#include <vector>

#include "render/gl.h"
#include "render/program.h"
#include "render/scene.h"

namespace marrow {

class Follows {
 public:
  /// Where the joints of the figure are in this frame.
  void update(const std::vector<Scene::PosedFigure::Joint>& joints);
  /// For the program in use; null: its vertices stay where they are.
  void set(const Program& program, const Scene::PosedFigure* figure) const;

 private:
  GlTexture joints_;
  int rows_ = 0;
};

}  // namespace marrow
