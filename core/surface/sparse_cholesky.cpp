#include "surface/sparse_cholesky.h"

#include <algorithm>

namespace marrow {
namespace {

constexpr uint32_t kNone = ~0u;
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
    Vec2 low = points_[order_[begin]], high = low;
    for (size_t i = begin; i < end; ++i) {
      const Vec2 p = points_[order_[i]];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
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

/// L of A = L D Lᵀ by columns, without its diagonal of ones.
struct Factor {
  std::vector<uint32_t> starts, rows;
  std::vector<double> values, diagonal;
};

/// Sizes of L's columns and the elimination tree.
std::vector<uint32_t> eliminationTree(const SymmetricMatrix& matrix, Factor& factor) {
  const uint32_t n = static_cast<uint32_t>(matrix.diagonal.size());
  std::vector<uint32_t> parent(n, kNone), seen(n, kNone);
  factor.starts.assign(n + 1, 0);
  for (uint32_t k = 0; k < n; ++k) {
    seen[k] = k;
    for (uint32_t entry = matrix.starts[k]; entry < matrix.starts[k + 1]; ++entry) {
      for (uint32_t i = matrix.rows[entry]; seen[i] != k; i = parent[i]) {
        if (parent[i] == kNone) parent[i] = k;
        ++factor.starts[i + 1];
        seen[i] = k;
      }
    }
  }
  for (uint32_t k = 0; k < n; ++k) factor.starts[k + 1] += factor.starts[k];
  return parent;
}

bool factorise(const SymmetricMatrix& matrix, Factor& factor) {
  const uint32_t n = static_cast<uint32_t>(matrix.diagonal.size());
  const std::vector<uint32_t> parent = eliminationTree(matrix, factor);
  factor.rows.resize(factor.starts[n]);
  factor.values.resize(factor.starts[n]);
  factor.diagonal.resize(n);

  std::vector<uint32_t> filled(factor.starts.begin(), factor.starts.end() - 1);
  std::vector<uint32_t> seen(n, kNone), pattern(n), path;
  std::vector<double> row(n, 0);
  for (uint32_t k = 0; k < n; ++k) {
    // Row k of L solves a triangular system; its pattern are the paths in the tree from the entries
    // of A's column up to k, later path first.
    uint32_t top = n;
    seen[k] = k;
    for (uint32_t entry = matrix.starts[k]; entry < matrix.starts[k + 1]; ++entry) {
      uint32_t i = matrix.rows[entry];
      row[i] += matrix.values[entry];
      path.clear();
      for (; seen[i] != k; i = parent[i]) {
        path.push_back(i);
        seen[i] = k;
      }
      while (!path.empty()) {
        pattern[--top] = path.back();
        path.pop_back();
      }
    }
    double diagonal = matrix.diagonal[k];
    for (; top < n; ++top) {
      const uint32_t i = pattern[top];
      const double value = row[i];
      row[i] = 0;
      const uint32_t end = filled[i];
      for (uint32_t entry = factor.starts[i]; entry < end; ++entry) {
        row[factor.rows[entry]] -= factor.values[entry] * value;
      }
      const double scaled = value / factor.diagonal[i];
      diagonal -= scaled * value;
      factor.rows[end] = k;
      factor.values[end] = scaled;
      filled[i] = end + 1;
    }
    if (!(diagonal > 0)) return false;
    factor.diagonal[k] = diagonal;
  }
  return true;
}

}  // namespace

std::vector<uint32_t> nestedDissection(const std::vector<Vec2>& points,
                                       const Adjacency& adjacency) {
  return Dissection(points, adjacency).run();
}

bool solve(const SymmetricMatrix& matrix, std::vector<double>& right) {
  Factor factor;
  if (!factorise(matrix, factor)) return false;
  const uint32_t n = static_cast<uint32_t>(right.size());
  for (uint32_t k = 0; k < n; ++k) {
    const double value = right[k];
    for (uint32_t entry = factor.starts[k]; entry < factor.starts[k + 1]; ++entry) {
      right[factor.rows[entry]] -= factor.values[entry] * value;
    }
  }
  for (uint32_t k = n; k-- > 0;) {
    double value = right[k] / factor.diagonal[k];
    for (uint32_t entry = factor.starts[k]; entry < factor.starts[k + 1]; ++entry) {
      value -= factor.values[entry] * right[factor.rows[entry]];
    }
    right[k] = value;
  }
  return true;
}

}  // namespace marrow
