// Families of simple, counter-clockwise polygons, from general position to nothing but
// coincidences.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "sketch/polygon.h"
#include "support/random.h"

namespace marrow {

/// Where events coincide, a straight skeleton is not continuous: the rounding of a turn decides how
/// vertices that meet go on. The truth is then that of the polygon before the turn.
struct NamedPolygon {
  std::string name;
  std::vector<Vec2> points;
  bool degenerate = false;       // events coincide by construction
  std::vector<Vec2> exact = {};  // `points` without the rounding: before turning by turn_rad
  double turn_rad = 0;
};

inline constexpr double kPi = 3.14159265358979323846;

inline std::vector<Vec2> turned(std::vector<Vec2> points, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (Vec2& p : points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return points;
}

inline std::vector<Vec2> scaled(std::vector<Vec2> points, double factor) {
  for (Vec2& p : points) p = p * factor;
  return points;
}

inline std::vector<Vec2> moved(std::vector<Vec2> points, Vec2 by) {
  for (Vec2& p : points) p = p + by;
  return points;
}

/// Mirrored at the y axis, and still counter-clockwise.
inline std::vector<Vec2> mirrored(std::vector<Vec2> points) {
  for (Vec2& p : points) p.x = -p.x;
  std::reverse(points.begin(), points.end());
  return points;
}

inline std::vector<Vec2> regularPolygon(int n, double radius, double phase = 0) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double a = phase + 2 * kPi * i / n;
    points.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  return points;
}

/// Random radii around a centre.
inline std::vector<Vec2> randomStar(Random& random, int n, double roughness) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * (i + 0.8 * random.unit()) / n;
    const double r = 100 * (1 - roughness * random.unit());
    points.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return points;
}

/// A smooth closed curve around a centre, like a drawn blob with limbs.
inline std::vector<Vec2> randomBlob(Random& random, int n) {
  double amplitude[7], phase[7];
  for (int k = 1; k < 7; ++k) {
    amplitude[k] = random.between(0, 0.5) / k;
    phase[k] = random.between(0, 2 * kPi);
  }
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n;
    double r = 1;
    for (int k = 1; k < 7; ++k) r += amplitude[k] * std::sin(k * a + phase[k]);
    r = 100 * std::max(r, 0.15);
    points.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return points;
}

/// Random points, untangled by reversing stretches between crossing edges.
inline std::vector<Vec2> randomUntangled(Random& random, int n) {
  std::vector<Vec2> p;
  for (int i = 0; i < n; ++i) p.push_back({random.between(0, 100), random.between(0, 100)});
  const auto crosses = [&](Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
           cross(d - c, a - c) * cross(d - c, b - c) < 0;
  };
  for (bool again = true; again;) {
    again = false;
    for (int i = 0; i < n && !again; ++i) {
      for (int j = i + 2; j < n && !again; ++j) {
        if (i == 0 && j == n - 1) continue;
        if (!crosses(p[i], p[i + 1], p[j], p[(j + 1) % n])) continue;
        std::reverse(p.begin() + i + 1, p.begin() + j + 1);
        again = true;
      }
    }
  }
  if (signedArea(p) < 0) std::reverse(p.begin(), p.end());
  return p;
}

/// The outline of a random heap of squares without holes. Some corners are cut where `cut`, in the
/// proportion 3 : 4, so that all normals are exact.
inline std::vector<Vec2> randomPolyomino(Random& random, int cells, bool cut) {
  std::set<std::pair<int, int>> filled{{0, 0}};
  const int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
  const auto has = [&](int x, int y) { return filled.count({x, y}) > 0; };
  for (int tries = 0; static_cast<int>(filled.size()) < cells && tries < 60 * cells; ++tries) {
    auto it = filled.begin();
    std::advance(it, random.below(static_cast<int>(filled.size())));
    const int d = random.below(4);
    const int x = it->first + dx[d], y = it->second + dy[d];
    if (has(x, y)) continue;
    // Around the new cell, filled and empty must each be in one run: no holes, no pinched corners.
    const int rx[] = {1, 1, 0, -1, -1, -1, 0, 1}, ry[] = {0, 1, 1, 1, 0, -1, -1, -1};
    int changes = 0;
    for (int k = 0; k < 8; ++k) {
      changes += has(x + rx[k], y + ry[k]) != has(x + rx[(k + 1) % 8], y + ry[(k + 1) % 8]);
    }
    if (changes == 2) filled.insert({x, y});
  }
  // Walk around with the filled cells on the left.
  int x = filled.begin()->first, y = filled.begin()->second;  // lowest x, then y: its lower left
  const int sx = x, sy = y;
  int direction = 0;
  std::vector<Vec2> corners;
  const int ax[] = {0, -1, -1, 0}, ay[] = {0, 0, -1, -1};  // cell left of a step in `direction`
  do {
    const int left = direction;
    // Cell ahead on the left and on the right of the corner (x, y).
    const bool ahead_left = has(x + ax[left], y + ay[left]);
    const bool ahead_right = has(x + ax[(left + 3) % 4], y + ay[(left + 3) % 4]);
    int turn = 0;
    if (!ahead_left)
      turn = 1;
    else if (ahead_right)
      turn = 3;
    if (turn != 0) corners.push_back({static_cast<double>(x), static_cast<double>(y)});
    direction = (direction + turn) % 4;
    x += dx[direction];
    y += dy[direction];
  } while (x != sx || y != sy);
  if (!cut) return scaled(corners, 16);
  std::vector<Vec2> points;
  const size_t n = corners.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 p = corners[i], a = corners[(i + n - 1) % n], b = corners[(i + 1) % n];
    if (random.unit() < 0.5) {
      points.push_back(p);
    } else {
      points.push_back(p + (a - p) * (0.1875 / length(a - p)));
      points.push_back(p + (b - p) * (0.25 / length(b - p)));
    }
  }
  return scaled(points, 16);
}

/// A band of constant width along a spiral.
inline std::vector<Vec2> spiralBand(int n, double turns, double width) {
  std::vector<Vec2> outer, inner;
  for (int i = 0; i < n; ++i) {
    const double a = turns * 2 * kPi * i / (n - 1), r = 10 + 10 * a / (2 * kPi);
    outer.push_back({(r + width) * std::cos(a), (r + width) * std::sin(a)});
    inner.push_back({(r - width) * std::cos(a), (r - width) * std::sin(a)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

inline std::vector<Vec2> comb(int teeth, double depth) {
  std::vector<Vec2> points{{0, 0}, {2.0 * teeth - 1, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    points.push_back({2.0 * i + 1, depth + 1});
    points.push_back({2.0 * i, depth + 1});
    if (i > 0) {
      points.push_back({2.0 * i, 1});
      points.push_back({2.0 * i - 1, 1});
    }
  }
  return points;
}

/// The same random sector k times around: events of all sectors coincide.
inline std::vector<Vec2> symmetricStar(Random& random, int sectors, int per_sector) {
  std::vector<double> angle, radius;
  for (int i = 0; i < per_sector; ++i) {
    angle.push_back(2 * kPi / sectors * (i + 0.7 * random.unit()) / per_sector);
    radius.push_back(random.between(30, 100));
  }
  std::vector<Vec2> points;
  for (int k = 0; k < sectors; ++k) {
    for (int i = 0; i < per_sector; ++i) {
      const double a = angle[i] + 2 * kPi * k / sectors;
      points.push_back({radius[i] * std::cos(a), radius[i] * std::sin(a)});
    }
  }
  return points;
}

/// A star and its mirror image: reflex vertices meet on the axis.
inline std::vector<Vec2> mirrorStar(Random& random, int half) {
  std::vector<Vec2> points;
  for (int i = 0; i < half; ++i) {
    const double a = kPi * (i + 0.2 + 0.6 * random.unit()) / half;
    const double r = random.between(20, 100);
    points.push_back({r * std::sin(a), -r * std::cos(a)});
  }
  for (int i = half - 1; i >= 0; --i) points.push_back({-points[i].x, points[i].y});
  return points;
}

/// A star whose corners are rounded to whole numbers: slits with parallel sides, all in one heap.
inline std::vector<Vec2> latticeStar(int arms, double inner, double outer) {
  std::vector<Vec2> points;
  for (int i = 0; i < 2 * arms; ++i) {
    const double a = kPi * i / arms, r = i % 2 ? inner : outer;
    points.push_back({std::floor(r * std::cos(a) + 0.5), std::floor(r * std::sin(a) + 0.5)});
  }
  return points;
}

inline std::vector<Vec2> jittered(Random& random, std::vector<Vec2> points, double by) {
  for (Vec2& p : points) p = p + Vec2{random.between(-by, by), random.between(-by, by)};
  return points;
}

/// `count` polygons, all families in turn; the same for the same seed.
inline std::vector<NamedPolygon> polygonFamilies(uint64_t seed, int count) {
  Random random(seed);
  std::vector<NamedPolygon> all;
  const auto addTurned = [&](const std::string& name, const std::vector<Vec2>& exact, double turn,
                             double jitter, bool degenerate) {
    std::vector<Vec2> points = turn == 0 ? exact : turned(exact, turn);
    if (jitter > 0) points = jittered(random, points, jitter);
    if (points.size() < 3 || !isSimple(exact) || !isSimple(points) || signedArea(points) <= 0) {
      return;
    }
    all.push_back({name + " " + std::to_string(all.size()), points, degenerate, exact, turn});
  };
  const auto add = [&](const std::string& name, const std::vector<Vec2>& points, bool degenerate) {
    addTurned(name, points, 0, 0, degenerate);
  };
  for (int i = 0; static_cast<int>(all.size()) < count; ++i) {
    const int size = 3 + random.below(60);
    const double turn = random.between(0, 2 * kPi);
    switch (i % 17) {
      case 0:
        add("star", randomStar(random, size, 0.9), false);
        break;
      case 1:
        add("rough disc", randomStar(random, size, 0.2), false);
        break;
      case 2:
        add("untangled", randomUntangled(random, std::min(size, 40)), false);
        break;
      case 3:
        add("blob", randomBlob(random, 2 * size + 6), false);
        break;
      case 4:
        add("regular", regularPolygon(size, 100, turn), true);
        break;
      case 5:
        add("polyomino", randomPolyomino(random, size, false), true);
        break;
      case 6:
        addTurned("turned polyomino", randomPolyomino(random, size, false), turn, 0, true);
        break;
      case 7:
        add("cut polyomino", randomPolyomino(random, size, true), true);
        break;
      case 8: {
        // Far above the rounding: a general position like any other.
        const double jitter = std::pow(10.0, -1 - random.below(7));
        add("jittered polyomino", jittered(random, randomPolyomino(random, size, false), jitter),
            true);
        break;
      }
      case 9:
        addTurned("rounded polyomino", randomPolyomino(random, size, false), 0, 1e-13, true);
        break;
      case 10:
        add("spiral", spiralBand(size + 20, random.between(1, 4), random.between(0.5, 4)), true);
        break;
      case 11:
        addTurned("comb", comb(2 + size / 6, 0.25 * (1 + random.below(80))), turn, 0, true);
        break;
      case 12:
        add("symmetric star", symmetricStar(random, 2 + random.below(9), 2 + random.below(5)),
            true);
        break;
      case 13:
        addTurned("mirror star", mirrorStar(random, 2 + size / 3), turn, 0, true);
        break;
      case 14: {
        const double tilt = std::pow(10.0, -random.below(12));
        add("corridor",
            turned(
                {{0, 0}, {100, tilt}, {100, 10}, {60, 10}, {60, 30}, {40, 30}, {40, 10}, {0, 10}},
                turn),
            true);
        break;
      }
      case 15: {
        // Collinear runs: a polyomino with extra vertices on its sides.
        std::vector<Vec2> points;
        const auto corners = randomPolyomino(random, std::max(2, size / 3), false);
        for (size_t k = 0; k < corners.size(); ++k) {
          points.push_back(corners[k]);
          if (random.unit() < 0.4) {
            points.push_back(lerp(corners[k], corners[(k + 1) % corners.size()], 0.375));
          }
        }
        add("collinear runs", points, true);
        break;
      }
      case 16: {
        const double thin = std::pow(10.0, -random.below(5));
        std::vector<Vec2> points = randomBlob(random, size + 6);
        for (Vec2& p : points) p.y *= thin;
        add("thin blob", turned(points, turn), false);
        break;
      }
    }
  }
  return all;
}

}  // namespace marrow
