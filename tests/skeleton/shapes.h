// Families of simple, counter-clockwise polygons for the tests of the skeleton's stages.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/vec.h"
#include "sketch/polygon.h"
#include "support/random.h"

namespace marrow::shapes {

using Polygon = std::vector<Vec2>;

constexpr double kPi = 3.14159265358979323846;

inline Vec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

inline Polygon regular(int n, double radius = 100) {
  Polygon polygon;
  for (int i = 0; i < n; ++i) polygon.push_back(polar(radius, 2 * kPi * i / n));
  return polygon;
}

inline Polygon rectangle(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

inline Polygon star(int arms, double inner, double outer) {
  Polygon polygon;
  for (int i = 0; i < 2 * arms; ++i) {
    polygon.push_back(polar(i % 2 ? inner : outer, kPi * i / arms));
  }
  return polygon;
}

/// A tube of half width `radius` about a polyline, ends rounded with `cap` edges; radii may vary.
inline Polygon tube(const Polygon& spine, const std::vector<double>& radii, int cap = 6) {
  Polygon polygon;
  const int n = static_cast<int>(spine.size());
  const auto side = [&](int from, int to, int step) {
    for (int i = from; i != to; i += step) {
      const Vec2 before = i == (step > 0 ? 0 : n - 1) ? spine[i] : spine[i - step];
      const Vec2 after = i == (step > 0 ? n - 1 : 0) ? spine[i] : spine[i + step];
      const Vec2 along = after - before;
      const Vec2 right = -perpendicular(along) / length(along);
      polygon.push_back(spine[i] + right * radii[i]);
    }
  };
  const auto end = [&](int i, Vec2 direction) {
    const Vec2 right = -perpendicular(direction) / length(direction);
    const Vec2 ahead = direction / length(direction);
    for (int k = 1; k < cap; ++k) {
      const double angle = kPi * k / cap;
      polygon.push_back(spine[i] + (right * std::cos(angle) + ahead * std::sin(angle)) * radii[i]);
    }
  };
  side(0, n, 1);
  end(n - 1, spine[n - 1] - spine[n - 2]);
  side(n - 1, -1, -1);
  end(0, spine[0] - spine[1]);
  return polygon;
}

inline Polygon sausage(double half_length, double radius, int cap = 6) {
  return tube({{-half_length, 0}, {half_length, 0}}, {radius, radius}, cap);
}

/// A tube wound `turns` times about the origin.
inline Polygon spiral(double turns, double pitch, double radius) {
  Polygon spine;
  const int steps = static_cast<int>(turns * 16);
  for (int i = 0; i <= steps; ++i) {
    const double turn = 0.6 + turns * i / steps;
    spine.push_back(polar(pitch * turn, 2 * kPi * turn));
  }
  return tube(spine, std::vector<double>(spine.size(), radius));
}

inline Polygon comb(int teeth, double width, double gap, double depth) {
  const double pitch = width + gap, right = teeth * pitch - gap;
  Polygon polygon{{0, -width}, {right, -width}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = i * pitch;
    polygon.push_back({x + width, depth});
    polygon.push_back({x, depth});
    if (i > 0) {
      polygon.push_back({x, 0});
      polygon.push_back({x - gap, 0});
    }
  }
  return polygon;
}

/// A palm with `fingers` long round-tipped fingers.
inline Polygon hand(int fingers) {
  Polygon polygon{{-10, -60}, {fingers * 40.0 + 10, -60}};
  for (int i = fingers - 1; i >= 0; --i) {
    const double x = i * 40.0 + 20, tip = 150 + 10.0 * (i % 3);
    for (int k = 0; k <= 6; ++k) {
      polygon.push_back(Vec2{x, tip} + polar(14, kPi * k / 6));
    }
    if (i > 0) {
      polygon.push_back({x - 16, 62});
      polygon.push_back({x - 24, 62});
    }
  }
  polygon.push_back({-10, 60});
  polygon.push_back({-30, 0});
  return polygon;
}

/// Star-shaped about the origin with random radii.
inline Polygon randomRadial(Random& random, int n, double low = 0.3) {
  Polygon polygon;
  for (int i = 0; i < n; ++i) {
    polygon.push_back(
        polar(random.between(100 * low, 100), 2 * kPi * (i + random.between(-0.4, 0.4)) / n));
  }
  return polygon;
}

/// A creeping limb: a tube about a random smooth walk; may cross itself, so check isSimple.
inline Polygon randomTube(Random& random, int steps) {
  Polygon spine{{0, 0}};
  std::vector<double> radii{random.between(5, 25)};
  double heading = 0, bend = 0;
  for (int i = 0; i < steps; ++i) {
    bend = 0.5 * bend + random.between(-0.35, 0.35);
    heading += bend;
    spine.push_back(spine.back() + polar(30, heading));
    radii.push_back(std::clamp(radii.back() * random.between(0.7, 1.4), 4.0, 28.0));
  }
  return tube(spine, radii);
}

/// A random polygon of n vertices, uncrossed by 2-opt moves.
inline Polygon randomUncrossed(Random& random, int n) {
  Polygon p;
  for (int i = 0; i < n; ++i) p.push_back({random.between(0, 100), random.between(0, 100)});
  const auto at = [&](int i) { return p[i % n]; };
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 0; i < n; ++i) {
      for (int j = i + 2; j < n; ++j) {
        if (distance(at(i), at(j)) + distance(at(i + 1), at(j + 1)) <
            distance(at(i), at(i + 1)) + distance(at(j), at(j + 1)) - 1e-9) {
          std::reverse(p.begin() + i + 1, p.begin() + j + 1);
          changed = true;
        }
      }
    }
  }
  if (signedArea(p) < 0) std::reverse(p.begin(), p.end());
  return p;
}

struct Named {
  std::string name;
  Polygon polygon;
};

inline std::vector<Named> named() {
  std::vector<Named> shapes;
  for (int n : {3, 4, 5, 6, 8, 12, 16, 32, 33}) {
    shapes.push_back({"regular " + std::to_string(n), regular(n)});
  }
  for (int n : {3, 4, 5, 6, 9}) {
    shapes.push_back({"star " + std::to_string(n), star(n, 30, 100)});
  }
  shapes.push_back({"rectangle", rectangle(200, 60)});
  shapes.push_back({"sliver", rectangle(1000, 0.5)});
  shapes.push_back({"scalene triangle", {{0, 0}, {150, 10}, {40, 80}}});
  shapes.push_back({"needle", {{0, 0}, {300, 0}, {299, 2}}});
  shapes.push_back({"L", {{0, 0}, {120, 0}, {120, 40}, {40, 40}, {40, 150}, {0, 150}}});
  shapes.push_back(
      {"T", {{0, 0}, {30, 0}, {30, 100}, {90, 100}, {90, 130}, {-60, 130}, {-60, 100}, {0, 100}}});
  shapes.push_back({"plus",
                    {{-20, -80},
                     {20, -80},
                     {20, -20},
                     {80, -20},
                     {80, 20},
                     {20, 20},
                     {20, 80},
                     {-20, 80},
                     {-20, 20},
                     {-80, 20},
                     {-80, -20},
                     {-20, -20}}});
  shapes.push_back({"sausage", sausage(100, 25)});
  shapes.push_back({"thin sausage", sausage(100, 3)});
  shapes.push_back({"spiral", spiral(3, 60, 18)});
  shapes.push_back({"comb", comb(6, 20, 15, 100)});
  shapes.push_back({"hand", hand(5)});
  shapes.push_back({"dumbbell", tube({{-100, 0}, {-60, 0}, {-20, 0}, {20, 0}, {60, 0}, {100, 0}},
                                     {40, 35, 8, 8, 35, 40})});
  return shapes;
}

/// One of many kinds, always simple and counter-clockwise.
inline Polygon random(Random& random) {
  for (;;) {
    Polygon polygon;
    switch (random.below(4)) {
      case 0:
        polygon = randomRadial(random, 3 + random.below(40));
        break;
      case 1:
        polygon = randomTube(random, 2 + random.below(12));
        break;
      case 2:
        polygon = randomUncrossed(random, 3 + random.below(40));
        break;
      default:
        polygon = randomRadial(random, 3 + random.below(60), 0.9);
        break;
    }
    if (signedArea(polygon) > 0 && isSimple(polygon)) return polygon;
  }
}

inline Polygon mirrored(Polygon polygon) {
  for (Vec2& p : polygon) p.x = -p.x;
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

inline Polygon scaled(Polygon polygon, double factor) {
  for (Vec2& p : polygon) p = p * factor;
  return polygon;
}

inline Polygon turned(Polygon polygon, double angle) {
  const Vec2 axis = polar(1, angle);
  for (Vec2& p : polygon) p = {p.x * axis.x - p.y * axis.y, p.x * axis.y + p.y * axis.x};
  return polygon;
}

/// The same polygon with another first vertex.
inline Polygon renumbered(Polygon polygon, size_t first) {
  std::rotate(polygon.begin(), polygon.begin() + first % polygon.size(), polygon.end());
  return polygon;
}

}  // namespace marrow::shapes
