#include "surface/sparse_cholesky.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "base/box.h"

namespace marrow {
namespace {

constexpr size_t kLeaf = 12;  // unknowns that are not worth dissecting

class Dissection {
 public:
  Dissection(const std::vector<Vec2>& points, const Adjacency& adjacency)
      : points_(points), adjacency_(adjacency), order_(points.size()), half_(points.size(), 0) {
    for (uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
    scratch_.reserve(points.size());
  }

  std::vector<uint32_t> run() {
    struct Range {
      size_t begin, end;
    };
    std::vector<Range> ranges = {{0, order_.size()}};
    while (!ranges.empty()) {
      const auto [begin, end] = ranges.back();
      ranges.pop_back();
      if (end - begin <= kLeaf) continue;
      const auto [middle, separator] = cut(begin, end);
      ranges.push_back({begin, middle});
      ranges.push_back({middle, separator});
    }
    return std::move(order_);
  }

 private:
  struct Cut {
    size_t middle, separator;
  };

  /// Rearranges order_[begin, end): one half, the other half from `middle`, the separator.
  Cut cut(size_t begin, size_t end) {
    Box2 box;
    for (size_t i = begin; i < end; ++i) box.include(points_[order_[i]]);
    const auto [low, high] = box;
    const bool wide = high.x - low.x > high.y - low.y;
    const double at = wide ? low.x + (high.x - low.x) / 2 : low.y + (high.y - low.y) / 2;
    size_t upper_count = 0;
    // Marks are unique to this cut, so that those of others need no clearing.
    const uint32_t lower = ++mark_, upper = ++mark_;
    for (size_t i = begin; i < end; ++i) {
      const Vec2 p = points_[order_[i]];
      const bool is_upper = (wide ? p.x : p.y) > at;
      half_[order_[i]] = is_upper ? upper : lower;
      upper_count += is_upper ? 1 : 0;
    }
    if (upper_count == 0 || upper_count == end - begin) {
      // Points on one spot: any halves will do.
      for (size_t i = begin; i < end; ++i) half_[order_[i]] = i < (begin + end) / 2 ? lower : upper;
      upper_count = end - (begin + end) / 2;
    }
    // The separator is taken out of the larger half.
    const bool from_upper = upper_count > end - begin - upper_count;
    const uint32_t other = from_upper ? lower : upper;

    scratch_.clear();
    separator_.clear();
    size_t kept = begin;
    for (size_t i = begin; i < end; ++i) {
      const uint32_t v = order_[i];
      if (half_[v] == other) {
        scratch_.push_back(v);
      } else if (touches(v, other)) {
        separator_.push_back(v);
      } else {
        order_[kept++] = v;
      }
    }
    std::copy(scratch_.begin(), scratch_.end(), order_.begin() + kept);
    std::copy(separator_.begin(), separator_.end(), order_.begin() + kept + scratch_.size());
    return {kept, kept + scratch_.size()};
  }

  bool touches(uint32_t v, uint32_t mark) const {
    for (uint32_t i = adjacency_.starts[v]; i < adjacency_.starts[v + 1]; ++i) {
      if (half_[adjacency_.ends[i]] == mark) return true;
    }
    return false;
  }

  const std::vector<Vec2>& points_;
  const Adjacency& adjacency_;
  std::vector<uint32_t> order_, half_, scratch_, separator_;
  uint32_t mark_ = 0;
};

}  // namespace

std::vector<uint32_t> nestedDissection(const std::vector<Vec2>& points,
                                       const Adjacency& adjacency) {
  return Dissection(points, adjacency).run();
}

bool solve(const SymmetricMatrix& matrix, std::vector<double>& right) {
  const int n = static_cast<int>(matrix.diagonal.size());
  // The upper triangle by columns, the diagonal at each column's end.
  Eigen::SparseMatrix<double> upper(n, n);
  upper.resizeNonZeros(n + static_cast<int>(matrix.values.size()));
  int entry = 0;
  for (int k = 0; k < n; ++k) {
    upper.outerIndexPtr()[k] = entry;
    for (uint32_t i = matrix.starts[k]; i < matrix.starts[k + 1]; ++i, ++entry) {
      upper.innerIndexPtr()[entry] = static_cast<int>(matrix.rows[i]);
      upper.valuePtr()[entry] = matrix.values[i];
    }
    upper.innerIndexPtr()[entry] = k;
    upper.valuePtr()[entry++] = matrix.diagonal[k];
  }
  upper.outerIndexPtr()[n] = entry;

  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>
      factor(upper);
  if (factor.info() != Eigen::Success || !(factor.vectorD().array() > 0).all()) return false;
  Eigen::Map<Eigen::VectorXd> x(right.data(), n);
  x = factor.solve(x).eval();
  return true;
}

}  // namespace marrow
