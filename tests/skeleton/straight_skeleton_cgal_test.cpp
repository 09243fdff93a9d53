#include <memory>
#include <numeric>

#include "skeleton/shapes.h"
#include "skeleton/straight_skeleton.h"
#include "support/catch.h"
#include "support/polygons.h"

namespace marrow {
namespace {

using Kind = StraightSkeleton::Kind;

double distanceToLine(Vec2 p, Vec2 a, Vec2 b) { return cross(b - a, p - a) / distance(a, b); }

bool isTree(const StraightSkeleton& skeleton, size_t n) {
  if (skeleton.edges.size() - n != skeleton.nodes.size() - 1) return false;
  std::vector<uint32_t> root(skeleton.nodes.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](uint32_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (size_t e = n; e < skeleton.edges.size(); ++e) {
    const uint32_t a = find(skeleton.edges[e].a), b = find(skeleton.edges[e].b);
    if (a == b) return false;
    root[a] = b;
  }
  return true;
}

void check(const std::vector<Vec2>& polygon) {
  const auto result = straightSkeletonByCgal(polygon);
  REQUIRE(result);
  const size_t n = polygon.size();
  CHECK(result->method == StraightSkeleton::Method::cgal);
  CHECK(isTree(*result, n));
  double size = 0;
  for (const Vec2 p : polygon) size = std::max(size, distance(p, polygon[0]));
  double error = 0;
  for (size_t e = 0; e < result->edges.size(); ++e) {
    const auto& edge = result->edges[e];
    if (e < n) {
      CHECK((edge.a == e && edge.b == (e + 1) % n && edge.kind == Kind::border));
      continue;
    }
    CHECK(edge.kind == (edge.a < n || edge.b < n ? Kind::peripheral : Kind::skeleton));
    for (const uint32_t node : {edge.a, edge.b}) {
      for (const uint32_t face : {edge.left, edge.right}) {
        const double away =
            distanceToLine(result->nodes[node], polygon[face], polygon[(face + 1) % n]);
        error = std::max(error, std::abs(away - result->times[node]));
      }
    }
  }
  CHECK(error < 1e-6 * size);

  // With every arc's left face on its left, each face is a counter-clockwise ring.
  std::vector<double> areas(n);
  std::vector<Vec2> gaps(n);
  const auto walk = [&](uint32_t face, Vec2 from, Vec2 to) {
    areas[face] += cross(from - polygon[face], to - polygon[face]) / 2;
    gaps[face] = gaps[face] + to - from;
  };
  for (size_t e = 0; e < result->edges.size(); ++e) {
    const auto& edge = result->edges[e];
    walk(edge.left, result->nodes[edge.a], result->nodes[edge.b]);
    if (e >= n) walk(edge.right, result->nodes[edge.b], result->nodes[edge.a]);
  }
  for (size_t i = 0; i < n; ++i) {
    CHECK(areas[i] > 0);
    CHECK(length(gaps[i]) < 1e-9 * size);
  }
  CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == Approx(signedArea(polygon)));
}

}  // namespace

TEST_CASE("straightSkeletonByCgal: a tree whose nodes are as far from their faces as they say",
          "[straight_skeleton][cgal]") {
  for (const auto& shape : shapes::named()) {
    INFO(shape.name);
    check(shape.polygon);
  }
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    INFO("random polygon " << i);
    const auto polygon = shapes::random(random);
    check(polygon);
    check(shapes::scaled(polygon, 1e4));
    check(shapes::scaled(polygon, 1e-4));
  }
}

TEST_CASE("straightSkeletonByCgal: the nodes of one event are one node",
          "[straight_skeleton][cgal]") {
  for (int n : {4, 5, 6, 8, 16}) {
    const auto skeleton = straightSkeletonByCgal(shapes::regular(n));
    REQUIRE(skeleton);
    INFO(n);
    CHECK(skeleton->nodes.size() == static_cast<size_t>(n + 1));
  }
  const auto rectangle = straightSkeletonByCgal(shapes::rectangle(200, 60));
  REQUIRE(rectangle);
  CHECK(rectangle->nodes.size() == 6);
  CHECK(rectangle->edges.size() == 9);
}

TEST_CASE("straightSkeletonByCgal: 2n - 3 arcs in general position", "[straight_skeleton][cgal]") {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const auto polygon = shapes::randomRadial(random, 4 + i);
    const auto skeleton = straightSkeletonByCgal(polygon);
    REQUIRE(skeleton);
    CHECK(skeleton->edges.size() - polygon.size() == 2 * polygon.size() - 3);
  }
}

TEST_CASE(
    "straightSkeletonByCgal: the same polygon gives the same skeleton, whatever memory it gets",
    "[straight_skeleton][cgal]") {
  const auto families = polygonFamilies(2, 1020);
  std::vector<std::unique_ptr<char[]>> holes;  // the heap is another one each time
  for (size_t i = 980; i < families.size(); ++i) {
    INFO(families[i].name);
    const auto& polygon = families[i].exact.empty() ? families[i].points : families[i].exact;
    const auto first = straightSkeletonByCgal(polygon);
    REQUIRE(first);
    for (size_t again = 0; again < 4; ++again) {
      holes.push_back(std::make_unique<char[]>(100 + 40 * again));
      const auto other = straightSkeletonByCgal(polygon);
      REQUIRE(other);
      CHECK(other->times == first->times);
      CHECK(std::equal(other->edges.begin(), other->edges.end(), first->edges.begin(),
                       first->edges.end(), [](const auto& a, const auto& b) {
                         return a.a == b.a && a.b == b.b && a.left == b.left && a.right == b.right;
                       }));
    }
  }
}

TEST_CASE("straightSkeletonByCgal: what is not a polygon is an error, not an exception",
          "[straight_skeleton][cgal]") {
  const double nan = std::nan("");
  CHECK(straightSkeletonByCgal({}).status() == Status::tooFewPoints);
  CHECK(straightSkeletonByCgal({{0, 0}, {1, 0}}).status() == Status::tooFewPoints);
  CHECK(straightSkeletonByCgal({{0, 0}, {1, nan}, {0, 1}}).status() == Status::notAPolygon);
  CHECK(straightSkeletonByCgal({{0, 0}, {0, 1}, {1, 0}}).status() == Status::notAPolygon);
  CHECK(straightSkeletonByCgal({{0, 0}, {9, 0}, {1, 1}, {9, 9}, {4, -5}}).status() ==
        Status::notAPolygon);
}

}  // namespace marrow
