#include "weights/frontal_cholesky.h"

#include <Eigen/Dense>
#include <set>

#include "base/vec.h"
#include "support/catch.h"
#include "support/random.h"

using namespace marrow;

namespace {

/// A random positive definite matrix of points, near ones coupled.
struct System {
  std::vector<Vec3> points;
  Eigen::MatrixXd dense;
  SymmetricRows rows;
};

System randomSystem(Random& random, int n, Vec3 size, double reach) {
  System system;
  for (int i = 0; i < n; ++i) {
    system.points.push_back(
        {random.unit() * size.x, random.unit() * size.y, random.unit() * size.z});
  }
  system.dense = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      if (distance(system.points[i], system.points[j]) > reach) continue;
      const double value = random.between(-1, 1);
      system.dense(i, j) = system.dense(j, i) = value;
      system.dense(i, i) += std::fabs(value);
      system.dense(j, j) += std::fabs(value);
    }
    system.dense(i, i) += random.between(0.1, 1);
  }
  system.rows.starts.push_back(0);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i != j && system.dense(i, j) == 0) continue;
      system.rows.columns.push_back(static_cast<uint32_t>(j));
      system.rows.values.push_back(system.dense(i, j));
    }
    system.rows.starts.push_back(static_cast<uint32_t>(system.rows.columns.size()));
  }
  return system;
}

void checkSolution(const System& system, FrontalCholesky& cholesky,
                   const std::vector<uint8_t>& free, Random& random) {
  std::vector<Eigen::Index> indices;
  for (size_t i = 0; i < free.size(); ++i) {
    if (free[i]) indices.push_back(static_cast<Eigen::Index>(i));
  }
  REQUIRE(cholesky.factor(free));
  std::vector<double> x(free.size());
  for (double& value : x) value = random.between(-1, 1);
  const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(x.data(), system.dense.rows());
  cholesky.solve(x);
  const Eigen::VectorXd ours = Eigen::Map<Eigen::VectorXd>(x.data(), system.dense.rows());
  for (size_t i = 0; i < free.size(); ++i) {
    if (!free[i]) CHECK(x[i] == right[static_cast<Eigen::Index>(i)]);
  }
  if (indices.empty()) return;
  const Eigen::VectorXd exact =
      Eigen::MatrixXd(system.dense(indices, indices)).llt().solve(Eigen::VectorXd(right(indices)));
  CHECK((exact - Eigen::VectorXd(ours(indices))).cwiseAbs().maxCoeff() <
        1e-10 * (1 + exact.cwiseAbs().maxCoeff()));
}

}  // namespace

TEST_CASE("frontal cholesky: solves what Eigen solves, for any choice of unknowns") {
  Random random(11);
  const Vec3 shapes[] = {{10, 10, 10}, {100, 3, 3}, {10, 10, 0}, {10, 0, 0}, {0, 0, 0}};
  for (const Vec3 shape : shapes) {
    for (const int n : {1, 2, 7, 30, 150, 400}) {
      const double reach = shape.x == 0 ? 1 : shape.x * shape.y * shape.z > 0 ? 2.5 : 1;
      const System system = randomSystem(random, n, shape, reach);
      FrontalCholesky cholesky(system.rows, std::vector<uint8_t>(system.points.size(), 1));
      for (const double often : {1.0, 0.6, 0.1, 0.0, 0.9}) {
        std::vector<uint8_t> free(static_cast<size_t>(n));
        for (auto& one : free) one = random.unit() < often;
        checkSolution(system, cholesky, free, random);
      }
    }
  }
}

TEST_CASE("frontal cholesky: a copy works on its own") {
  Random random(12);
  const System system = randomSystem(random, 200, {10, 10, 10}, 2.5);
  const std::vector<uint8_t> all(200, 1);
  FrontalCholesky one(system.rows, all), other(one);
  std::vector<uint8_t> free(200, 1);
  REQUIRE(one.factor(free));
  std::fill(free.begin(), free.begin() + 100, uint8_t{0});
  checkSolution(system, other, free, random);
  std::vector<double> x(200, 1);
  one.solve(x);
  const Eigen::VectorXd exact = system.dense.llt().solve(Eigen::VectorXd::Ones(200));
  CHECK((exact - Eigen::Map<Eigen::VectorXd>(x.data(), 200)).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("frontal cholesky: what is not positive definite is refused, and the next one solved") {
  Random random(13);
  System system = randomSystem(random, 120, {10, 10, 10}, 2.5);
  const uint32_t bad = 57;
  const uint32_t first = system.rows.starts[bad];
  for (uint32_t i = first; i < system.rows.starts[bad + 1]; ++i) {
    if (system.rows.columns[i] == bad) system.rows.values[i] = -1;
  }
  CHECK(system.rows.diagonal(bad) == -1);
  std::vector<uint8_t> free(120, 1);
  FrontalCholesky cholesky(system.rows, free);
  CHECK(!cholesky.factor(free));
  free[bad] = 0;
  checkSolution(system, cholesky, free, random);
}
