#include "surface/sparse_cholesky.h"

#include <algorithm>

#include "support/catch.h"
#include "support/random.h"

using namespace marrow;

namespace {

/// A grid of points with their neighbours left, right, above and below.
struct GridGraph {
  std::vector<Vec2> points;
  Adjacency adjacency;

  GridGraph(uint32_t columns, uint32_t rows) {
    for (uint32_t y = 0; y < rows; ++y) {
      for (uint32_t x = 0; x < columns; ++x) {
        const uint32_t i = y * columns + x;
        points.push_back({static_cast<double>(x), static_cast<double>(y)});
        adjacency.starts.push_back(static_cast<uint32_t>(adjacency.ends.size()));
        if (x > 0) adjacency.ends.push_back(i - 1);
        if (x + 1 < columns) adjacency.ends.push_back(i + 1);
        if (y > 0) adjacency.ends.push_back(i - columns);
        if (y + 1 < rows) adjacency.ends.push_back(i + columns);
      }
    }
    adjacency.starts.push_back(static_cast<uint32_t>(adjacency.ends.size()));
  }
};

/// Laplacian plus `shift` on the diagonal, in the given order.
SymmetricMatrix laplacian(const Adjacency& adjacency, const std::vector<uint32_t>& order,
                          double shift) {
  std::vector<uint32_t> place(order.size());
  for (uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  SymmetricMatrix matrix;
  for (const uint32_t v : order) {
    matrix.starts.push_back(static_cast<uint32_t>(matrix.rows.size()));
    matrix.diagonal.push_back(adjacency.starts[v + 1] - adjacency.starts[v] + shift);
    for (uint32_t i = adjacency.starts[v]; i < adjacency.starts[v + 1]; ++i) {
      const uint32_t row = place[adjacency.ends[i]];
      if (row >= place[v]) continue;
      matrix.rows.push_back(row);
      matrix.values.push_back(-1);
    }
  }
  matrix.starts.push_back(static_cast<uint32_t>(matrix.rows.size()));
  return matrix;
}

std::vector<double> product(const SymmetricMatrix& matrix, const std::vector<double>& x) {
  std::vector<double> result(x.size());
  for (uint32_t k = 0; k < x.size(); ++k) {
    result[k] += matrix.diagonal[k] * x[k];
    for (uint32_t e = matrix.starts[k]; e < matrix.starts[k + 1]; ++e) {
      result[k] += matrix.values[e] * x[matrix.rows[e]];
      result[matrix.rows[e]] += matrix.values[e] * x[k];
    }
  }
  return result;
}

}  // namespace

TEST_CASE("sparse Cholesky: a system's solution is found in any elimination order",
          "[sparse_cholesky]") {
  Random random(31);
  for (int run = 0; run < 30; ++run) {
    const GridGraph grid(1 + random.below(20), 1 + random.below(20));
    std::vector<uint32_t> order = nestedDissection(grid.points, grid.adjacency);
    if (run % 2 == 1) {
      for (size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[random.below(static_cast<uint32_t>(i))]);
      }
    }
    const SymmetricMatrix matrix = laplacian(grid.adjacency, order, 0.01);
    std::vector<double> expected;
    for (size_t i = 0; i < order.size(); ++i) expected.push_back(random.between(-1, 1));
    std::vector<double> x = product(matrix, expected);
    REQUIRE(solve(matrix, x));
    double worst = 0;
    for (size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::fabs(x[i] - expected[i]));
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("sparse Cholesky: a dense matrix is factorised too", "[sparse_cholesky]") {
  SymmetricMatrix matrix;
  for (uint32_t k = 0; k < 12; ++k) {
    matrix.starts.push_back(static_cast<uint32_t>(matrix.rows.size()));
    matrix.diagonal.push_back(12 + k);
    for (uint32_t row = k; row-- > 0;) {
      matrix.rows.push_back(row);
      matrix.values.push_back(row % 2 == 0 ? 0.9 : -0.7);
    }
  }
  matrix.starts.push_back(static_cast<uint32_t>(matrix.rows.size()));
  std::vector<double> x(12, 1);
  x = product(matrix, x);
  REQUIRE(solve(matrix, x));
  for (const double value : x) CHECK(value == Approx(1).epsilon(1e-12));
}

TEST_CASE("sparse Cholesky: what is not positive definite is refused", "[sparse_cholesky]") {
  std::vector<double> right = {1, 1};
  CHECK_FALSE(solve({{1, 1}, {0, 0, 1}, {0}, {-2}}, right));
  right = {1, 1};
  CHECK_FALSE(solve({{0, 1}, {0, 0, 0}, {}, {}}, right));
  right = {1, 1};
  CHECK_FALSE(solve({{1, std::nan("")}, {0, 0, 0}, {}, {}}, right));
}

TEST_CASE("nested dissection: every unknown comes up once, wherever the points are",
          "[sparse_cholesky]") {
  GridGraph grid(30, 7);
  for (int run = 0; run < 4; ++run) {
    if (run == 1) std::fill(grid.points.begin(), grid.points.end(), Vec2{1, 1});
    if (run == 2) {
      for (size_t i = 0; i < grid.points.size(); ++i) {
        grid.points[i] = {std::sqrt(static_cast<double>(i)) * 1e-300, 0};
      }
    }
    if (run == 3) {
      for (size_t i = 0; i < grid.points.size(); ++i) grid.points[i] = {i == 5 ? 1e300 : 0.0, 0};
    }
    std::vector<uint32_t> order = nestedDissection(grid.points, grid.adjacency);
    std::sort(order.begin(), order.end());
    bool once = order.size() == grid.points.size();
    for (uint32_t i = 0; once && i < order.size(); ++i) once = order[i] == i;
    CHECK(once);
  }
  CHECK(nestedDissection({}, {{0}, {}}).empty());
}

TEST_CASE("nested dissection: a grid fills in far less than row by row", "[sparse_cholesky]") {
  const GridGraph grid(40, 40);
  const auto fill = [&](const std::vector<uint32_t>& order) {
    // Eliminate symbolically: neighbours of an eliminated unknown become each other's.
    std::vector<uint32_t> place(order.size());
    for (uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
    std::vector<std::vector<uint32_t>> later(order.size());
    size_t entries = 0;
    for (uint32_t k = 0; k < order.size(); ++k) {
      const uint32_t v = order[k];
      for (uint32_t i = grid.adjacency.starts[v]; i < grid.adjacency.starts[v + 1]; ++i) {
        const uint32_t far = place[grid.adjacency.ends[i]];
        if (far > k) later[k].push_back(far);
      }
      std::sort(later[k].begin(), later[k].end());
      later[k].erase(std::unique(later[k].begin(), later[k].end()), later[k].end());
      entries += later[k].size();
      for (size_t i = 1; i < later[k].size(); ++i) {
        later[later[k][0]].push_back(later[k][i]);
      }
    }
    return entries;
  };
  std::vector<uint32_t> rows(grid.points.size());
  for (uint32_t i = 0; i < rows.size(); ++i) rows[i] = i;
  CHECK(fill(nestedDissection(grid.points, grid.adjacency)) < fill(rows) / 2);
}
