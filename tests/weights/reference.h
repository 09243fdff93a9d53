// Bounded biharmonic weights in the plainest way, for the tests: tetrahedra one by one, dense
// matrices, and an interior point method that knows nothing of active sets. Slow.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "weights/handles.h"
#include "weights/volume.h"

namespace marrow {

/// L M⁻¹ L of linear elements with lumped masses, in units of the lattice. A cell is cut into six
/// tetrahedra around a diagonal; as none of the four diagonals is better, L is the mean of all.
inline Eigen::MatrixXd referenceMatrix(const Volume& volume) {
  const Eigen::Index n = static_cast<Eigen::Index>(volume.vertices.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
  const uint32_t axes[6][2] = {{1, 2}, {2, 1}, {1, 4}, {4, 1}, {2, 4}, {4, 2}};
  for (const auto& cell : volume.cells) {
    for (int cut = 0; cut < 24; ++cut) {
      const auto& [first, second] = axes[cut % 6];
      const uint32_t diagonals[4] = {0, 1, 2, 4};
      uint32_t corners[4] = {0, first, first | second, 7};
      for (uint32_t& corner : corners) corner ^= diagonals[cut / 6];
      Eigen::Matrix4d shape;  // rows: 1, x, y, z of the corners
      for (int i = 0; i < 4; ++i) {
        const uint32_t c = corners[i];
        shape.col(i) << 1, c & 1 ? 1 : 0, c & 2 ? 1 : 0, c & 4 ? 1 : 0;
      }
      const Eigen::Matrix<double, 4, 3> slopes = shape.inverse().rightCols<3>();
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          stiffness(cell[corners[i]], cell[corners[j]]) += slopes.row(i).dot(slopes.row(j)) / 24;
        }
      }
    }
    for (const uint32_t v : cell) mass[v] += 0.125;
  }
  return stiffness * mass.cwiseInverse().asDiagonal() * stiffness;
}

/// The least ½ xᵀ A x + bᵀ x with 0 ≤ x ≤ 1 [Mehrotra's method without its corrector].
inline Eigen::VectorXd solveInBox(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index n = b.size();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 0.5);
  Eigen::VectorXd low = Eigen::VectorXd::Ones(n), high = low;  // multipliers of the bounds
  for (int step = 0; step < 200; ++step) {
    const Eigen::VectorXd room = Eigen::VectorXd::Ones(n) - x;
    const double gap = (low.dot(x) + high.dot(room)) / static_cast<double>(2 * n);
    const Eigen::VectorXd residual = a * x + b - low + high;
    if (gap < 1e-13 && residual.cwiseAbs().maxCoeff() < 1e-10) break;
    const double aim = 0.1 * gap;
    Eigen::MatrixXd system = a;
    system.diagonal() += (low.array() / x.array() + high.array() / room.array()).matrix();
    const Eigen::VectorXd right =
        -(residual.array() - (aim / x.array() - low.array()) + (aim / room.array() - high.array()))
             .matrix();
    const Eigen::VectorXd dx = system.llt().solve(right);
    const Eigen::VectorXd dlow = (aim - low.array() * dx.array()) / x.array() - low.array();
    const Eigen::VectorXd dhigh = (aim + high.array() * dx.array()) / room.array() - high.array();
    double length = 1;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (dx[i] < 0) length = std::min(length, -0.95 * x[i] / dx[i]);
      if (dx[i] > 0) length = std::min(length, 0.95 * room[i] / dx[i]);
      if (dlow[i] < 0) length = std::min(length, -0.95 * low[i] / dlow[i]);
      if (dhigh[i] < 0) length = std::min(length, -0.95 * high[i] / dhigh[i]);
    }
    x += length * dx;
    low += length * dlow;
    high += length * dhigh;
  }
  return x;
}

/// A column per bone, 0 … 1, not brought to sum 1. The volume must be one piece with handles.
inline Eigen::MatrixXd referenceWeights(const Volume& volume, const Handles& handles,
                                        size_t bone_count) {
  const Eigen::Index n = static_cast<Eigen::Index>(volume.vertices.size());
  const Eigen::MatrixXd matrix = referenceMatrix(volume);
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(bone_count));
  std::vector<bool> held(volume.vertices.size(), false);
  for (size_t i = 0; i < handles.vertices.size(); ++i) {
    held[handles.vertices[i]] = true;
    for (uint32_t k = handles.starts[i]; k < handles.starts[i + 1]; ++k) {
      weights(handles.vertices[i], handles.bones[k]) = handles.shares[k];
    }
  }
  std::vector<Eigen::Index> free;
  for (Eigen::Index v = 0; v < n; ++v) {
    if (!held[static_cast<size_t>(v)]) free.push_back(v);
  }
  const Eigen::MatrixXd system = matrix(free, free);
  for (Eigen::Index bone = 0; bone < weights.cols(); ++bone) {
    const Eigen::VectorXd right = matrix * weights.col(bone);
    weights(free, bone) = solveInBox(system, right(free));
  }
  return weights;
}

}  // namespace marrow
