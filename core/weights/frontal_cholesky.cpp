#include "weights/frontal_cholesky.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr uint32_t kNone = 0xffffffff;
/// The unknowns in an order of little fill, by minimum degree [Amestoy, Davis & Duff 1996].
std::vector<uint32_t> minimumDegree(const SymmetricRows& matrix,
                                    const std::vector<uint8_t>& chosen) {
  std::vector<uint32_t> unknowns;
  std::vector<int> number(matrix.size(), -1);
  for (uint32_t v = 0; v < matrix.size(); ++v) {
    if (!chosen[v]) continue;
    number[v] = static_cast<int>(unknowns.size());
    unknowns.push_back(v);
  }
  const int count = static_cast<int>(unknowns.size());
  Eigen::SparseMatrix<double> pattern(count, count);
  for (int j = 0; j < count; ++j) {
    const uint32_t v = unknowns[static_cast<size_t>(j)];
    pattern.startVec(j);
    for (uint32_t i = matrix.starts[v]; i < matrix.starts[v + 1]; ++i) {
      const int row = number[matrix.columns[i]];
      if (row >= 0) pattern.insertBack(row, j) = 1;
    }
  }
  pattern.finalize();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(count);
  if (count > 0) Eigen::AMDOrdering<int>()(pattern, order);
  std::vector<uint32_t> ordered(unknowns.size());
  for (int i = 0; i < count; ++i) {
    ordered[static_cast<size_t>(i)] = unknowns[static_cast<size_t>(order.indices()[i])];
  }
  return ordered;
}

/// Who is eliminated next of those that an unknown acts on: its parent in the elimination tree
/// [Liu 1990]; kNone: nobody. By place in the order.
std::vector<uint32_t> eliminationTree(const SymmetricRows& matrix,
                                      const std::vector<uint32_t>& order,
                                      const std::vector<uint32_t>& place) {
  const uint32_t count = static_cast<uint32_t>(order.size());
  std::vector<uint32_t> parents(count, kNone), tops(count, kNone);
  for (uint32_t k = 0; k < count; ++k) {
    for (uint32_t i = matrix.starts[order[k]]; i < matrix.starts[order[k] + 1]; ++i) {
      uint32_t below = place[matrix.columns[i]];
      while (below != kNone && below < k) {
        const uint32_t next = tops[below];
        tops[below] = k;
        if (next == kNone) parents[below] = k;
        below = next;
      }
    }
  }
  return parents;
}

/// Children right before their parents: the place each place gets.
std::vector<uint32_t> postorder(const std::vector<uint32_t>& parents) {
  const uint32_t count = static_cast<uint32_t>(parents.size());
  std::vector<uint32_t> first(count + 1, kNone), next(count, kNone);  // children; [count]: roots
  for (uint32_t k = count; k-- > 0;) {
    uint32_t& head = first[parents[k] == kNone ? count : parents[k]];
    next[k] = head;
    head = k;
  }
  std::vector<uint32_t> places(count), path;
  uint32_t number = 0;
  for (uint32_t root = first[count]; root != kNone; root = next[root]) {
    path.push_back(root);
    while (!path.empty()) {
      const uint32_t top = path.back(), child = first[top];
      if (child != kNone) {
        first[top] = next[child];
        path.push_back(child);
      } else {
        places[top] = number++;
        path.pop_back();
      }
    }
  }
  return places;
}

/// How many each one acts on when it is eliminated, itself left out.
std::vector<uint32_t> columnCounts(const SymmetricRows& matrix, const std::vector<uint32_t>& order,
                                   const std::vector<uint32_t>& place,
                                   const std::vector<uint32_t>& parents) {
  const uint32_t count = static_cast<uint32_t>(order.size());
  std::vector<uint32_t> counts(count, 0), seen(count, kNone);
  for (uint32_t k = 0; k < count; ++k) {
    seen[k] = k;
    for (uint32_t i = matrix.starts[order[k]]; i < matrix.starts[order[k] + 1]; ++i) {
      uint32_t below = place[matrix.columns[i]];
      if (below == kNone || below > k) continue;
      for (; seen[below] != k; below = parents[below]) {
        seen[below] = k;
        ++counts[below];
      }
    }
  }
  return counts;
}

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

FrontalCholesky::FrontalCholesky(const SymmetricRows& matrix, const std::vector<uint8_t>& chosen)
    : matrix_(matrix), order_(minimumDegree(matrix, chosen)), place_(matrix.size(), kNone) {
  const uint32_t count = static_cast<uint32_t>(order_.size());
  local_.assign(count, 0);
  const auto findPlaces = [&] {
    for (uint32_t i = 0; i < count; ++i) place_[order_[i]] = i;
  };
  findPlaces();
  const std::vector<uint32_t> before = eliminationTree(matrix, order_, place_);
  const std::vector<uint32_t> places = postorder(before);
  const std::vector<uint32_t> old_order = order_;
  std::vector<uint32_t> parents(count, kNone);
  for (uint32_t i = 0; i < count; ++i) {
    order_[places[i]] = old_order[i];
    if (before[i] != kNone) parents[places[i]] = places[before[i]];
  }
  findPlaces();
  const std::vector<uint32_t> counts = columnCounts(matrix, order_, place_, parents);

  // One node goes on as long as little is filled in by eliminating the next one with it.
  constexpr double kFilled = 0.2;
  std::vector<uint32_t> node_of(count);
  double filled = 0;
  for (uint32_t k = 0; k < count; ++k) {
    bool goes_on = k > 0 && parents[k - 1] == k;
    if (goes_on) {
      const double width = k - nodes_.back().begin, rows = counts[k] + 1;
      const double more = filled + width * (rows - counts[k - 1]);
      goes_on = more <= kFilled * (width + 1) * rows;
      if (goes_on) filled = more;
    }
    if (!goes_on) {
      nodes_.push_back({k, k, kNone});
      filled = 0;
    }
    nodes_.back().end = k + 1;
    node_of[k] = static_cast<uint32_t>(nodes_.size()) - 1;
  }
  for (Node& node : nodes_) {
    if (parents[node.end - 1] != kNone) node.parent = node_of[parents[node.end - 1]];
  }
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
