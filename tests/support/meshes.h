// Outlines with known shapes and families of random ones, for tests of everything that has a
// surface.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "support/random.h"

namespace marrow {

constexpr double kPi = 3.14159265358979323846;

using Outlines = std::vector<std::pair<std::string, std::vector<Vec2>>>;

inline std::vector<Vec2> discOutline(double radius, int count, Vec2 centre = {}) {
  std::vector<Vec2> outline;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    outline.push_back(centre + Vec2{std::cos(angle), std::sin(angle)} * radius);
  }
  return outline;
}

inline std::vector<Vec2> rectangleOutline(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

inline std::vector<Vec2> starOutline(double outer, double inner, int tips) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = kPi * i / tips, radius = i % 2 == 0 ? outer : inner;
    outline.push_back(Vec2{std::cos(angle), std::sin(angle)} * radius);
  }
  return outline;
}

/// A band of the given half width along a curve, with round ends; counter-clockwise.
inline std::vector<Vec2> bandOutline(const std::vector<Vec2>& middle, double half_width) {
  std::vector<Vec2> right, left;
  const size_t n = middle.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 along = middle[i + 1 < n ? i + 1 : i] - middle[i > 0 ? i - 1 : 0];
    const Vec2 side = perpendicular(along / length(along)) * half_width;
    right.push_back(middle[i] - side);
    left.push_back(middle[i] + side);
  }
  const auto cap = [&](Vec2 centre, Vec2 from, std::vector<Vec2>& outline) {
    for (int i = 1; i < 8; ++i) {
      const double angle = kPi * i / 8;
      outline.push_back(centre + from * std::cos(angle) + perpendicular(from) * std::sin(angle));
    }
  };
  std::vector<Vec2> outline = right;
  cap(middle.back(), right.back() - middle.back(), outline);
  outline.insert(outline.end(), left.rbegin(), left.rend());
  cap(middle.front(), left.front() - middle.front(), outline);
  return outline;
}

/// turns windings, each 4 half widths further out.
inline std::vector<Vec2> spiralOutline(double half_width, double turns) {
  std::vector<Vec2> middle;
  const int steps = static_cast<int>(24 * turns);
  for (int i = 0; i <= steps; ++i) {
    const double turn = turns * i / steps, angle = 2 * kPi * turn;
    middle.push_back(Vec2{std::cos(angle), std::sin(angle)} * (half_width * (3 + 4 * turn)));
  }
  return bandOutline(middle, half_width);
}

/// Teeth of different lengths on a bar.
inline std::vector<Vec2> combOutline(Random& random, int teeth) {
  std::vector<Vec2> outline = {{0, 0}, {2.0 * teeth, 0}};
  for (int i = teeth; i-- > 0;) {
    const double top = random.between(1.5, 12);
    outline.push_back({2.0 * i + 2, 1});
    outline.push_back({2.0 * i + random.between(1.3, 1.9), top});
    outline.push_back({2.0 * i + random.between(0.5, 1), top});
    outline.push_back({2.0 * i + 0.3, 1});
  }
  outline.push_back({0, 1});
  outline.erase(outline.begin() + 2);  // the first tooth starts on the bar's end
  return outline;
}

/// A closed curve around the origin whose radius wavers: smooth for few waves, jagged for many.
inline std::vector<Vec2> blobOutline(Random& random, int count, int waves, double unrest) {
  std::vector<double> amplitude, phase;
  for (int w = 0; w < waves; ++w) {
    amplitude.push_back(random.between(0, unrest) / (1 + w));
    phase.push_back(random.between(0, 2 * kPi));
  }
  std::vector<Vec2> outline;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    double radius = 1;
    for (int w = 0; w < waves; ++w) radius += amplitude[w] * std::sin((w + 1) * angle + phase[w]);
    outline.push_back(Vec2{std::cos(angle), std::sin(angle)} * (100 * std::max(radius, 0.05)));
  }
  return outline;
}

/// A star-shaped polygon with independent radii: needles and notches.
inline std::vector<Vec2> jaggedOutline(Random& random, int count) {
  std::vector<Vec2> outline;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * (i + random.between(0.1, 0.9)) / count;
    outline.push_back(Vec2{std::cos(angle), std::sin(angle)} * random.between(20, 100));
  }
  return outline;
}

}  // namespace marrow
