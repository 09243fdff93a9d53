#include "surface/inflate.h"

#include <algorithm>
#include <cmath>

#include "surface/sparse_cholesky.h"

namespace marrow {
namespace {

/// The system −Δu = 2 in the interior points, by linear finite elements.
class Membrane {
 public:
  explicit Membrane(const Triangulation& flat)
      : flat_(flat),
        border_(flat.border_count),
        count_(static_cast<uint32_t>(flat.points.size()) - flat.border_count) {
    measure();
    collectTriangles();
  }

  /// Interior points in the order in which they should be eliminated.
  std::vector<uint32_t> eliminationOrder() const {
    return nestedDissection({flat_.points.begin() + border_, flat_.points.end()}, neighbours());
  }

  struct System {
    SymmetricMatrix matrix;
    std::vector<double> load;
  };
  /// least_cotangent: smaller ones are raised to it. Weights that are positive make u positive.
  System assemble(const std::vector<uint32_t>& order, double least_cotangent) const;

 private:
  static uint32_t next(uint32_t corner) { return corner == 2 ? 0 : corner + 1; }

  void measure() {
    cotangents_.resize(flat_.triangles.size());
    areas_.resize(flat_.triangles.size());
    for (size_t t = 0; t < flat_.triangles.size(); ++t) {
      const auto& [i, j, k] = flat_.triangles[t];
      const Vec2 a = flat_.points[i], b = flat_.points[j], c = flat_.points[k];
      const Vec2 ab = b - a, bc = c - b, ca = a - c;
      const double doubled = cross(ab, bc);
      cotangents_[t] = {-dot(ab, ca) / doubled, -dot(ab, bc) / doubled, -dot(bc, ca) / doubled};
      areas_[t] = doubled / 2;
    }
  }

  /// The corners at each interior point, as 3 × triangle + corner.
  void collectTriangles() {
    starts_.assign(count_ + 1, 0);
    for (const auto& triangle : flat_.triangles) {
      for (const uint32_t v : triangle) {
        if (v >= border_) ++starts_[v - border_ + 1];
      }
    }
    for (uint32_t v = 0; v < count_; ++v) starts_[v + 1] += starts_[v];
    around_.resize(starts_[count_]);
    std::vector<uint32_t> filled(starts_.begin(), starts_.end() - 1);
    for (uint32_t t = 0; t < flat_.triangles.size(); ++t) {
      for (uint32_t c = 0; c < 3; ++c) {
        const uint32_t v = flat_.triangles[t][c];
        if (v >= border_) around_[filled[v - border_]++] = 3 * t + c;
      }
    }
  }

  /// Around an interior point each neighbour follows it in exactly one triangle.
  Adjacency neighbours() const {
    Adjacency adjacency;
    adjacency.starts.reserve(count_ + 1);
    adjacency.ends.reserve(around_.size());
    for (uint32_t v = 0; v < count_; ++v) {
      adjacency.starts.push_back(static_cast<uint32_t>(adjacency.ends.size()));
      for (uint32_t i = starts_[v]; i < starts_[v + 1]; ++i) {
        const uint32_t far = flat_.triangles[around_[i] / 3][next(around_[i] % 3)];
        if (far >= border_) adjacency.ends.push_back(far - border_);
      }
    }
    adjacency.starts.push_back(static_cast<uint32_t>(adjacency.ends.size()));
    return adjacency;
  }

  const Triangulation& flat_;
  const uint32_t border_, count_;
  std::vector<std::array<double, 3>> cotangents_;  // of each triangle's angles
  std::vector<double> areas_;
  std::vector<uint32_t> starts_, around_;
};

Membrane::System Membrane::assemble(const std::vector<uint32_t>& order,
                                    double least_cotangent) const {
  std::vector<uint32_t> place(count_);
  for (uint32_t k = 0; k < count_; ++k) place[order[k]] = k;
  System system;
  SymmetricMatrix& matrix = system.matrix;
  matrix.diagonal.resize(count_);
  matrix.starts.resize(count_ + 1, 0);
  matrix.rows.reserve(around_.size());
  matrix.values.reserve(around_.size());
  system.load.resize(count_);
  std::vector<uint32_t> entry_of(count_, 0);  // of a row; stale unless the entry says the same row
  for (uint32_t k = 0; k < count_; ++k) {
    const uint32_t v = order[k], start = matrix.starts[k];
    double diagonal = 0, area = 0;
    for (uint32_t i = starts_[v]; i < starts_[v + 1]; ++i) {
      const uint32_t t = around_[i] / 3, corner = around_[i] % 3;
      for (const uint32_t c : {next(corner), next(next(corner))}) {
        // Half the cotangent of the angle across the edge to c.
        const double weight = std::max(cotangents_[t][3 - corner - c], least_cotangent) / 2;
        diagonal += weight;
        const uint32_t far = flat_.triangles[t][c];
        if (far < border_) continue;
        const uint32_t row = place[far - border_];
        if (row >= k) continue;
        uint32_t& entry = entry_of[row];
        if (entry < start || entry >= matrix.rows.size() || matrix.rows[entry] != row) {
          entry = static_cast<uint32_t>(matrix.rows.size());
          matrix.rows.push_back(row);
          matrix.values.push_back(0);
        }
        matrix.values[entry] -= weight;
      }
      area += areas_[t];
    }
    matrix.diagonal[k] = diagonal;
    matrix.starts[k + 1] = static_cast<uint32_t>(matrix.rows.size());
    system.load[k] = 2 * area / 3;
  }
  return system;
}

/// u in the interior points; empty where it is not positive everywhere.
std::vector<double> solveMembrane(const Membrane& membrane, const std::vector<uint32_t>& order,
                                  double least_cotangent) {
  auto [matrix, load] = membrane.assemble(order, least_cotangent);
  if (!solve(matrix, load)) return {};
  std::vector<double> u(order.size());
  for (size_t k = 0; k < order.size(); ++k) {
    if (!(load[k] > 0) || !std::isfinite(load[k])) return {};
    u[order[k]] = load[k];
  }
  return u;
}

/// False where an edge across the shape joins two border points: front and back would meet in it.
bool isFreeOfChords(const Triangulation& flat) {
  const uint32_t border = flat.border_count;
  for (const auto& [a, b, c] : flat.triangles) {
    if (a < border && b < border && b != a + 1 && (b != 0 || a + 1 != border)) return false;
    if (b < border && c < border && c != b + 1 && (c != 0 || b + 1 != border)) return false;
    if (c < border && a < border && a != c + 1 && (a != 0 || c + 1 != border)) return false;
  }
  return true;
}

/// Front and back of the height field, sewn together along the border.
Mesh stitch(const Triangulation& flat, const std::vector<double>& heights) {
  const uint32_t border = flat.border_count, interior = static_cast<uint32_t>(heights.size());
  Mesh mesh;
  mesh.positions.reserve(flat.points.size() + interior);
  for (uint32_t v = 0; v < border; ++v) {
    mesh.positions.push_back({flat.points[v].x, flat.points[v].y, 0});
  }
  for (const double side : {1.0, -1.0}) {
    for (uint32_t v = 0; v < interior; ++v) {
      const Vec2 p = flat.points[border + v];
      mesh.positions.push_back({p.x, p.y, side * heights[v]});
    }
  }
  mesh.triangles.reserve(2 * flat.triangles.size());
  mesh.triangles = flat.triangles;
  const auto back = [&](uint32_t v) { return v < border ? v : v + interior; };
  for (const auto& [a, b, c] : flat.triangles) {
    mesh.triangles.push_back({back(a), back(c), back(b)});
  }
  return mesh;
}

}  // namespace

Result<Mesh> inflate(const Triangulation& flat, double inscribed_radius,
                     const InflateOptions& options) {
  const bool round = options.profile == InflateOptions::Profile::round;
  if (!(options.thickness > 0) || !std::isfinite(options.thickness)) {
    return {Status::meshFailed, "The thickness is not a positive number."};
  }
  if (round && (!(inscribed_radius > 0) || !std::isfinite(inscribed_radius))) {
    return {Status::meshFailed, "The inscribed radius is not a positive number."};
  }
  if (flat.border_count < 3 || flat.points.size() <= flat.border_count || !isFreeOfChords(flat)) {
    return {Status::meshFailed, "The flat triangles cannot be inflated."};
  }

  // Between Delaunay triangles all weights are positive as they are.
  constexpr double kUnchanged = -HUGE_VAL, kPositive = 1e-6;
  const Membrane membrane(flat);
  const std::vector<uint32_t> order = membrane.eliminationOrder();
  std::vector<double> heights = solveMembrane(membrane, order, kUnchanged);
  if (heights.empty()) heights = solveMembrane(membrane, order, kPositive);
  if (heights.empty()) return {Status::meshFailed, "The flat triangles cannot be inflated."};

  double scale = 1;
  if (round)
    scale = inscribed_radius / std::sqrt(*std::max_element(heights.begin(), heights.end()));
  for (double& height : heights) height = scale * std::sqrt(height) * options.thickness;
  return stitch(flat, heights);
}

}  // namespace marrow
