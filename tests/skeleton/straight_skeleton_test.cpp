#include "skeleton/straight_skeleton.h"

#include <algorithm>
#include <limits>

#include "support/catch.h"
#include "support/polygons.h"
#include "support/skeletons.h"

using namespace marrow;

namespace {

double maxTime(const StraightSkeleton& skeleton) {
  return *std::max_element(skeleton.times.begin(), skeleton.times.end());
}

size_t innerNodes(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton) {
  return skeleton.nodes.size() - polygon.size();
}

StraightSkeleton byWavefront(const std::vector<Vec2>& polygon) {
  auto skeleton = straightSkeletonByWavefront(polygon);
  REQUIRE(skeleton);
  return *skeleton;
}

/// The same skeleton for a polygon that begins `shift` vertices later.
StraightSkeleton rotatedStart(StraightSkeleton skeleton, size_t n, size_t shift) {
  const auto renumber = [&](uint32_t i) {
    return i < n ? static_cast<uint32_t>((i + n - shift) % n) : i;
  };
  std::rotate(skeleton.nodes.begin(), skeleton.nodes.begin() + static_cast<long>(shift),
              skeleton.nodes.begin() + static_cast<long>(n));
  for (auto& e : skeleton.edges) {
    e = {renumber(e.a), renumber(e.b), e.kind, renumber(e.left), renumber(e.right)};
  }
  return skeleton;
}

}  // namespace

TEST_CASE("straight skeleton: in general position it has CGAL's nodes and arcs", "[skeleton]") {
  int compared = 0;
  for (const auto& family : polygonFamilies(1, 2200)) {
    if (family.degenerate) continue;
    const auto ours = straightSkeletonByWavefront(family.points);
    const auto theirs = straightSkeletonByCgal(family.points);
    INFO(family.name);
    REQUIRE(theirs);
    if (!ours) continue;  // the share of these has a test of its own
    const double tolerance = 1e-6 * sizeOf(family.points);
    CHECK(missingFrom(*ours, *theirs, family.points.size(), tolerance) == "");
    CHECK(missingFrom(*theirs, *ours, family.points.size(), tolerance) == "");
    ++compared;
  }
  CHECK(compared > 600);
}

TEST_CASE("straight skeleton: with hundreds of vertices, too, it has CGAL's nodes and arcs",
          "[skeleton]") {
  Random random(11);
  for (int i = 0; i < 24; ++i) {
    const int n = 90 + random.below(200);
    const std::vector<std::vector<Vec2>> polygons{
        randomStar(random, n, 0.7), randomStar(random, n, 0.2), randomBlob(random, n),
        jittered(random, spiralBand(n / 2, 2, 2.5), 0.01),
        jittered(random, symmetricStar(random, n / 6, 6), 0.01)};
    const auto& polygon = polygons[static_cast<size_t>(i) % polygons.size()];
    if (!isSimple(polygon)) continue;
    const auto ours = straightSkeletonByWavefront(polygon);
    const auto theirs = straightSkeletonByCgal(polygon);
    INFO(i);
    REQUIRE(ours);
    REQUIRE(theirs);
    const double tolerance = 1e-6 * sizeOf(polygon);
    CHECK(missingFrom(*ours, *theirs, polygon.size(), tolerance) == "");
    CHECK(missingFrom(*theirs, *ours, polygon.size(), tolerance) == "");
  }
}

TEST_CASE("straight skeleton: in degenerate positions it has CGAL's offset polygons",
          "[skeleton]") {
  int compared = 0;
  for (const auto& family : polygonFamilies(2, 2200)) {
    if (!family.degenerate) continue;
    const auto ours = straightSkeletonByWavefront(family.points);
    auto theirs = straightSkeletonByCgal(family.exact);
    INFO(family.name);
    REQUIRE(theirs);
    if (!ours) continue;
    theirs->nodes = turned(theirs->nodes, family.turn_rad);
    const double tolerance = 1e-6 * sizeOf(family.points), last = maxTime(*theirs);
    for (int k = 0; k < 10; ++k) {
      const double t = last * (0.03137 + 0.0957 * k);
      CHECK(sameOffset(family.points, *ours, *theirs, t, tolerance));
    }
    ++compared;
  }
  CHECK(compared > 1200);
}

TEST_CASE("straight skeleton: fewer than one polygon in two hundred needs the fallback",
          "[skeleton]") {
  const auto families = polygonFamilies(3, 6000);
  size_t failed = 0;
  for (const auto& family : families) {
    if (!straightSkeletonByWavefront(family.points)) {
      ++failed;
      UNSCOPED_INFO(family.name);
    }
    const auto skeleton = straightSkeleton(family.points);
    REQUIRE(skeleton);
    if (!skeleton) continue;
    CHECK(inconsistency(family.points, *skeleton) == "");
  }
  CHECK(failed * 200 < families.size());
}

TEST_CASE("straight skeleton: a triangle's inner node is its incentre", "[skeleton]") {
  const std::vector<Vec2> triangle{{0, 0}, {4, 0}, {0, 3}};
  const auto skeleton = byWavefront(triangle);
  REQUIRE(innerNodes(triangle, skeleton) == 1);
  CHECK(distance(skeleton.nodes[3], {1, 1}) < 1e-12);
  CHECK(skeleton.times[3] == Approx(1));
}

TEST_CASE("straight skeleton: all arcs of a regular polygon meet in one node", "[skeleton]") {
  for (const int n : {3, 4, 5, 6, 7, 12, 64, 360, 1000}) {
    const auto polygon = regularPolygon(n, 100, 0.3);
    const auto skeleton = byWavefront(polygon);
    CHECK(innerNodes(polygon, skeleton) == 1);
    CHECK(skeleton.edges.size() == 2 * polygon.size());
    CHECK(skeleton.times.back() == Approx(100 * std::cos(kPi / n)));
  }
}

TEST_CASE("straight skeleton: a rectangle has a ridge between two nodes", "[skeleton]") {
  // d-----------c
  // | >-------< |
  // a-----------b
  for (const double turn : {0.0, 0.4, 1.0, 2.5}) {
    const auto polygon = turned({{0, 0}, {10, 0}, {10, 4}, {0, 4}}, turn);
    const auto skeleton = byWavefront(polygon);
    REQUIRE(innerNodes(polygon, skeleton) == 2);
    CHECK(skeleton.times[4] == Approx(2));
    CHECK(skeleton.times[5] == Approx(2));
    CHECK(distance(skeleton.nodes[4], skeleton.nodes[5]) == Approx(6));
    const auto& ridge = *std::find_if(skeleton.edges.begin(), skeleton.edges.end(), [](auto& e) {
      return e.kind == StraightSkeleton::Kind::skeleton;
    });
    CHECK(std::min(ridge.left, ridge.right) == 0);
    CHECK(std::max(ridge.left, ridge.right) == 2);
  }
}

TEST_CASE("straight skeleton: in general position an n-gon has 2n - 3 arcs", "[skeleton]") {
  for (const auto& family : polygonFamilies(4, 400)) {
    if (family.degenerate || family.name.find("thin") == 0) continue;
    const auto skeleton = straightSkeleton(family.points);
    REQUIRE(skeleton);
    INFO(family.name);
    CHECK(skeleton->edges.size() - family.points.size() == 2 * family.points.size() - 3);
  }
}

TEST_CASE("straight skeleton: no node is nearer to the outline than its time", "[skeleton]") {
  for (const auto& family : polygonFamilies(5, 600)) {
    const auto skeleton = straightSkeleton(family.points);
    REQUIRE(skeleton);
    const double tolerance = 1e-9 * sizeOf(family.points);
    for (size_t i = family.points.size(); i < skeleton->nodes.size(); ++i) {
      INFO(family.name);
      // Beside a reflex corner the outline may be farther away than the edges' lines, not nearer.
      CHECK(distanceToBorder(family.points, skeleton->nodes[i]) > skeleton->times[i] - tolerance);
      CHECK(contains(family.points, skeleton->nodes[i]));
    }
  }
}

TEST_CASE("straight skeleton: turning, mirroring and scaling the polygon does so to the skeleton",
          "[skeleton]") {
  for (const auto& family : polygonFamilies(6, 500)) {
    if (family.degenerate) continue;
    INFO(family.name);
    const size_t n = family.points.size();
    const auto base = byWavefront(family.points);
    const double size = sizeOf(family.points);

    auto expected = base;
    expected.nodes = turned(base.nodes, 1.1);
    auto other = byWavefront(turned(family.points, 1.1));
    CHECK(missingFrom(expected, other, n, 1e-6 * size) == "");

    for (const double factor : {1e4, 1e-4, 3e-7, 1e9}) {
      expected = base;
      expected.nodes = scaled(base.nodes, factor);
      for (double& t : expected.times) t *= factor;
      other = byWavefront(scaled(family.points, factor));
      CHECK(missingFrom(expected, other, n, 1e-6 * size * factor) == "");
    }

    auto shifted = family.points;
    std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
    CHECK(missingFrom(rotatedStart(base, n, 1), byWavefront(shifted), n, 1e-6 * size) == "");

    // Mirrored and reversed: vertex i becomes n - 1 - i, edge i becomes n - 2 - i.
    expected = base;
    for (Vec2& p : expected.nodes) p.x = -p.x;
    std::reverse(expected.nodes.begin(), expected.nodes.begin() + static_cast<long>(n));
    const auto vertex = [&](uint32_t i) { return i < n ? static_cast<uint32_t>(n - 1 - i) : i; };
    const auto edge = [&](uint32_t i) { return static_cast<uint32_t>((2 * n - 2 - i) % n); };
    for (auto& e : expected.edges)
      e = {vertex(e.a), vertex(e.b), e.kind, edge(e.right), edge(e.left)};
    other = byWavefront(mirrored(family.points));
    CHECK(missingFrom(expected, other, n, 1e-6 * size) == "");
  }
}

TEST_CASE("straight skeleton: turning a symmetric polygon keeps its vertex events together",
          "[skeleton]") {
  for (const auto& family : polygonFamilies(7, 1200)) {
    if (family.turn_rad == 0) continue;
    INFO(family.name);
    auto exact = straightSkeletonByWavefront(family.exact);
    const auto other = straightSkeletonByWavefront(family.points);
    REQUIRE(exact);
    REQUIRE(other);
    CHECK(exact->nodes.size() == other->nodes.size());
    exact->nodes = turned(exact->nodes, family.turn_rad);
    const double tolerance = 1e-6 * sizeOf(family.points);
    CHECK(missingFrom(*exact, *other, family.points.size(), tolerance) == "");
  }
}

TEST_CASE("straight skeleton: the same polygon gives the same bits", "[skeleton]") {
  for (const auto& family : polygonFamilies(8, 60)) {
    const auto a = byWavefront(family.points), b = byWavefront(family.points);
    REQUIRE(a.nodes.size() == b.nodes.size());
    for (size_t i = 0; i < a.nodes.size(); ++i) CHECK(a.nodes[i] == b.nodes[i]);
    CHECK(a.times == b.times);
  }
}

TEST_CASE("straight skeleton: what is not a simple polygon is refused", "[skeleton]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(straightSkeleton({}).status() == Status::tooFewPoints);
  CHECK(straightSkeleton({{0, 0}, {1, 0}}).status() == Status::tooFewPoints);
  const std::vector<std::vector<Vec2>> bad{
      {{0, 0}, {0, 1}, {1, 0}},          // clockwise
      {{0, 0}, {1, 1}, {1, 0}, {0, 1}},  // crosses itself
      {{0, 0}, {1, 0}, {2, 0}},          // no area
      {{0, 0}, {1, 0}, {1, 0}, {1, 1}},  // a repeated vertex
      {{0, 0}, {0, 0}, {0, 0}},          // a point
      {{0, 0}, {nan, 0}, {1, 1}},
      {{0, 0}, {1, 0}, {1, std::numeric_limits<double>::infinity()}},
  };
  for (size_t i = 0; i < bad.size(); ++i) {
    INFO(i);
    CHECK_FALSE(straightSkeleton(bad[i]));
    CHECK_FALSE(straightSkeletonByWavefront(bad[i]));
  }
}

TEST_CASE("straight skeleton: the self-check finds every single fault put in", "[skeleton]") {
  Random random(9);
  const auto polygon = randomStar(random, 30, 0.7);
  const auto good = byWavefront(polygon);
  const size_t n = polygon.size();
  REQUIRE(inconsistency(polygon, good) == "");
  for (size_t i = n; i < good.nodes.size(); ++i) {
    auto bad = good;
    bad.nodes[i] = bad.nodes[i] + Vec2{0.01, 0.02};
    CHECK(inconsistency(polygon, bad) != "");
    bad = good;
    bad.times[i] += 0.01;
    CHECK(inconsistency(polygon, bad) != "");
  }
  for (size_t i = n; i < good.edges.size(); ++i) {
    auto bad = good;
    bad.edges.erase(bad.edges.begin() + static_cast<long>(i));
    CHECK(inconsistency(polygon, bad) != "");
    bad = good;
    bad.edges[i].left = (bad.edges[i].left + 1) % static_cast<uint32_t>(n);
    CHECK(inconsistency(polygon, bad) != "");
    bad = good;
    std::swap(bad.edges[i].left, bad.edges[i].right);
    CHECK(inconsistency(polygon, bad) != "");
    bad = good;
    bad.edges[i].b = static_cast<uint32_t>(good.nodes.size());
    CHECK(inconsistency(polygon, bad) != "");
  }
}

TEST_CASE("straight skeleton: long and hard polygons come out of the wavefront", "[skeleton]") {
  Random random(10);
  for (const int n : {500, 1000, 2000}) {
    for (const auto& polygon : {randomStar(random, n, 0.6), randomBlob(random, n),
                                spiralBand(n / 2, 6, 3), symmetricStar(random, n / 10, 10)}) {
      const auto skeleton = straightSkeleton(polygon);
      REQUIRE(skeleton);
      CHECK(skeleton->method == StraightSkeleton::Method::wavefront);
    }
  }
}

TEST_CASE("straight skeleton: edges that a closing slit sets free are met by other vertices",
          "[skeleton]") {
  int count = 0;
  for (int arms = 60; arms <= 500; arms += 4) {
    for (const double inner : {60.0, 75.0, 80.0}) {
      const auto polygon = latticeStar(arms, inner, 100);
      if (!isSimple(polygon) || signedArea(polygon) <= 0) continue;
      INFO(arms << " arms from " << inner);
      CHECK(straightSkeletonByWavefront(polygon));
      ++count;
    }
  }
  CHECK(count > 100);
}
