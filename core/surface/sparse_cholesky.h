// Sparse symmetric positive definite systems of meshes: an elimination order from where the
// unknowns lie, and Eigen's Cholesky along it.
//
// Why not Eigen's order (AMD): it comes ten times as fast from the points as from the matrix alone.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Neighbours of each unknown: those of i are ends[starts[i]] … ends[starts[i + 1] − 1].
struct Adjacency {
  std::vector<uint32_t> starts, ends;
};

/// Elimination order by nested dissection [George 1973]: the box of the points is cut in two where
/// it is longest, the unknowns of one half that touch the other go last, and so on in both halves.
/// The unknowns, first to be eliminated first. O(n log n) for evenly spread points.
std::vector<uint32_t> nestedDissection(const std::vector<Vec2>& points, const Adjacency& adjacency);

/// A symmetric matrix: the diagonal, and what is above it by columns, rows in any order.
struct SymmetricMatrix {
  std::vector<double> diagonal;
  std::vector<uint32_t> starts, rows;
  std::vector<double> values;
};

/// Replaces `right` by the solution x of A x = right, by LDLᵀ. False where A is not positive
/// definite.
bool solve(const SymmetricMatrix& matrix, std::vector<double>& right);

}  // namespace marrow
