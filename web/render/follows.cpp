#include "render/follows.h"

#include <algorithm>

namespace marrow {
namespace {

constexpr int kTexels = 768;  // in a row, as in skin.glsl
constexpr int kTexelsOfJoint = 3;
constexpr GLenum kUnit = 1;  // pictures have the first

}  // namespace

void Follows::update(const std::vector<Scene::PosedFigure::Joint>& joints) {
  static_assert(sizeof(Scene::PosedFigure::Joint) == kTexelsOfJoint * 4 * sizeof(float));
  constexpr int kJoints = kTexels / kTexelsOfJoint;
  const int rows = std::max(1, (static_cast<int>(joints.size()) + kJoints - 1) / kJoints);
  std::vector<Scene::PosedFigure::Joint> texels(static_cast<size_t>(rows) * kJoints);
  std::copy(joints.begin(), joints.end(), texels.begin());
  glActiveTexture(GL_TEXTURE0 + kUnit);
  if (!joints_ || rows != rows_) {
    GLuint name = 0;
    glGenTextures(1, &name);
    joints_ = GlTexture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kTexels, rows, 0, GL_RGBA, GL_FLOAT, texels.data());
    rows_ = rows;
  } else {
    glBindTexture(GL_TEXTURE_2D, joints_.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTexels, rows, GL_RGBA, GL_FLOAT, texels.data());
  }
  glActiveTexture(GL_TEXTURE0);
}

void Follows::set(const Program& program, const Scene::PosedFigure* figure) const {
  const bool linear = figure && figure->skinning == Skinning::linear;
  program.set("u_joints", static_cast<int>(kUnit));
  program.set("u_skinning", !figure ? 0 : linear ? 1 : 2);
  program.set("u_weights", figure ? static_cast<int>(figure->show) : 0);
}

}  // namespace marrow
