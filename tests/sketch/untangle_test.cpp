#include "sketch/untangle.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::Stroke;

namespace {

/// Moved so that all coordinates are whole and not negative.
Stroke onLattice(Stroke stroke, double scale) {
  double x = 0, y = 0;
  for (Vec2& p : stroke) {
    p = {std::floor(p.x * scale + 0.5), std::floor(p.y * scale + 0.5)};
    x = std::min(x, p.x);
    y = std::min(y, p.y);
  }
  return strokes::translated(stroke, {-x, -y});
}

double pieceArea(const Stroke& stroke) { return signedArea(*outerBoundary(stroke)); }

int windingNumber(const Stroke& curve, Vec2 point) {
  int turns = 0;
  for (size_t i = 0; i < curve.size(); ++i) {
    const Vec2 a = curve[i], b = curve[(i + 1) % curve.size()];
    if ((a.y <= point.y) == (b.y <= point.y)) continue;
    const double side = cross(b - a, point - a);
    if (b.y > a.y && side > 0) ++turns;
    if (b.y < a.y && side < 0) --turns;
  }
  return turns;
}

/// A picture of the plane: cells near the curve are walls, and the sea comes in from the border.
class Flood {
 public:
  Flood(const Stroke& curve, double size) : cell_(size / (kCells - 6)), state_(kCells * kCells, 0) {
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        if (distanceToBorder(curve, center(x, y)) < 0.75 * cell_) at(x, y) = kWall;
      }
    }
    fill(0, 0, kSea);
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        if (at(x, y) != 0) continue;
        const double area = fill(x, y, kLake) * cell_ * cell_;
        if (windingNumber(curve, center(x, y)) != 0) largest_ = std::max(largest_, area);
      }
    }
  }

  /// Of the faces that the curve winds around, the largest, seen coarsely from inside.
  double largestFace() const { return largest_; }

  bool anySeaIn(const Stroke& polygon) const {
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        if (state_[static_cast<size_t>(y * kCells + x)] == kSea && contains(polygon, center(x, y)))
          return true;
      }
    }
    return false;
  }

 private:
  static constexpr int kCells = 64;
  enum State { kWall = 1, kSea, kLake };

  Vec2 center(int x, int y) const { return {(x - 2.5) * cell_, (y - 2.5) * cell_}; }
  int& at(int x, int y) { return state_[static_cast<size_t>(y * kCells + x)]; }

  int fill(int x, int y, State state) {
    std::vector<int> open{y * kCells + x};
    at(x, y) = state;
    int count = 0;
    while (!open.empty()) {
      const int here = open.back();
      open.pop_back();
      ++count;
      const int dx[] = {1, -1, 0, 0}, dy[] = {0, 0, 1, -1};
      for (int d = 0; d < 4; ++d) {
        const int nx = here % kCells + dx[d], ny = here / kCells + dy[d];
        if (nx < 0 || ny < 0 || nx >= kCells || ny >= kCells || at(nx, ny) != 0) continue;
        at(nx, ny) = state;
        open.push_back(ny * kCells + nx);
      }
    }
    return count;
  }

  double cell_;
  std::vector<int> state_;
  double largest_ = 0;
};

}  // namespace

TEST_CASE("untangle: a figure eight leaves its larger loop", "[untangle]") {
  //  a bow tie with one wing twice as long
  const Stroke bow{{0, 0}, {0, 4}, {12, 0}, {12, 4}};
  const Stroke wide{{4, 0}, {4, 4}, {0, 0}, {0, 4}, {12, 12}, {12, 0}};
  REQUIRE(pieceArea(bow) == Approx(12));
  REQUIRE(outerBoundary(bow)->size() == 3);
  REQUIRE(pieceArea(wide) == pieceArea(strokes::reversed(wide)));
}

TEST_CASE("untangle: what is drawn forth and back encloses nothing", "[untangle]") {
  REQUIRE(outerBoundary({{0, 0}, {5, 3}, {9, 1}, {5, 3}})->empty());
  REQUIRE(outerBoundary({{0, 0}, {4, 4}, {2, 2}, {8, 8}, {1, 1}})->empty());
  REQUIRE(outerBoundary({{3, 3}})->empty());
}

TEST_CASE("untangle: strings, bridges and repeated rounds are cut off", "[untangle]") {
  //   a square on a string, another square at the string's other end
  const Stroke square{{10, 10}, {14, 10}, {14, 14}, {10, 14}};
  Stroke string{{0, 0}, {5, 5}};
  Stroke dumbbell = string;
  dumbbell.insert(dumbbell.end(), square.begin(), square.end());
  dumbbell.push_back({10, 10});
  dumbbell.push_back({5, 5});
  dumbbell.push_back({0, 0});
  REQUIRE(*outerBoundary(dumbbell) == square);
  for (const Vec2 p : {Vec2{2, 0}, Vec2{2, 2}, Vec2{0, 2}}) dumbbell.push_back(p);
  REQUIRE(*outerBoundary(dumbbell) == square);

  Stroke twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  REQUIRE(*outerBoundary(twice) == square);
  Stroke there_and_back = square;
  there_and_back.push_back(square[0]);
  there_and_back.insert(there_and_back.end(), square.rbegin(), square.rend());
  REQUIRE(*outerBoundary(there_and_back) == square);
}

TEST_CASE("untangle: a simple polygon comes back as it is", "[untangle]") {
  for (const auto& shape : strokes::plainShapes()) {
    CAPTURE(shape.name);
    const Stroke lattice = onLattice(shape.points, 1000);
    if (!isSimple(lattice)) continue;
    const Stroke outer = *outerBoundary(lattice);
    REQUIRE(outer.size() == lattice.size());
    REQUIRE(signedArea(outer) == Approx(std::fabs(signedArea(lattice))));
  }
}

TEST_CASE("untangle: turning and mirroring the lattice, reversing and restarting keep the area",
          "[untangle]") {
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const int side = 2 + random.below(14), samples = 3 + random.below(40);
    Stroke stroke = i % 2 ? strokes::latticeWalk(random, samples, side)
                          : strokes::latticeSteps(random, 3 * samples);
    const double scale = i % 3 == 0 ? 1 : (i % 3 == 1 ? 1 << 20 : 999983);
    stroke = onLattice(stroke, scale);
    if (i % 5 == 0) {  // nearly overlapping edges
      for (Vec2& p : stroke) p = p + Vec2{1.0 * random.below(3), 1.0 * random.below(3)};
    }
    double size = 0;
    for (const Vec2& p : stroke) size = std::max({size, p.x, p.y});
    CAPTURE(i, side, samples, scale);

    const double area = pieceArea(stroke);
    Stroke swapped = stroke, mirrored = stroke;
    for (Vec2& p : swapped) std::swap(p.x, p.y);
    for (Vec2& p : mirrored) p.y = size - p.y;
    const double error = 1e-9 * size * size;
    REQUIRE(std::fabs(pieceArea(swapped) - area) <= error);
    REQUIRE(std::fabs(pieceArea(mirrored) - area) <= error);
    REQUIRE(std::fabs(pieceArea(strokes::startedAt(strokes::reversed(stroke), 2)) - area) <= error);
    if (scale > 1 && i % 5 != 0 && area > 0) REQUIRE(isSimple(*outerBoundary(stroke)));
  }
}

TEST_CASE("untangle: nothing outside comes in, and no larger face is left out", "[untangle]") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    Stroke stroke;
    if (i % 3 == 0) stroke = strokes::latticeWalk(random, 4 + random.below(20), 3 + i % 9);
    if (i % 3 == 1) stroke = strokes::latticeSteps(random, 10 + random.below(60));
    if (i % 3 == 2) stroke = strokes::closedCurve(random, 60);
    stroke = onLattice(stroke, 10000);
    double size = 0;
    for (const Vec2& p : stroke) size = std::max({size, p.x, p.y});
    CAPTURE(i);

    const Flood flood(stroke, size);
    const Stroke outer = *outerBoundary(stroke);
    REQUIRE(signedArea(outer) >= flood.largestFace());
    REQUIRE_FALSE(flood.anySeaIn(outer));
  }
}

TEST_CASE("untangle: gives up when told to, never wrongly", "[untangle]") {
  Random random(5);
  const Stroke tangle = onLattice(strokes::jittered(random, Stroke(400), 300), 1000);
  REQUIRE_FALSE(outerBoundary(tangle, 10));
  REQUIRE(outerBoundary(tangle, 10000000));
}
