// In how many other solids each point of some surfaces lies.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/box.h"
#include "solid/cut.h"

namespace marrow {

/// An edge's two points, the lower first.
inline uint64_t edgeKey(uint32_t a, uint32_t b) {
  return static_cast<uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}
inline uint32_t lowEnd(uint64_t edge) { return static_cast<uint32_t>(edge >> 32); }
inline uint32_t highEnd(uint64_t edge) { return static_cast<uint32_t>(edge); }

struct Piercing {
  uint64_t edge;
  uint32_t triangle;
  bool entering;  // on the way from the edge's lower to its higher end
  int depth;      // in front of the triangle
};

/// Where each part's triangles begin; one more at the end.
std::vector<uint32_t> firstTriangles(const Soup& soup);

/// Around each part.
std::vector<Box3> partBoxes(const Soup& soup);

struct PointDepths {
  std::vector<int> of_point;
  bool ok = true;  // false: these two parts contradict each other
  uint32_t part = 0, other = 0;
};

/// The piercings are in the order of edges and on each edge from the lower end on; gets their depth
/// right.
PointDepths depthsOfPoints(const Soup& soup, std::vector<Piercing>& piercings);

}  // namespace marrow
