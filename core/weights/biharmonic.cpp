#include "weights/biharmonic.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

/// The graph of the lattice: neighbours along its edges, ascending, and their weights.
SymmetricRows laplacian(const Volume& volume, std::vector<double>& mass) {
  struct Edge {
    uint32_t from, to;
    double weight;
  };
  const uint32_t n = static_cast<uint32_t>(volume.vertices.size());
  mass.assign(n, 0);
  std::vector<Edge> edges;
  edges.reserve(24 * volume.cells.size());
  for (const auto& cell : volume.cells) {
    for (uint32_t corner = 0; corner < 8; ++corner) {
      mass[cell[corner]] += 0.125;
      for (const uint32_t axis : {1u, 2u, 4u}) {
        edges.push_back({cell[corner], cell[corner ^ axis], 0.25});
      }
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  SymmetricRows rows;
  rows.starts.assign(1, 0);
  for (size_t i = 0; i < edges.size();) {
    const uint32_t v = edges[i].from;
    const size_t begin = rows.columns.size();
    double sum = 0;
    size_t diagonal = 0;
    bool placed = false;
    const auto placeDiagonal = [&] {
      placed = true;
      diagonal = rows.columns.size();
      rows.columns.push_back(v);
      rows.values.push_back(0);
    };
    for (; i < edges.size() && edges[i].from == v; ++i) {
      if (!placed && edges[i].to > v) placeDiagonal();
      if (rows.columns.size() > begin && rows.columns.back() == edges[i].to) {
        rows.values.back() -= edges[i].weight;
      } else {
        rows.columns.push_back(edges[i].to);
        rows.values.push_back(-edges[i].weight);
      }
      sum += edges[i].weight;
    }
    if (!placed) placeDiagonal();
    rows.values[diagonal] = sum;
    rows.starts.push_back(static_cast<uint32_t>(rows.columns.size()));
  }
  return rows;
}

constexpr double kNothing = 1e-3;  // without bounds most weights waver around 0; these begin at it
constexpr double kLeastMove = 1e-6;  // what would move by less stays, for the narrowest tolerance
constexpr int kSweeps = 10;          // between solutions, each the other way round

/// Those that are not held, of pieces that are.
std::vector<uint8_t> looseVertices(const Volume& volume, const Handles& handles) {
  std::vector<uint8_t> held(volume.piece_count, 0), loose(volume.vertices.size());
  for (const uint32_t v : handles.vertices) held[volume.pieces[v]] = 1;
  for (size_t v = 0; v < loose.size(); ++v) loose[v] = held[volume.pieces[v]];
  for (const uint32_t v : handles.vertices) loose[v] = 0;
  return loose;
}

}  // namespace

SymmetricRows biharmonicMatrix(const Volume& volume) {
  std::vector<double> mass;
  const SymmetricRows graph = laplacian(volume, mass);
  const uint32_t n = graph.size();
  SymmetricRows rows;
  rows.starts.reserve(n + 1);
  rows.starts.push_back(0);
  rows.columns.reserve(25 * size_t{n});
  rows.values.reserve(25 * size_t{n});
  std::vector<double> sums(n, 0);
  std::vector<uint8_t> seen(n, 0);
  std::vector<uint32_t> columns;
  for (uint32_t v = 0; v < n; ++v) {
    columns.clear();
    for (uint32_t i = graph.starts[v]; i < graph.starts[v + 1]; ++i) {
      const uint32_t between = graph.columns[i];
      const double value = graph.values[i] / mass[between];
      for (uint32_t j = graph.starts[between]; j < graph.starts[between + 1]; ++j) {
        const uint32_t u = graph.columns[j];
        if (!seen[u]) columns.push_back(u);
        seen[u] = 1;
        sums[u] += value * graph.values[j];
      }
    }
    std::sort(columns.begin(), columns.end());
    for (const uint32_t u : columns) {
      rows.columns.push_back(u);
      rows.values.push_back(sums[u]);
      sums[u] = 0;
      seen[u] = 0;
    }
    rows.starts.push_back(static_cast<uint32_t>(rows.columns.size()));
  }
  return rows;
}

BoundedBiharmonic::BoundedBiharmonic(const Volume& volume, const Handles& handles,
                                     const BiharmonicOptions& options)
    : volume_(volume),
      handles_(handles),
      options_(options),
      matrix_(biharmonicMatrix(volume)),
      loose_(looseVertices(volume, handles)),
      unbounded_(matrix_, loose_),
      bounded_(unbounded_) {
  for (uint32_t v = 0; v < matrix_.size(); ++v) diagonal_.push_back(matrix_.diagonal(v));
  ready_ = unbounded_.factor(loose_);
}

bool BoundedBiharmonic::prepare(uint32_t bone) {
  fixed_.assign(matrix_.size(), 0);
  std::vector<uint8_t> holds_piece(volume_.piece_count, 0);
  bool holds = false;
  for (size_t i = 0; i < handles_.vertices.size(); ++i) {
    for (uint32_t k = handles_.starts[i]; k < handles_.starts[i + 1]; ++k) {
      if (handles_.bones[k] != bone) continue;
      fixed_[handles_.vertices[i]] = handles_.shares[k];
      holds_piece[volume_.pieces[handles_.vertices[i]]] = 1;
      holds = true;
    }
  }
  moves_.resize(matrix_.size());
  for (uint32_t v = 0; v < matrix_.size(); ++v) {
    moves_[v] = loose_[v] && holds_piece[volume_.pieces[v]];
  }
  return holds;
}

/// Weights where free, from those where not.
void BoundedBiharmonic::solveFree(FrontalCholesky& cholesky, const std::vector<uint8_t>& free,
                                  std::vector<double>& weights) {
  right_.assign(matrix_.size(), 0);
  for (uint32_t v = 0; v < matrix_.size(); ++v) {
    if (free[v] || weights[v] == 0) continue;
    for (uint32_t i = matrix_.starts[v]; i < matrix_.starts[v + 1]; ++i) {
      right_[matrix_.columns[i]] -= matrix_.values[i] * weights[v];
    }
  }
  cholesky.solve(right_);
  for (uint32_t v = 0; v < matrix_.size(); ++v) {
    if (free[v]) weights[v] = right_[v];
  }
}

/// Lets those that are due move to where their neighbours want them within the bounds, one after
/// the other, and makes due who has to do with it.
void BoundedBiharmonic::relax(std::vector<uint8_t>& due, std::vector<double>& weights) const {
  const double least = std::max(kLeastMove, options_.tolerance / 100);
  const uint32_t n = matrix_.size();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t v = sweep % 2 == 0 ? i : n - 1 - i;
      if (!due[v]) continue;
      due[v] = 0;
      if (!moves_[v]) continue;
      const double wanted = weights[v] - matrix_.times(v, weights) / diagonal_[v];
      const double now = std::min(std::max(wanted, 0.0), 1.0);
      if (std::fabs(now - weights[v]) <= least) continue;
      weights[v] = now;
      for (uint32_t k = matrix_.starts[v]; k < matrix_.starts[v + 1]; ++k) {
        due[matrix_.columns[k]] = 1;
      }
      due[v] = 0;
    }
  }
}

std::vector<double> BoundedBiharmonic::solve(uint32_t bone) {
  if (!prepare(bone) || !ready_) return fixed_;
  const uint32_t n = matrix_.size();
  std::vector<double> weights = fixed_;
  solveFree(unbounded_, loose_, weights);
  if (options_.most_steps > 0) {
    for (uint32_t v = 0; v < n; ++v) {
      if (loose_[v] && (!moves_[v] || weights[v] <= kNothing)) weights[v] = 0;
    }
  }
  for (double& w : weights) w = std::min(std::max(w, 0.0), 1.0);

  std::vector<uint8_t> due = moves_, free(n, 0), before(n, 0);
  std::vector<double> solved = weights;
  for (int step = 0; step < options_.most_steps; ++step) {
    relax(due, weights);
    for (uint32_t v = 0; v < n; ++v) free[v] = moves_[v] && weights[v] > 0 && weights[v] < 1;
    if ((step > 0 && free == before) || !bounded_.factor(free)) break;
    before = free;
    solved = weights;
    solveFree(bounded_, free, solved);
    double change = 0;
    for (uint32_t v = 0; v < n; ++v) {
      const double w = std::min(std::max(solved[v], 0.0), 1.0);
      due[v] = due[v] || !free[v];
      if (w != solved[v]) {
        for (uint32_t k = matrix_.starts[v]; k < matrix_.starts[v + 1]; ++k) {
          due[matrix_.columns[k]] = 1;
        }
      }
      solved[v] = w;
      change = std::max(change, std::fabs(w - weights[v]));
    }
    if (change <= options_.tolerance) break;
    weights = solved;
  }
  return solved;
}

}  // namespace marrow
