// What is measured: strokes and polygons.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"
#include "support/random.h"

namespace marrow::bench {

struct Input {
  std::string name;
  std::vector<Vec2> points;
};

/// An animal on four legs, 300 samples with a hand's noise.
std::vector<Vec2> typicalStroke();

/// The typical one first, then ours, then the real ones where they are beside the project.
std::vector<Input> benchStrokes();

/// Polygons of any size.
struct Family {
  const char* name;
  std::vector<Vec2> (*polygon)(Random& random, int n);
};
std::vector<Family> polygonsThatGrow();

}  // namespace marrow::bench
