#include "weights/frontal_cholesky.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = 0xffffffff;
constexpr uint32_t kLeaf = 24;  // unknowns that are not worth dissecting

/// Halves of the box where it is longest, and between them what of the larger half touches the
/// other; reports the ranges of the order, children before their parents.
class Dissection {
 public:
  Dissection(const SymmetricRows& matrix, const std::vector<Vec3>& points)
      : matrix_(matrix), points_(points), order_(points.size()), side_(points.size(), 0) {
    for (uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  }

  template <typename Report>  // (begin, end) → its number
  std::vector<uint32_t> run(Report&& report) {
    divide(0, static_cast<uint32_t>(order_.size()), report);
    return std::move(order_);
  }

 private:
  template <typename Report>
  std::vector<uint32_t> divide(uint32_t begin, uint32_t end, Report& report) {
    if (begin == end) return {};
    uint32_t middle = end, separator = end;
    if (end - begin > kLeaf) cut(begin, end, middle, separator);
    if (separator == end && middle == end) return {report(begin, end, std::vector<uint32_t>{})};
    std::vector<uint32_t> children = divide(begin, middle, report);
    for (const uint32_t child : divide(middle, separator, report)) children.push_back(child);
    if (separator == end) return children;  // two halves that do not touch
    return {report(separator, end, children)};
  }

  void cut(uint32_t begin, uint32_t end, uint32_t& middle, uint32_t& separator) {
    const auto first = order_.begin() + begin, last = order_.begin() + end;
    Box3 box;
    for (auto v = first; v != last; ++v) box.include(points_[*v]);
    const Vec3 size = box.high - box.low;
    double Vec3::*axis = &Vec3::x;
    if (size.y > size.*axis) axis = &Vec3::y;
    if (size.z > size.*axis) axis = &Vec3::z;
    // At the median, but not through points that lie in one plane.
    scratch_.assign(first, last);
    const auto median = scratch_.begin() + (end - begin) / 2;
    std::nth_element(scratch_.begin(), median, scratch_.end(),
                     [&](uint32_t a, uint32_t b) { return points_[a].*axis < points_[b].*axis; });
    const double at = points_[*median].*axis;
    const bool lowest = at == box.low.*axis;  // more than half of them: between them and the others
    const uint32_t low = ++mark_, high = ++mark_;
    uint32_t low_count = 0;
    for (auto v = first; v != last; ++v) {
      const bool is_low = lowest ? points_[*v].*axis <= at : points_[*v].*axis < at;
      side_[*v] = is_low ? low : high;
      low_count += is_low;
    }
    if (low_count == end - begin) return;
    const bool from_low = low_count > end - begin - low_count;
    const uint32_t other = from_low ? high : low;
    const auto touches = [&](uint32_t v) {
      for (uint32_t i = matrix_.starts[v]; i < matrix_.starts[v + 1]; ++i) {
        if (side_[matrix_.columns[i]] == other) return true;
      }
      return false;
    };
    scratch_.assign(first, last);
    const auto kept = std::stable_partition(scratch_.begin(), scratch_.end(),
                                            [&](uint32_t v) { return side_[v] == other; });
    const auto rest =
        std::stable_partition(kept, scratch_.end(), [&](uint32_t v) { return !touches(v); });
    std::copy(scratch_.begin(), scratch_.end(), first);
    middle = begin + static_cast<uint32_t>(kept - scratch_.begin());
    separator = begin + static_cast<uint32_t>(rest - scratch_.begin());
  }

  const SymmetricRows& matrix_;
  const std::vector<Vec3>& points_;
  std::vector<uint32_t> order_, side_, scratch_;
  uint32_t mark_ = 0;
};

constexpr size_t kTile = 4;

/// What the columns before take from a tile of 4 × 4 entries: Σ_k a[i + k stride] b[j + k stride]
/// at i + 4 j. The sums run in the same order on every machine, however many are done at once.
inline void products(const double* a, const double* b, size_t stride, size_t columns,
                     double* sums) {
  double tile[kTile * kTile] = {};
  for (size_t k = 0; k < columns; ++k, a += stride, b += stride) {
    for (size_t j = 0; j < kTile; ++j) {
      for (size_t i = 0; i < kTile; ++i) tile[i + kTile * j] += a[i] * b[j];
    }
  }
  std::copy(tile, tile + kTile * kTile, sums);
}

/// Σ a[i] b[i], in four sums.
double dotProduct(const double* a, const double* b, size_t count) {
  double sums[4] = {};
  size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    for (size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
  }
  for (; i < count; ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

double SymmetricRows::diagonal(uint32_t row) const {
  const auto begin = columns.begin() + starts[row], end = columns.begin() + starts[row + 1];
  const auto found = std::lower_bound(begin, end, row);
  return found != end && *found == row ? values[static_cast<size_t>(found - columns.begin())] : 0;
}

FrontalCholesky::FrontalCholesky(const SymmetricRows& matrix, const std::vector<Vec3>& points)
    : matrix_(matrix), place_(points.size()), local_(points.size(), 0) {
  order_ = Dissection(matrix, points)
               .run([&](uint32_t begin, uint32_t end, const std::vector<uint32_t>& children) {
                 const uint32_t number = static_cast<uint32_t>(nodes_.size());
                 for (const uint32_t child : children) nodes_[child].parent = number;
                 nodes_.push_back({begin, end, kNone});
                 return number;
               });
  for (uint32_t i = 0; i < order_.size(); ++i) place_[order_[i]] = i;
  fronts_.resize(nodes_.size());
}

bool FrontalCholesky::eliminate(const Node& node, const std::vector<uint8_t>& free, Front& front) {
  // Its rows: its own, then what they and the updates it takes act on.
  front.rows.clear();
  for (uint32_t i = node.begin; i < node.end; ++i) {
    if (free[order_[i]]) front.rows.push_back(i);
  }
  front.own_count = front.rows.size();
  if (front.own_count == 0) return true;
  constexpr uint32_t kSeen = kNone;
  const auto include = [&](uint32_t place) {
    if (place < node.end || local_[place] == kSeen) return;
    local_[place] = kSeen;
    front.rows.push_back(place);
  };
  for (size_t k = 0; k < front.own_count; ++k) {
    const uint32_t v = order_[front.rows[k]];
    for (uint32_t i = matrix_.starts[v]; i < matrix_.starts[v + 1]; ++i) {
      if (free[matrix_.columns[i]]) include(place_[matrix_.columns[i]]);
    }
  }
  for (const uint32_t giver : front.givers) {
    const Front& from = fronts_[giver];
    for (size_t k = from.own_count; k < from.rows.size(); ++k) include(from.rows[k]);
  }
  std::sort(front.rows.begin() + static_cast<std::ptrdiff_t>(front.own_count), front.rows.end());
  const size_t size = front.rows.size(), own = front.own_count, rest = size - own;
  const size_t stride = front.stride();
  for (uint32_t k = 0; k < size; ++k) local_[front.rows[k]] = k;

  // The lower triangle: first the columns that are eliminated, then those of the update.
  front.factor.assign(stride * own, 0);
  front.update.assign(rest * rest, 0);
  const auto entry = [&](size_t row, size_t column) -> double& {
    return column < own ? front.factor[row + column * stride]
                        : front.update[row - own + (column - own) * rest];
  };
  for (size_t k = 0; k < own; ++k) {
    const uint32_t v = order_[front.rows[k]];
    for (uint32_t i = matrix_.starts[v]; i < matrix_.starts[v + 1]; ++i) {
      const uint32_t place = place_[matrix_.columns[i]];
      if (place < front.rows[k] || !free[matrix_.columns[i]]) continue;
      front.factor[local_[place] + k * stride] = matrix_.values[i];
    }
  }
  for (const uint32_t giver : front.givers) {
    Front& from = fronts_[giver];
    const size_t count = from.rows.size() - from.own_count;
    const uint32_t* rows = from.rows.data() + from.own_count;
    for (size_t j = 0; j < count; ++j) {
      const size_t column = local_[rows[j]];
      const double* values = from.update.data() + j * count;
      for (size_t i = j; i < count; ++i) entry(local_[rows[i]], column) += values[i];
    }
  }
  for (const uint32_t place : front.rows) local_[place] = 0;

  return eliminateDense(front);
}

bool FrontalCholesky::eliminateDense(Front& front) {
  const size_t size = front.rows.size(), own = front.own_count, rest = size - own;
  const size_t stride = front.stride();
  double* factor = front.factor.data();
  double sums[kTile * kTile];
  for (size_t first = 0; first < own; first += kTile) {
    const size_t end = std::min(first + kTile, own);
    for (size_t row = first; first > 0 && row < size; row += kTile) {
      products(factor + row, factor + first, stride, first, sums);
      for (size_t j = first; j < end; ++j) {
        double* column = factor + row + j * stride;
        for (size_t i = 0; i < kTile; ++i) column[i] -= sums[i + kTile * (j - first)];
      }
    }
    for (size_t j = first; j < end; ++j) {
      double* column = factor + j * stride;
      for (size_t k = first; k < j; ++k) {
        const double* before = factor + k * stride;
        const double times = before[j];
        for (size_t i = j; i < size; ++i) column[i] -= before[i] * times;
      }
      if (!(column[j] > 0) || !std::isfinite(column[j])) return false;
      const double inverse = 1 / std::sqrt(column[j]);
      for (size_t i = j; i < size; ++i) column[i] *= inverse;
      // Rows past the last are read with the others, and above the diagonal they count as well.
      std::fill(column + size, column + stride, 0.0);
    }
  }
  for (size_t first = 0; first < rest; first += kTile) {
    const size_t end = std::min(first + kTile, rest);
    for (size_t row = first; row < rest; row += kTile) {
      products(factor + own + row, factor + own + first, stride, own, sums);
      const size_t count = std::min(kTile, rest - row);
      for (size_t j = first; j < end; ++j) {
        double* column = front.update.data() + row + j * rest;
        for (size_t i = 0; i < count; ++i) column[i] -= sums[i + kTile * (j - first)];
      }
    }
  }
  return true;
}

bool FrontalCholesky::factor(const std::vector<uint8_t>& free) {
  for (Front& front : fronts_) front.givers.clear();
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    Front& front = fronts_[i];
    if (!eliminate(nodes_[i], free, front)) {
      std::fill(local_.begin(), local_.end(), 0);
      return false;
    }
    if (nodes_[i].parent == kNone) continue;
    std::vector<uint32_t>& givers = fronts_[nodes_[i].parent].givers;
    if (front.own_count == 0) {
      givers.insert(givers.end(), front.givers.begin(), front.givers.end());
    } else if (front.rows.size() > front.own_count) {
      givers.push_back(i);
    }
  }
  return true;
}

void FrontalCholesky::solve(std::vector<double>& right) {
  const auto gather = [&](const Front& front) {
    dense_.resize(front.rows.size());
    for (size_t i = 0; i < front.rows.size(); ++i) dense_[i] = right[order_[front.rows[i]]];
  };
  for (const Front& front : fronts_) {
    if (front.own_count == 0) continue;
    gather(front);
    for (size_t j = 0; j < front.own_count; ++j) {
      const double* column = front.factor.data() + j * front.stride();
      const double x = dense_[j] / column[j];
      dense_[j] = x;
      for (size_t i = j + 1; i < dense_.size(); ++i) dense_[i] -= column[i] * x;
    }
    for (size_t i = 0; i < dense_.size(); ++i) right[order_[front.rows[i]]] = dense_[i];
  }
  for (size_t f = fronts_.size(); f-- > 0;) {
    const Front& front = fronts_[f];
    if (front.own_count == 0) continue;
    gather(front);
    for (size_t j = front.own_count; j-- > 0;) {
      const double* column = front.factor.data() + j * front.stride();
      const double sum = dotProduct(column + j + 1, dense_.data() + j + 1, dense_.size() - j - 1);
      dense_[j] = (dense_[j] - sum) / column[j];
      right[order_[front.rows[j]]] = dense_[j];
    }
  }
}

}  // namespace marrow
