// Strokes and documents for the tests of what stands on the whole way.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "document/command.h"
#include "support/random.h"

namespace marrow {

/// A star with soft arms around a centre.
inline std::vector<Vec2> softStar(int arms, double size, Vec2 center = {}) {
  std::vector<Vec2> points;
  for (int i = 0; i < 150; ++i) {
    const double a = 2 * 3.14159265358979323846 * i / 150;
    const double r = size * (1 + 0.45 * std::sin(arms * a));
    points.push_back(center + Vec2{r * std::cos(a), r * std::sin(a)});
  }
  return points;
}

/// A document with `count` different drawn parts.
inline Document drawnDocument(int count) {
  Document document;
  for (int i = 0; i < count; ++i) {
    auto next = apply(document, AddPart{softStar(2 + i % 5, 60 + 7 * i, {90.0 * i, 10.0 * i})});
    document = *next;
  }
  return document;
}

/// Sets ε_s of one part, or takes it back.
inline SetRefinement simplify(const std::string& id, std::optional<double> value) {
  return {{id}, "", &Refinement::simplify, value};
}

inline std::vector<Vec2> randomPoints(Random& random, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({random.between(-400, 400), random.between(-400, 400)});
  }
  return points;
}

}  // namespace marrow
