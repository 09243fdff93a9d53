// Families of pen strokes for tests: as smooth curves, as polygons, and as a hand draws them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "support/random.h"

namespace marrow::strokes {

using Stroke = std::vector<Vec2>;

struct NamedStroke {
  std::string name;
  Stroke points;
};

constexpr double kTau = 6.28318530717958647692;

inline Vec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// ---- Transformations

inline Stroke rotated(Stroke stroke, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec2& p : stroke) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return stroke;
}

inline Stroke scaled(Stroke stroke, double factor) {
  for (Vec2& p : stroke) p = p * factor;
  return stroke;
}

inline Stroke translated(Stroke stroke, Vec2 by) {
  for (Vec2& p : stroke) p = p + by;
  return stroke;
}

inline Stroke mirrored(Stroke stroke) {
  for (Vec2& p : stroke) p.x = -p.x;
  return stroke;
}

inline Stroke reversed(Stroke stroke) {
  std::reverse(stroke.begin(), stroke.end());
  return stroke;
}

/// A closed stroke begun at another of its samples.
inline Stroke startedAt(Stroke stroke, size_t first) {
  std::rotate(stroke.begin(), stroke.begin() + static_cast<std::ptrdiff_t>(first), stroke.end());
  return stroke;
}

/// Samples about `spacing` apart on the straight lines between the given points.
inline Stroke sampled(const Stroke& corners, double spacing, bool closed = true) {
  Stroke stroke;
  const size_t edges = closed ? corners.size() : corners.size() - 1;
  for (size_t i = 0; i < edges; ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    const int count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / spacing)));
    for (int k = 0; k < count; ++k) stroke.push_back(lerp(a, b, static_cast<double>(k) / count));
  }
  if (!closed) stroke.push_back(corners.back());
  return stroke;
}

inline Stroke jittered(Random& random, Stroke stroke, double by) {
  for (Vec2& p : stroke) p = p + Vec2{random.between(-by, by), random.between(-by, by)};
  return stroke;
}

/// On the nearest whole pixels, as a mouse gives them.
inline Stroke onPixels(Stroke stroke, double pixel) {
  for (Vec2& p : stroke) {
    p = {std::floor(p.x / pixel + 0.5) * pixel, std::floor(p.y / pixel + 0.5) * pixel};
  }
  return stroke;
}

// ---- Closed shapes

inline Stroke disc(double radius, int samples) {
  Stroke stroke;
  for (int i = 0; i < samples; ++i) stroke.push_back(polar(radius, kTau * i / samples));
  return stroke;
}

inline Stroke rectangle(double width, double height) {
  return {{-width / 2, -height / 2},
          {width / 2, -height / 2},
          {width / 2, height / 2},
          {-width / 2, height / 2}};
}

inline Stroke star(int arms, double inner, double outer) {
  Stroke stroke;
  for (int i = 0; i < 2 * arms; ++i) {
    stroke.push_back(polar(i % 2 ? inner : outer, kTau * i / (2 * arms)));
  }
  return stroke;
}

/// The border of all points within `half_width` of an open line: out along it, a round end, back,
/// a round end. The line may not bend more tightly than the half width.
inline Stroke tube(const Stroke& axis, double half_width, int cap_samples = 8) {
  const size_t n = axis.size();
  const auto normalAt = [&](size_t i) {
    const Vec2 along = axis[std::min(i + 1, n - 1)] - axis[i > 0 ? i - 1 : 0];
    return perpendicular(along) / length(along);
  };
  Stroke stroke;
  const auto cap = [&](size_t i, Vec2 from) {
    for (int k = 1; k < cap_samples; ++k) {
      const double a = kTau / 2 * k / cap_samples;
      stroke.push_back(axis[i] +
                       half_width * (from * std::cos(a) + perpendicular(from) * std::sin(a)));
    }
  };
  for (size_t i = 0; i < n; ++i) stroke.push_back(axis[i] - half_width * normalAt(i));
  cap(n - 1, -normalAt(n - 1));
  for (size_t i = n; i-- > 0;) stroke.push_back(axis[i] + half_width * normalAt(i));
  cap(0, normalAt(0));
  return stroke;
}

/// A straight band with round ends.
inline Stroke strip(double length_of_axis, double half_width, int samples_along = 80) {
  Stroke axis;
  for (int i = 0; i <= samples_along; ++i) {
    axis.push_back({length_of_axis * (static_cast<double>(i) / samples_along - 0.5), 0});
  }
  return tube(axis, half_width);
}

/// A band along an Archimedean spiral whose arms are `pitch` apart.
inline Stroke spiral(double turns, double pitch, double half_width, int samples_along = 300) {
  Stroke axis;
  for (int i = 0; i <= samples_along; ++i) {
    const double angle = kTau * (0.6 + turns * i / samples_along);
    axis.push_back(polar(pitch * angle / kTau, angle));
  }
  return tube(axis, half_width);
}

/// A thin tube that swings to and fro.
inline Stroke wavyTube(double half_width, int samples_along = 200) {
  Stroke axis;
  for (int i = 0; i <= samples_along; ++i) {
    const double t = static_cast<double>(i) / samples_along;
    axis.push_back({800 * (t - 0.5), 60 * std::sin(2 * kTau * t)});
  }
  return tube(axis, half_width);
}

/// A palm with five fingers.
inline Stroke hand() {
  Stroke corners;
  corners.push_back({-60, -150});
  corners.push_back({60, -150});
  for (int finger = 0; finger < 5; ++finger) {
    const double a = kTau * (-0.03 + 0.14 * finger);
    const Vec2 along = polar(1, a), across = perpendicular(along);
    const double reach = finger == 0 || finger == 4 ? 190 : 240;
    corners.push_back(90 * along - 22 * across);
    corners.push_back(reach * along - 16 * across);
    corners.push_back((reach + 14) * along);
    corners.push_back(reach * along + 16 * across);
    corners.push_back(90 * along + 22 * across);
  }
  return sampled(corners, 4);
}

/// A random smooth curve around the origin that does not cross itself.
inline Stroke blob(Random& random, int samples, double size = 200) {
  double amplitude[7] = {}, phase[7] = {};
  for (int k = 2; k < 7; ++k) {
    amplitude[k] = random.between(0, 0.45) / k;
    phase[k] = random.between(0, kTau);
  }
  Stroke stroke;
  for (int i = 0; i < samples; ++i) {
    const double a = kTau * i / samples;
    double r = 1;
    for (int k = 2; k < 7; ++k) r += amplitude[k] * std::sin(k * a + phase[k]);
    stroke.push_back(polar(size * r, a));
  }
  return stroke;
}

/// A random smooth closed curve; most of them cross themselves.
inline Stroke closedCurve(Random& random, int samples, double size = 200) {
  double ax[6], ay[6], px[6], py[6];
  for (int k = 1; k < 6; ++k) {
    ax[k] = random.between(0.2, 1) / k;
    ay[k] = random.between(0.2, 1) / k;
    px[k] = random.between(0, kTau);
    py[k] = random.between(0, kTau);
  }
  Stroke stroke;
  for (int i = 0; i < samples; ++i) {
    const double t = kTau * i / samples;
    Vec2 p;
    for (int k = 1; k < 6; ++k) {
      p = p + Vec2{ax[k] * std::sin(k * t + px[k]), ay[k] * std::sin(k * t + py[k])};
    }
    stroke.push_back(size * p);
  }
  return stroke;
}

inline Stroke figureEight(double size, int samples) {
  Stroke stroke;
  for (int i = 0; i < samples; ++i) {
    const double t = kTau * i / samples;
    stroke.push_back(
        {size * std::sin(t), size * std::sin(t) * std::cos(t) * (1.3 + 0.3 * std::sin(t))});
  }
  return stroke;
}

// ---- Open and wild strokes

/// A pen that wanders about in a box, turning at random and bouncing off the walls.
inline Stroke scribble(Random& random, int samples, double box = 400, double speed = 12) {
  Stroke stroke;
  Vec2 p{0, 0};
  double heading = random.between(0, kTau), curl = 0;
  for (int i = 0; i < samples; ++i) {
    stroke.push_back(p);
    curl = 0.9 * curl + random.between(-0.2, 0.2);
    heading += curl;
    Vec2 next = p + polar(speed, heading);
    if (std::fabs(next.x) > box / 2 || std::fabs(next.y) > box / 2) {
      heading += kTau / 2;
      next = p;
    }
    p = next;
  }
  return stroke;
}

/// Random points on a small lattice: repeats, overlaps and touching points everywhere.
inline Stroke latticeWalk(Random& random, int samples, int side) {
  Stroke stroke;
  for (int i = 0; i < samples; ++i) {
    stroke.push_back(
        {static_cast<double>(random.below(side)), static_cast<double>(random.below(side))});
  }
  return stroke;
}

/// Steps by one to a neighbour on a lattice: most edges are run over several times.
inline Stroke latticeSteps(Random& random, int samples) {
  Stroke stroke;
  Vec2 p;
  for (int i = 0; i < samples; ++i) {
    stroke.push_back(p);
    const int d = random.below(8);
    p = p + Vec2{d < 3 ? -1.0 : (d < 5 ? 0.0 : 1.0), d % 3 == 0 ? -1.0 : (d % 3 == 1 ? 0.0 : 1.0)};
  }
  return stroke;
}

inline Stroke zigzag(int teeth, double width, double height) {
  Stroke stroke;
  for (int i = 0; i <= teeth; ++i) {
    stroke.push_back({width * i / teeth, i % 2 ? height : 0});
  }
  return sampled(stroke, std::max(width / teeth, height) / 30, false);
}

/// Along a closed curve as a hand draws it: it starts anywhere, overshoots or falls short of its
/// start by `overshoot` of the whole, drifts, and comes on whole pixels.
inline Stroke byHand(Random& random, const Stroke& curve, double overshoot, double pixel = 1) {
  const size_t n = curve.size();
  const auto start = static_cast<size_t>(random.below(static_cast<int>(n)));
  const auto count = static_cast<size_t>(static_cast<double>(n) * (1 + overshoot));
  const Vec2 drift{random.between(-4, 4) * pixel, random.between(-4, 4) * pixel};
  Stroke stroke;
  for (size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    stroke.push_back(curve[(start + i) % n] + drift * t);
  }
  return onPixels(jittered(random, stroke, 0.3 * pixel), pixel);
}

/// Shapes that anybody would draw, none of them crossing itself.
inline std::vector<NamedStroke> plainShapes() {
  Random random(7);
  std::vector<NamedStroke> all = {
      {"disc", disc(100, 240)},
      {"coarse disc", disc(100, 10)},
      {"strip", strip(700, 30)},
      {"thin strip", strip(800, 2)},
      {"rectangle", rectangle(300, 200)},
      {"sampled rectangle", sampled(rectangle(300, 200), 3)},
      {"star", star(5, 60, 150)},
      {"sampled star", sampled(star(7, 60, 150), 3)},
      {"thin star", sampled(star(9, 12, 200), 2)},
      {"spiral", spiral(3, 60, 18)},
      {"close spiral", spiral(5, 40, 18.5)},
      {"hand", hand()},
      {"wavy tube", wavyTube(12)},
      {"thin wavy tube", wavyTube(1.5)},
  };
  for (int i = 0; i < 10; ++i) {
    all.push_back({"blob " + std::to_string(i), blob(random, 60 + 60 * i)});
  }
  return all;
}

/// `count` strokes of all kinds, wild ones among them; the same for the same seed.
inline std::vector<NamedStroke> strokeFamilies(uint64_t seed, int count) {
  Random random(seed);
  std::vector<NamedStroke> all;
  for (int i = 0; i < count; ++i) {
    const int samples = 10 + random.below(i % 10 == 0 ? 2000 : 300);
    const auto add = [&](const char* name, Stroke stroke) {
      all.push_back({std::string(name) + " " + std::to_string(i), std::move(stroke)});
    };
    switch (i % 12) {
      case 0:
        add("blob", rotated(blob(random, samples), random.between(0, kTau)));
        break;
      case 1:
        add("closed curve", closedCurve(random, samples));
        break;
      case 2:
        add("drawn blob",
            byHand(random, blob(random, 200), random.between(-0.1, 0.1), random.between(0.5, 4)));
        break;
      case 3:
        add("drawn curve", byHand(random, closedCurve(random, 200), random.between(-0.1, 0.1),
                                  random.between(0.5, 4)));
        break;
      case 4:
        add("scribble", scribble(random, samples));
        break;
      case 5:
        add("lattice walk", latticeWalk(random, samples, 3 + random.below(12)));
        break;
      case 6:
        add("lattice steps", latticeSteps(random, samples));
        break;
      case 7:
        add("turned lattice steps",
            rotated(latticeSteps(random, samples), random.between(0, kTau)));
        break;
      case 8:
        add("random points", jittered(random, Stroke(static_cast<size_t>(samples)), 300));
        break;
      case 9: {
        // Forth and back over itself, then a loop.
        Stroke there = scribble(random, 10 + random.below(20));
        Stroke stroke = there;
        for (const Vec2& p : disc(60, 40)) stroke.push_back(there.back() + p - Vec2{60, 0});
        stroke.insert(stroke.end(), there.rbegin(), there.rend());
        add("loop on a string", rotated(stroke, random.between(0, kTau)));
        break;
      }
      case 10: {
        const double half_width = std::pow(10.0, random.between(-1, 1.2));
        add("wavy tube", rotated(wavyTube(half_width, 60 + samples), random.between(0, kTau)));
        break;
      }
      case 11: {
        const double pitch = random.between(20, 80);
        add("spiral", spiral(random.between(1, 6), pitch, pitch * random.between(0.1, 0.48)));
        break;
      }
    }
  }
  return all;
}

// ---- Real ones

/// A file's text, empty where it cannot be read.
inline std::string readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  return text.str();
}

inline Stroke toStroke(const nlohmann::json& points) {
  Stroke stroke;
  for (const auto& p : points) stroke.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
  return stroke;
}

inline std::string sharedFolder() {
#ifdef MARROW_SHARED_DIR
  return MARROW_SHARED_DIR;
#else
  return "";
#endif
}

inline std::vector<std::string> realStrokeNames() {
  return {"ad-char1",
          "ad-char4",
          "icon-fluent-butterfly",
          "icon-fluent-crab",
          "icon-fluent-llama",
          "icon-fluent-sauropod",
          "icon-game-icons-angler-fish",
          "icon-game-icons-curled-tentacle",
          "icon-game-icons-kangaroo",
          "icon-game-icons-sheep",
          "icon-mdi-bat",
          "icon-mdi-gymnastics",
          "icon-mdi-human",
          "icon-mdi-kangaroo",
          "qd-angel-1",
          "qd-bear-45",
          "qd-cactus-85",
          "qd-cat-109",
          "qd-dog-174",
          "qd-elephant-198",
          "qd-flower-237",
          "qd-giraffe-261",
          "qd-horse-279",
          "qd-lion-339",
          "qd-onion-392",
          "qd-rabbit-480",
          "qd-shark-506",
          "qd-snake-529"};
}

inline std::vector<std::string> hardPolygonNames() {
  return {"earcut-bad-diagonals",
          "earcut-degenerate",
          "earcut-empty-square",
          "earcut-infinite-loop-jhl",
          "earcut-issue142",
          "earcut-issue186",
          "earcut-issue52",
          "earcut-self-tangent-2",
          "earcut-simplified-us-border",
          "earcut-touching-holes4",
          "poly2tri-2",
          "poly2tri-deadly-quad",
          "poly2tri-diamond",
          "poly2tri-kzer-za",
          "poly2tri-polygon-test-01",
          "poly2tri-sketchup",
          "sss-misc-crashes-1",
          "sss-misc-crashes-2-working",
          "sss-misc-crashes-3",
          "sss-misc-crashes-5",
          "sss-misc-random-1",
          "sss-misc-snail-01",
          "sss-simple-simple-01",
          "sss-simple-simple-03",
          "sss-simple-simple-05",
          "sss-simple-simple-07",
          "sss-simple-simple-09",
          "sss-simple-simple-10b",
          "sss-simple-simple-12",
          "sss-simple-simple-14"};
}

/// The real strokes beside the project; empty where they are not there.
inline std::vector<NamedStroke> realStrokes() {
  std::vector<NamedStroke> all;
  for (const std::string& name : realStrokeNames()) {
    const std::string text = readText(sharedFolder() + "/strokes/" + name + ".json");
    if (!text.empty()) all.push_back({name, toStroke(nlohmann::json::parse(text).at("points"))});
  }
  return all;
}

/// Outer rings of polygons that broke other programs; empty where they are not there.
inline std::vector<NamedStroke> hardPolygons() {
  std::vector<NamedStroke> all;
  for (const std::string& name : hardPolygonNames()) {
    const std::string text = readText(sharedFolder() + "/polygons/" + name + ".json");
    if (!text.empty())
      all.push_back({name, toStroke(nlohmann::json::parse(text).at("rings").at(0))});
  }
  return all;
}

}  // namespace marrow::strokes
