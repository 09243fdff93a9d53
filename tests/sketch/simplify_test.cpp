#include "sketch/simplify.h"

#include <algorithm>
#include <set>

#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::Stroke;

namespace {

Stroke pick(const Stroke& polygon, const std::vector<uint32_t>& indices) {
  Stroke picked;
  for (const uint32_t i : indices) picked.push_back(polygon[i]);
  return picked;
}

}  // namespace

TEST_CASE("simplify: no vertex is farther than the tolerance from what replaces it", "[simplify]") {
  for (const auto& shape : strokes::plainShapes()) {
    for (const double tolerance : {0.0, 0.1, 1.0, 4.0}) {
      CAPTURE(shape.name, tolerance);
      const Stroke simple = pick(shape.points, simplify(shape.points, tolerance));
      for (const Vec2& p : shape.points) REQUIRE(distanceToBorder(simple, p) <= tolerance + 1e-12);
    }
  }
}

TEST_CASE("simplify: a simple polygon stays simple, whatever the tolerance", "[simplify]") {
  for (const auto& shape : strokes::plainShapes()) {
    for (const double tolerance : {0.5, 3.0, 12.0, 60.0, 1000.0}) {
      CAPTURE(shape.name, tolerance);
      const auto indices = simplify(shape.points, tolerance);
      REQUIRE(indices.size() >= 3);
      REQUIRE(isSimple(pick(shape.points, indices)));
    }
  }
}

TEST_CASE("simplify: keeps a rectangle's corners and nothing else", "[simplify]") {
  const Stroke sampled = strokes::rotated(strokes::sampled(strokes::rectangle(300, 200), 3), 0.3);
  const Stroke corners = strokes::rotated(strokes::rectangle(300, 200), 0.3);
  for (size_t start = 0; start < sampled.size(); start += 17) {
    const Stroke stroke = strokes::startedAt(sampled, start);
    const Stroke simple = pick(stroke, simplify(stroke, 0.5));
    REQUIRE(simple.size() == 4);
    for (const Vec2& c : corners) REQUIRE(distanceToBorder(simple, c) < 1e-9);
  }
}

TEST_CASE("simplify: does not depend on the first vertex or the direction", "[simplify]") {
  Random random(6);
  for (int i = 0; i < 40; ++i) {
    const Stroke blob = strokes::blob(random, 150);
    const auto places = [&](const Stroke& stroke) {
      std::set<std::pair<double, double>> set;
      for (const Vec2& p : pick(stroke, simplify(stroke, 1.5))) set.insert({p.x, p.y});
      return set;
    };
    const auto expected = places(blob);
    REQUIRE(places(strokes::reversed(blob)) == expected);
    REQUIRE(places(strokes::startedAt(blob, 31)) == expected);
    REQUIRE(places(strokes::startedAt(strokes::reversed(blob), 77)) == expected);
  }
}
