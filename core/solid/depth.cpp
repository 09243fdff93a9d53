#include "solid/depth.h"

#include "solid/box_tree.h"

namespace marrow {
namespace {

constexpr int kUnknown = 1 << 30;

class DepthFinder {
 public:
  DepthFinder(const Soup& soup, std::vector<Piercing>& piercings)
      : soup_(soup),
        piercings_(piercings),
        first_triangle_(firstTriangles(soup)),
        parts_(partBoxes(soup)) {}

  PointDepths run() {
    joinPoints();
    relatePatches();
    depths_.of_point.assign(soup_.points.size(), kUnknown);
    for (uint32_t p = 0; p < soup_.points.size() && depths_.ok; ++p) {
      if (depths_.of_point[patch(p)] == kUnknown) spreadFrom(p);
    }
    if (!depths_.ok) return std::move(depths_);
    for (uint32_t p = 0; p < soup_.points.size(); ++p) {
      depths_.of_point[p] = depths_.of_point[patch(p)];
    }
    measurePiercings();
    return std::move(depths_);
  }

 private:
  struct Relation {
    uint32_t from, to;  // patches
    int step;           // how much deeper `to` is
  };

  uint32_t patch(uint32_t p) {
    while (above_[p] != p) p = above_[p] = above_[above_[p]];
    return p;
  }

  /// Points that are joined by edges which pierce nothing are equally deep: a patch.
  void joinPoints() {
    std::vector<char> touched(soup_.points.size(), 0);
    for (const Piercing& piercing : piercings_) {
      touched[lowEnd(piercing.edge)] = touched[highEnd(piercing.edge)] = 1;
    }
    const auto isPierced = [&](uint32_t a, uint32_t b) {
      if (!touched[a] || !touched[b]) return false;
      const auto less = [](const Piercing& p, uint64_t edge) { return p.edge < edge; };
      const auto at = std::lower_bound(piercings_.begin(), piercings_.end(), edgeKey(a, b), less);
      return at != piercings_.end() && at->edge == edgeKey(a, b);
    };
    above_.resize(soup_.points.size());
    for (uint32_t p = 0; p < above_.size(); ++p) above_[p] = p;
    for (const auto& triangle : soup_.triangles) {
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
        if (a > b || isPierced(a, b)) continue;
        const uint32_t one = patch(a), other = patch(b);
        above_[std::max(one, other)] = std::min(one, other);
      }
    }
  }

  void relatePatches() {
    for (size_t first = 0, end = 0; first < piercings_.size(); first = end) {
      int step = 0;
      for (; end < piercings_.size() && piercings_[end].edge == piercings_[first].edge; ++end) {
        step += piercings_[end].entering ? 1 : -1;
      }
      const uint32_t a = patch(lowEnd(piercings_[first].edge)),
                     b = patch(highEnd(piercings_[first].edge));
      relations_.push_back({a, b, step});
      relations_.push_back({b, a, -step});
    }
    std::sort(relations_.begin(), relations_.end(), [](const Relation& a, const Relation& b) {
      if (a.from != b.from) return a.from < b.from;
      return a.to != b.to ? a.to < b.to : a.step < b.step;
    });
  }

  void spreadFrom(uint32_t p) {
    std::vector<uint32_t> stack = {patch(p)};
    depths_.of_point[stack[0]] = depthByRay(p);
    while (!stack.empty()) {
      const uint32_t from = stack.back();
      stack.pop_back();
      auto at =
          std::lower_bound(relations_.begin(), relations_.end(), from,
                           [](const Relation& r, uint32_t wanted) { return r.from < wanted; });
      for (; at != relations_.end() && at->from == from; ++at) {
        const int depth = depths_.of_point[from] + at->step;
        if (depths_.of_point[at->to] == kUnknown) {
          depths_.of_point[at->to] = depth;
          stack.push_back(at->to);
        } else if (depths_.of_point[at->to] != depth) {
          fail(soup_.part_of_point[from], soup_.part_of_point[from]);
        }
      }
    }
  }

  /// Counts what a ray upwards goes through.
  int depthByRay(uint32_t point) {
    const Vec3 p = soup_.points[point];
    int depth = 0;
    std::vector<uint32_t> around;
    Box3 here;
    here.include(p);
    parts_.pairs(BoxTree(std::vector<Box3>{here}),
                 [&](uint32_t part, uint32_t) { around.push_back(part); });
    std::sort(around.begin(), around.end());
    for (const uint32_t part : around) {
      if (part == soup_.part_of_point[point]) continue;
      for (uint32_t t = first_triangle_[part]; t < first_triangle_[part + 1]; ++t) {
        const auto& triangle = soup_.triangles[t];
        const Vec3 a = soup_.points[triangle[0]], b = soup_.points[triangle[1]],
                   c = soup_.points[triangle[2]];
        if (std::max({a.z, b.z, c.z}) < p.z || std::max({a.x, b.x, c.x}) < p.x ||
            std::min({a.x, b.x, c.x}) > p.x || std::max({a.y, b.y, c.y}) < p.y ||
            std::min({a.y, b.y, c.y}) > p.y) {
          continue;
        }
        const int ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
        if (ab * bc < 0 || bc * ca < 0 || ca * ab < 0) continue;
        const int side = Facet(a, b, c).side(p);
        if (ab == 0 || bc == 0 || ca == 0 || side == 0) {
          fail(soup_.part_of_point[point], part);
          return 0;
        }
        // Seen from above, a triangle that turns left faces up: the ray leaves the solid there.
        if (side != ab) depth += ab;
      }
    }
    return depth;
  }

  void measurePiercings() {
    for (size_t first = 0, end = 0; first < piercings_.size(); first = end) {
      int depth = depths_.of_point[lowEnd(piercings_[first].edge)];
      for (; end < piercings_.size() && piercings_[end].edge == piercings_[first].edge; ++end) {
        Piercing& piercing = piercings_[end];
        piercing.depth = piercing.entering ? depth : depth - 1;
        depth += piercing.entering ? 1 : -1;
      }
    }
  }

  void fail(uint32_t part, uint32_t other) {
    depths_.ok = false;
    depths_.part = part;
    depths_.other = other;
  }

  const Soup& soup_;
  std::vector<Piercing>& piercings_;
  PointDepths depths_;
  std::vector<uint32_t> first_triangle_;  // of each part; one more at the end
  BoxTree parts_;
  std::vector<uint32_t> above_;
  std::vector<Relation> relations_;
};

}  // namespace

std::vector<uint32_t> firstTriangles(const Soup& soup) {
  std::vector<uint32_t> first(soup.part_of_point.empty() ? 1 : soup.part_of_point.back() + 2, 0);
  for (const uint32_t part : soup.part_of_triangle) ++first[part + 1];
  for (size_t p = 1; p < first.size(); ++p) first[p] += first[p - 1];
  return first;
}

std::vector<Box3> partBoxes(const Soup& soup) {
  std::vector<Box3> boxes(soup.part_of_point.empty() ? 0 : soup.part_of_point.back() + 1);
  for (size_t i = 0; i < soup.points.size(); ++i) {
    boxes[soup.part_of_point[i]].include(soup.points[i]);
  }
  return boxes;
}

PointDepths depthsOfPoints(const Soup& soup, std::vector<Piercing>& piercings) {
  return DepthFinder(soup, piercings).run();
}

}  // namespace marrow
