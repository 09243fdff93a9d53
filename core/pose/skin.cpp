#include "pose/skin.h"

#include <cassert>
#include <cmath>

namespace marrow {
namespace {

/// A rotation and a move as a 3 × 4 matrix, by columns.
struct Matrix {
  Vec3 x, y, z, move;

  void add(const Matrix& m, double weight) {
    x = x + m.x * weight;
    y = y + m.y * weight;
    z = z + m.z * weight;
    move = move + m.move * weight;
  }
  Vec3 direction(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
};

Matrix matrixOf(const Rigid& motion) {
  return {motion.direction({1, 0, 0}), motion.direction({0, 1, 0}), motion.direction({0, 0, 1}),
          motion.move};
}

struct DualQuaternion {
  Quaternion real, dual;
};

DualQuaternion dualOf(const Rigid& motion) {
  const Quaternion move{motion.move.x, motion.move.y, motion.move.z, 0};
  return {motion.rotation, move * motion.rotation * 0.5};
}

/// The rigid motion that the blended one stands for.
Rigid rigidOf(const DualQuaternion& blended) {
  const double inverse = 1 / std::sqrt(dot(blended.real, blended.real));
  const Quaternion real = blended.real * inverse, dual = blended.dual * inverse;
  const Quaternion move = dual * conjugate(real) * 2;
  return {real, {move.x, move.y, move.z}};
}

Vec3 unit(Vec3 v) {
  const double size = length(v);
  return size > 0 ? v / size : v;
}

}  // namespace

void skin(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
          const std::vector<VertexSkin>& skin, const std::vector<Rigid>& motions, Skinning how,
          SkinnedVertices& result) {
  assert(positions.size() == skin.size() && normals.size() == skin.size());
  const size_t n = positions.size();
  result.positions.resize(n);
  result.normals.resize(n);
  if (how == Skinning::linear) {
    std::vector<Matrix> matrices;
    matrices.reserve(motions.size());
    for (const Rigid& motion : motions) matrices.push_back(matrixOf(motion));
    for (size_t i = 0; i < n; ++i) {
      const VertexSkin& own = skin[i];
      Matrix blended{};
      for (size_t k = 0; k < VertexSkin::kMost && own.weights[k] > 0; ++k) {
        blended.add(matrices[own.joints[k]], own.weights[k]);
      }
      result.positions[i] = blended.direction(positions[i]) + blended.move;
      result.normals[i] = unit(blended.direction(normals[i]));
    }
    return;
  }
  std::vector<DualQuaternion> duals;
  duals.reserve(motions.size());
  for (const Rigid& motion : motions) duals.push_back(dualOf(motion));
  for (size_t i = 0; i < n; ++i) {
    const VertexSkin& own = skin[i];
    const DualQuaternion& first = duals[own.joints[0]];
    DualQuaternion blended{first.real * own.weights[0], first.dual * own.weights[0]};
    for (size_t k = 1; k < VertexSkin::kMost && own.weights[k] > 0; ++k) {
      const DualQuaternion& other = duals[own.joints[k]];
      // q and −q are one rotation: the one on the first joint's side.
      const double weight = dot(first.real, other.real) < 0 ? -own.weights[k] : own.weights[k];
      blended.real = blended.real + other.real * weight;
      blended.dual = blended.dual + other.dual * weight;
    }
    const Rigid motion = rigidOf(blended);
    result.positions[i] = motion(positions[i]);
    result.normals[i] = motion.direction(normals[i]);
  }
}

}  // namespace marrow
