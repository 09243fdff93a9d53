// Bounded biharmonic weights on a volume [Jacobson et al. 2011]: per bone the w of least ∫ (Δw)²
// with given values at the handles and 0 ≤ w ≤ 1.
#pragma once

#include <cstdint>
#include <vector>

#include "weights/frontal_cholesky.h"
#include "weights/handles.h"
#include "weights/volume.h"

namespace marrow {

/// L M⁻¹ L in units of the lattice. L is that of linear elements on the cells, each cut into six
/// tetrahedra, the mean over its four diagonals: a quarter for every edge of a cell and nothing
/// for diagonals, which keeps the matrix sparse and symmetric in space. M is an eighth a corner.
SymmetricRows biharmonicMatrix(const Volume& volume);

struct BiharmonicOptions {
  int most_steps = 20;  // 0: without bounds, cut off at 0 and 1
  /// A step that changes no weight by more than this is the last one. The weights are then about
  /// as near to the solution; 0 goes on till the guess is right.
  double tolerance = 5e-3;
};

/// Active sets: a guess at where the bounds hold, the solution where they don't, and what that says
/// about the guess [Hintermüller, Ito & Kunisch 2002]. Between two solutions the vertices move one
/// by one to where their neighbours want them within the bounds: by a solution alone the guess
/// would grow by one layer of the lattice a step. Starts at the weights without bounds, whose
/// matrix is factorised once for all bones.
class BoundedBiharmonic {
 public:
  /// Everything must outlive this.
  BoundedBiharmonic(const Volume& volume, const Handles& handles,
                    const BiharmonicOptions& options = {});

  /// One weight per vertex, 0 … 1. On pieces of the volume that the bone does not hold they are 0.
  std::vector<double> solve(uint32_t bone);

 private:
  bool prepare(uint32_t bone);
  void solveFree(FrontalCholesky& cholesky, const std::vector<uint8_t>& free,
                 std::vector<double>& weights);
  void relax(std::vector<uint8_t>& due, std::vector<double>& weights) const;

  const Volume& volume_;
  const Handles& handles_;
  BiharmonicOptions options_;
  SymmetricRows matrix_;
  std::vector<double> diagonal_;
  std::vector<uint8_t> loose_;  // per vertex: free without bounds
  FrontalCholesky unbounded_, bounded_;
  bool ready_ = false;
  // Of the bone.
  std::vector<double> fixed_;   // values at the handles, else 0
  std::vector<uint8_t> moves_;  // per vertex: loose, and of a piece that it holds
  std::vector<double> right_;
};

}  // namespace marrow
