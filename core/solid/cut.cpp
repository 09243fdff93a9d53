#include "solid/cut.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "solid/box_tree.h"
#include "solid/depth.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = ~0u;
constexpr double kMisplaced = 0x1p-14;  // lattice units, by which a new point's place is rounded

struct Segment {
  uint32_t t, u;            // t < u
  uint32_t source, target;  // piercings; what is outside u lies on the left in t
};

struct Triple {
  uint32_t t, u, v;
  Vec3 position;
};

/// A triple point on a segment.
struct Stop {
  uint32_t segment, triple;
  double share, error;  // of the way from source to target
  int step;             // how many more solids are around behind it: 1 or −1
};

class Cutter {
 public:
  explicit Cutter(const Soup& soup) : soup_(soup) {}

  Cut run() {
    findSegments();
    if (cut_.ok) orderPiercings();
    if (cut_.ok) measureDepths();
    if (cut_.ok) findTriples();
    if (cut_.ok) emit();
    return std::move(cut_);
  }

 private:
  struct End {
    uint64_t edge;
    uint32_t triangle, segment;
    bool source, entering;
  };

  const Vec3& corner(uint32_t triangle, int i) const {
    return soup_.points[soup_.triangles[triangle][static_cast<size_t>(i)]];
  }
  uint32_t part(uint32_t triangle) const { return soup_.part_of_triangle[triangle]; }

  void fail(uint32_t t, uint32_t u) {
    if (!cut_.ok) return;
    cut_.ok = false;
    cut_.part = part(t);
    cut_.other = part(u);
  }

  /// Triangles that come near another part; all others are left alone.
  struct Near {
    std::vector<uint32_t> triangles;
    BoxTree tree;
  };
  struct Crossing {
    uint32_t t, u;
    std::array<End, 2> ends;
  };

  Box3 boxOf(uint32_t triangle) const {
    Box3 box;
    for (const uint32_t i : soup_.triangles[triangle]) box.include(soup_.points[i]);
    return box;
  }

  const Facet& facet(uint32_t triangle) const { return facets_[facet_of_[triangle]]; }

  /// The triangles of `part` whose boxes meet that of one of the others, with their facets.
  Near nearTriangles(uint32_t part, const std::vector<Box3>& part_boxes,
                     const std::vector<uint32_t>& others) {
    Near near{{}, BoxTree(std::vector<Box3>{})};
    std::vector<Box3> boxes;
    for (uint32_t t = first_[part]; t < first_[part + 1]; ++t) {
      const Box3 box = boxOf(t);
      const bool is_near = std::any_of(others.begin(), others.end(), [&](uint32_t other) {
        return box.meets(part_boxes[other]);
      });
      if (!is_near) continue;
      near.triangles.push_back(t);
      boxes.push_back(box);
      const auto& [a, b, c] = soup_.triangles[t];
      facet_of_[t] = static_cast<uint32_t>(facets_.size());
      facets_.emplace_back(soup_.points[a], soup_.points[b], soup_.points[c]);
    }
    cut_.examined += near.triangles.size();
    near.tree = BoxTree(std::move(boxes));
    return near;
  }

  void findSegments() {
    first_ = firstTriangles(soup_);
    facet_of_.assign(soup_.triangles.size(), kNone);
    const std::vector<Box3> boxes = partBoxes(soup_);
    const auto parts = static_cast<uint32_t>(boxes.size());
    std::vector<std::vector<uint32_t>> neighbours(parts);
    BoxTree(boxes).pairs([&](uint32_t p, uint32_t q) {
      neighbours[p].push_back(q);
      neighbours[q].push_back(p);
    });
    // Trees live from the first to the last pair that they are of.
    std::vector<std::unique_ptr<Near>> near(parts);
    const auto nearOf = [&](uint32_t part) -> const Near& {
      if (!near[part]) {
        near[part] = std::make_unique<Near>(nearTriangles(part, boxes, neighbours[part]));
      }
      return *near[part];
    };
    for (uint32_t p = 0; p < parts; ++p) {
      std::sort(neighbours[p].begin(), neighbours[p].end());
      for (const uint32_t q : neighbours[p]) {
        if (q < p) continue;
        const Near &one = nearOf(p), &other = nearOf(q);
        ++cut_.pairs;
        found_.clear();
        one.tree.pairs(other.tree, [&](uint32_t i, uint32_t j) {
          crossTriangles(one.triangles[i], other.triangles[j]);
        });
        addCrossings();
      }
      near[p].reset();
    }
    cut_.crossings = segments_.size();

    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      if (a.edge != b.edge) return a.edge < b.edge;
      return a.triangle != b.triangle ? a.triangle < b.triangle : a.segment < b.segment;
    });
    for (size_t i = 0; i < ends_.size(); ++i) {
      const End& end = ends_[i];
      if (i == 0 || end.edge != ends_[i - 1].edge || end.triangle != ends_[i - 1].triangle) {
        piercings_.push_back({end.edge, end.triangle, end.entering, 0});
      }
      const uint32_t id = static_cast<uint32_t>(piercings_.size() - 1);
      Segment& segment = segments_[end.segment];
      (end.source ? segment.source : segment.target) = id;
    }
  }

  /// In an order that does not hang on that of the trees.
  void addCrossings() {
    std::sort(found_.begin(), found_.end(), [](const Crossing& a, const Crossing& b) {
      return a.t != b.t ? a.t < b.t : a.u < b.u;
    });
    for (Crossing& crossing : found_) {
      for (End& end : crossing.ends) {
        end.segment = static_cast<uint32_t>(segments_.size());
        ends_.push_back(end);
      }
      segments_.push_back({crossing.t, crossing.u, kNone, kNone});
    }
  }

  void crossTriangles(uint32_t t, uint32_t u) {
    int over_u[3], over_t[3];
    for (int i = 0; i < 3; ++i) over_u[i] = facet(u).side(corner(t, i));
    if (over_u[0] == over_u[1] && over_u[1] == over_u[2] && over_u[0] != 0) return;
    for (int i = 0; i < 3; ++i) over_t[i] = facet(t).side(corner(u, i));
    if (over_t[0] == over_t[1] && over_t[1] == over_t[2] && over_t[0] != 0) return;
    for (int i = 0; i < 3; ++i) {
      if (over_u[i] == 0 || over_t[i] == 0) return fail(t, u);
    }

    std::array<End, 2> found;
    size_t count = 0;
    const auto pierce = [&](uint32_t from, uint32_t through, const int* over, bool of_t) {
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (over[i] == over[j]) continue;
        if (!pierces(from, i, through)) continue;
        if (count == 2) return fail(t, u);
        const uint32_t a = soup_.triangles[from][static_cast<size_t>(i)],
                       b = soup_.triangles[from][static_cast<size_t>(j)];
        // The border of what is outside `through` turns into the segment where the edge goes in.
        const bool goes_in = over[i] > 0;
        found[count++] = {edgeKey(a, b), through, kNone, goes_in == of_t, (a < b) == goes_in};
      }
    };
    pierce(t, u, over_u, true);
    pierce(u, t, over_t, false);
    if (!cut_.ok || count == 0) return;
    if (count != 2 || found[0].source == found[1].source) return fail(t, u);
    found_.push_back({t, u, found});
  }

  /// Whether the line through an edge of one triangle passes inside another.
  bool pierces(uint32_t from, int edge, uint32_t through) {
    const auto [i, j] = std::minmax(soup_.triangles[from][static_cast<size_t>(edge)],
                                    soup_.triangles[from][static_cast<size_t>((edge + 1) % 3)]);
    const Vec3 a = soup_.points[i], b = soup_.points[j];
    int first = 0;
    for (int k = 0; k < 3; ++k) {
      const int side = orientation(a, b, corner(through, k), corner(through, (k + 1) % 3));
      if (side == 0) fail(from, through);
      if (k == 0) first = side;
      if (side != first) return false;
    }
    return true;
  }

  /// Brings the piercings of each edge into their order from its lower to its higher end.
  void orderPiercings() {
    std::vector<uint32_t> order(piercings_.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    for (size_t first = 0, end = 0; first < piercings_.size(); first = end) {
      while (end < piercings_.size() && piercings_[end].edge == piercings_[first].edge) ++end;
      const Vec3 low = soup_.points[lowEnd(piercings_[first].edge)],
                 high = soup_.points[highEnd(piercings_[first].edge)];
      for (size_t i = first + 1; i < end; ++i) {
        for (size_t j = i; j > first; --j) {
          const uint32_t a = piercings_[order[j - 1]].triangle, b = piercings_[order[j]].triangle;
          const int which = firstMet(low, high, facet(a), facet(b));
          if (which == 0) fail(a, b);
          if (which <= 0) break;
          std::swap(order[j - 1], order[j]);
        }
      }
    }
    std::vector<Piercing> ordered;
    std::vector<uint32_t> place(order.size());
    ordered.reserve(order.size());
    for (uint32_t i = 0; i < order.size(); ++i) {
      ordered.push_back(piercings_[order[i]]);
      place[order[i]] = i;
    }
    piercings_ = std::move(ordered);
    for (Segment& segment : segments_) {
      segment.source = place[segment.source];
      segment.target = place[segment.target];
    }
  }

  void measureDepths() {
    depths_ = depthsOfPoints(soup_, piercings_);
    if (!depths_.ok) {
      cut_.ok = false;
      cut_.part = depths_.part;
      cut_.other = depths_.other;
      return;
    }
    cut_.points = soup_.points;
    cut_.points.reserve(soup_.points.size() + piercings_.size());
    for (const Piercing& piercing : piercings_) {
      const uint32_t a = lowEnd(piercing.edge), b = highEnd(piercing.edge);
      const Facet& pierced = facet(piercing.triangle);
      const double from = exactly(pierced, soup_.points[a]), to = exactly(pierced, soup_.points[b]);
      const double share = from / (from - to);
      cut_.points.push_back(lerp(soup_.points[a], soup_.points[b], share));
      cut_.origins.push_back({a, b, share, {piercing.triangle, 0, 0}});
    }
  }

  static double exactly(const Facet& facet, Vec3 p) {
    const Measured height = facet.height(p);
    const bool is_good = height.error < std::fabs(height.value) * 0x1p-48;
    return is_good ? height.value : static_cast<double>(facet.exactHeight(p));
  }

  Vec3 pointOf(uint32_t piercing) const { return cut_.points[soup_.points.size() + piercing]; }

  /// On which side of a triangle's plane an end of a segment lies.
  int side(uint32_t piercing, uint32_t triangle) const {
    const Piercing& p = piercings_[piercing];
    return sideOfPiercing(soup_.points[lowEnd(p.edge)], soup_.points[highEnd(p.edge)],
                          facet(p.triangle), facet(triangle));
  }

  void findTriples() {
    of_triangle_.assign(soup_.triangles.size() + 1, 0);
    for (const Segment& segment : segments_) {
      ++of_triangle_[segment.t + 1];
      ++of_triangle_[segment.u + 1];
    }
    for (size_t t = 1; t < of_triangle_.size(); ++t) of_triangle_[t] += of_triangle_[t - 1];
    listed_.resize(2 * segments_.size());
    std::vector<uint32_t> filled(of_triangle_.begin(), of_triangle_.end() - 1);
    for (uint32_t s = 0; s < segments_.size(); ++s) {
      listed_[filled[segments_[s].t]++] = s;
      listed_[filled[segments_[s].u]++] = s;
    }

    std::vector<Box3> boxes(segments_.size());
    for (size_t s = 0; s < segments_.size(); ++s) {
      boxes[s].include(pointOf(segments_[s].source));
      boxes[s].include(pointOf(segments_[s].target));
      boxes[s].low = boxes[s].low - Vec3{1, 1, 1};
      boxes[s].high = boxes[s].high + Vec3{1, 1, 1};
    }
    for (uint32_t t = 0; t < soup_.triangles.size() && cut_.ok; ++t) {
      for (size_t i = of_triangle_[t]; i < of_triangle_[t + 1]; ++i) {
        const Segment& one = segments_[listed_[i]];
        if (one.t != t) continue;
        for (size_t j = of_triangle_[t]; j < i; ++j) {
          const Segment& other = segments_[listed_[j]];
          if (other.t != t || part(other.u) == part(one.u)) continue;
          if (boxes[listed_[i]].meets(boxes[listed_[j]])) crossSegments(listed_[i], listed_[j]);
        }
      }
    }
    std::sort(stops_.begin(), stops_.end(), [](const Stop& a, const Stop& b) {
      if (a.segment != b.segment) return a.segment < b.segment;
      return a.share != b.share ? a.share < b.share : a.triple < b.triple;
    });
    for (size_t i = 1; i < stops_.size(); ++i) {
      const Stop &a = stops_[i - 1], &b = stops_[i];
      if (a.segment == b.segment && !(b.share - a.share > a.error + b.error)) {
        fail(triples_[a.triple].v, triples_[b.triple].v);
      }
    }
    for (const Triple& triple : triples_) {
      cut_.points.push_back(triple.position);
      cut_.origins.push_back({0, 0, 0, {triple.t, triple.u, triple.v}});
    }
  }

  void crossSegments(uint32_t one, uint32_t other) {
    const uint32_t t = segments_[one].t, u = segments_[one].u, v = segments_[other].u;
    const auto cross = [&](uint32_t segment, uint32_t plane, Stop& stop) {
      const Segment& s = segments_[segment];
      const int from = side(s.source, plane), to = side(s.target, plane);
      if (from == 0 || to == 0) fail(t, plane);
      if (from == to) return false;
      const Vec3 normal = facet(plane).normal(), on = corner(plane, 0);
      const double a = dot(normal, pointOf(s.source) - on), b = dot(normal, pointOf(s.target) - on);
      stop.segment = segment;
      stop.share = a != b ? std::min(std::max(a / (a - b), 0.0), 1.0) : 0.5;
      stop.error = a != b ? kMisplaced * length(normal) / std::fabs(a - b) : 1;
      stop.step = from > 0 ? 1 : -1;
      return true;
    };
    Stop of_one{}, of_other{}, of_third{};
    if (!cross(one, v, of_one) || !cross(other, u, of_other)) return;
    const uint32_t third = segmentBetween(u, v);
    if (third == kNone || !cross(third, t, of_third)) return fail(u, v);
    const uint32_t id = static_cast<uint32_t>(triples_.size());
    const Segment& s = segments_[one];
    triples_.push_back({t, u, v, lerp(pointOf(s.source), pointOf(s.target), of_one.share)});
    for (Stop* stop : {&of_one, &of_other, &of_third}) {
      stop->triple = id;
      stops_.push_back(*stop);
    }
  }

  uint32_t segmentBetween(uint32_t t, uint32_t u) const {
    for (size_t i = of_triangle_[t]; i < of_triangle_[t + 1]; ++i) {
      const Segment& segment = segments_[listed_[i]];
      if (segment.t + segment.u == t + u && (segment.t == t || segment.u == t)) return listed_[i];
    }
    return kNone;
  }

  void emit() {
    for (uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      if (of_triangle_[t] < of_triangle_[t + 1]) {
        emitEdges(t);
        for (size_t i = of_triangle_[t]; i < of_triangle_[t + 1]; ++i) emitSegment(t, listed_[i]);
      } else if (depths_.of_point[soup_.triangles[t][0]] <= 0) {
        cut_.whole.push_back(t);
      }
    }
  }

  /// What of the triangle's own border is outside all other solids.
  void emitEdges(uint32_t t) {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t a = soup_.triangles[t][i], b = soup_.triangles[t][(i + 1) % 3];
      const auto less = [](const Piercing& p, uint64_t edge) { return p.edge < edge; };
      size_t first = static_cast<size_t>(
          std::lower_bound(piercings_.begin(), piercings_.end(), edgeKey(a, b), less) -
          piercings_.begin());
      size_t end = first;
      while (end < piercings_.size() && piercings_[end].edge == edgeKey(a, b)) ++end;
      uint32_t from = a;
      int depth = depths_.of_point[a];
      for (size_t k = 0; k < end - first; ++k) {
        const size_t id = a < b ? first + k : end - 1 - k;
        const uint32_t to = static_cast<uint32_t>(soup_.points.size() + id);
        if (depth <= 0) cut_.borders.push_back({t, from, to});
        depth += piercings_[id].entering == (a < b) ? 1 : -1;
        from = to;
      }
      if (depth <= 0) cut_.borders.push_back({t, from, b});
    }
  }

  void emitSegment(uint32_t t, uint32_t id) {
    const Segment& segment = segments_[id];
    const auto put = [&](uint32_t from, uint32_t to) {
      if (segment.t == t) {
        cut_.borders.push_back({t, from, to});
      } else {
        cut_.borders.push_back({t, to, from});
      }
    };
    const uint32_t base = static_cast<uint32_t>(soup_.points.size());
    uint32_t from = base + segment.source;
    int depth = piercings_[segment.source].depth;
    auto stop = std::lower_bound(stops_.begin(), stops_.end(), id,
                                 [](const Stop& s, uint32_t wanted) { return s.segment < wanted; });
    for (; stop != stops_.end() && stop->segment == id; ++stop) {
      const uint32_t to = base + static_cast<uint32_t>(piercings_.size()) + stop->triple;
      if (depth == 0) put(from, to);
      depth += stop->step;
      from = to;
    }
    if (depth == 0) put(from, base + segment.target);
    if (depth != piercings_[segment.target].depth) fail(segment.t, segment.u);
  }

  const Soup& soup_;
  Cut cut_;
  std::vector<uint32_t> first_;  // triangle of each part; one more at the end
  std::vector<Facet> facets_;    // of triangles near other parts
  std::vector<uint32_t> facet_of_;
  std::vector<Crossing> found_;  // of the present pair of parts
  std::vector<End> ends_;
  std::vector<Segment> segments_;
  std::vector<Piercing> piercings_;  // by edge, and along it
  PointDepths depths_;
  std::vector<Triple> triples_;
  std::vector<Stop> stops_;            // by segment, and along it
  std::vector<uint32_t> of_triangle_;  // where each triangle's segments begin in the next
  std::vector<uint32_t> listed_;
};

}  // namespace

Cut cutSurfaces(const Soup& soup) { return Cutter(soup).run(); }

}  // namespace marrow
