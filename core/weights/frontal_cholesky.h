// Cholesky's factorisation of principal submatrices of one large sparse matrix, again and again.
//
// Why not Eigen's: its sparse one works on single numbers. Here what belongs together is eliminated
// together, in small dense fronts [Duff & Reid 1983], along one elimination tree that serves all
// submatrices. Some times as fast, and the same bits everywhere. The order is Eigen's: on lattices
// of some thousand points minimum degree needs a ninth of the work that nested dissection does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace marrow {

/// A symmetric matrix with all its entries, by rows; the columns of a row ascend.
struct SymmetricRows {
  std::vector<uint32_t> starts, columns;
  std::vector<double> values;

  uint32_t size() const { return static_cast<uint32_t>(starts.size()) - 1; }
  /// One row times x.
  double times(uint32_t row, const std::vector<double>& x) const {
    double sum = 0;
    for (uint32_t i = starts[row]; i < starts[row + 1]; ++i) sum += values[i] * x[columns[i]];
    return sum;
  }
  double diagonal(uint32_t row) const;
};

class FrontalCholesky {
 public:
  /// For submatrices of the rows and columns with chosen[i] ≠ 0. The matrix must outlive this.
  FrontalCholesky(const SymmetricRows& matrix, const std::vector<uint8_t>& chosen);

  /// Factorises the rows and columns with free[i] ≠ 0, which must be among the chosen. False where
  /// they are not positive definite.
  bool factor(const std::vector<uint8_t>& free);

  /// After a factorisation: right, where free, becomes the solution; elsewhere it stays.
  void solve(std::vector<double>& right);

 private:
  struct Node {           // of the dissection: a separator, or what was not worth cutting
    uint32_t begin, end;  // of order_
    uint32_t parent;      // 2³² − 1: none
  };
  struct Front {
    size_t own_count = 0;
    std::vector<uint32_t> rows;    // places in order_: its own, then those that it acts on
    std::vector<double> factor;    // stride() × own_count, by columns
    std::vector<double> update;    // what it adds to the rest, by columns, the lower triangle
    std::vector<uint32_t> givers;  // fronts whose updates it takes

    size_t stride() const { return rows.size() + 3; }  // whole tiles may begin at any row
  };

  bool eliminate(const Node& node, const std::vector<uint8_t>& free, Front& front);
  static bool eliminateDense(Front& front);

  const SymmetricRows& matrix_;
  std::vector<uint32_t> order_, place_;  // place_[order_[i]] = i
  std::vector<Node> nodes_;              // children before their parents
  std::vector<Front> fronts_;
  std::vector<double> dense_;
  std::vector<uint32_t> local_;  // of places in order_: row of the present front
};

}  // namespace marrow
