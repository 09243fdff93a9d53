#include "skeleton/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "skeleton/inside.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

using Kind = StraightSkeleton::Kind;

constexpr uint32_t kNone = 0xFFFFFFFF;

// A branch is a limb of its own where it reaches beyond the ball that it leaves by this part of the
// shape's size,
constexpr double kLeastReach = 0.035;
// and either by so many of its own radii where it leaves the ball (the corner of a square: 1.41, a
// half disc: 1) or by so much of the ball's radius (the corner of a square: 0.41).
constexpr double kSlender = 1.6;
constexpr double kProud = 0.6;
// A limb goes on while it reaches this part of its own radius beyond its ball: to the middle of a
// blunt end, and far into a pointed one.
constexpr double kGoesOnFrom = 0.42;
constexpr double kGoesOnTo = 0.7;
// A limb whose longest prong reaches beyond its ball goes on into it, unless the second one reaches
// more than this part as far; from the larger part on the limb ends between them.
constexpr double kForkFrom = 0.35;
constexpr double kForkTo = 0.75;
// and is nearly a limb of its own.
constexpr double kProngFrom = 0.55;
constexpr double kProngTo = 0.85;
constexpr double kLimbFrom = 0.8;
constexpr double kLimbTo = 1.1;
// Where a limb's last joint lies: this part of the limb's mean radius from the outline.
static const double kFromEnd = std::getenv("FROMEND") ? std::atof(std::getenv("FROMEND")) : 0.9;
// Nearer, but not nearer than this, where it would be too near to the junction that the limb comes
// from: by this part of the radius there.
constexpr double kNearestEnd = 0.35;
constexpr double kFromEndAlone = 0.6;  // of a shape without junctions
constexpr double kLeastBone = 0.75;
// A body with limbs thinner than this part of its radius alone, and none in more than so wide an
// angle (150°), has a bone of its own there.
constexpr double kBodyLimb = 0.8;
constexpr double kBodyShare = 0.4;  // of the whole area, at least
constexpr double kOnLine = 0.05;
constexpr double kBodyGap = 1.87;
// The way from the last balls that tells where a limb points, in radii.
constexpr double kAim = 1.5;
// An axis shorter than this many radii is a point: a blob.
constexpr double kBlobLength = 0.5;
// Joints nearer than this part of a radius to the end of the axis are no others than that.
constexpr double kLeastStep = 0.1;
constexpr double kTie = 1e-9;

bool isReflex(const std::vector<Vec2>& polygon, size_t i) {
  const size_t n = polygon.size();
  const Vec2 before = polygon[i > 0 ? i - 1 : n - 1], after = polygon[i + 1 < n ? i + 1 : 0];
  return cross(polygon[i] - before, after - polygon[i]) <= 0;
}

/// Where the ray from `from` leaves the polygon.
double exitOf(const std::vector<Vec2>& polygon, Vec2 from, Vec2 direction) {
  double nearest = -1;
  Vec2 p = polygon.back();
  double side_p = cross(direction, p - from);
  for (const Vec2 q : polygon) {
    const double side_q = cross(direction, q - from);
    if ((side_p < 0) != (side_q < 0)) {
      const double t = cross(p - from, q - p) / cross(direction, q - p);
      if (t > 0 && (nearest < 0 || t < nearest)) nearest = t;
    }
    p = q;
    side_p = side_q;
  }
  return std::max(nearest, 0.0);
}

/// The inner arcs of a straight skeleton, seen from the node with the largest ball.
class Tree {
 public:
  struct Node {
    Vec2 point;
    double radius;
    uint32_t parent = kNone;
    double to_parent = 0;
    uint32_t first = 0, count = 0;  // of its neighbours in `around`
    double tip = 0;                 // the longest arc from here to a convex corner of the polygon
    double reach = 0;               // the longest way to a corner, away from the root
    uint32_t onward = kNone;        // the child on that way; none: an arc to a corner
    bool parent_is_a = false;
    uint32_t left = kNone, right = kNone;  // border edges beside the arc to the parent
  };

  Tree(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton) {
    const uint32_t n = static_cast<uint32_t>(polygon.size());
    const uint32_t count = static_cast<uint32_t>(skeleton.nodes.size()) - n;
    nodes.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
      nodes[i].point = skeleton.nodes[n + i];
      nodes[i].radius = skeleton.times[n + i];
    }
    for (const auto& edge : skeleton.edges) {
      if (edge.kind == Kind::skeleton) {
        ++nodes[edge.a - n].count;
        ++nodes[edge.b - n].count;
      } else if (edge.kind == Kind::peripheral) {
        const uint32_t corner = std::min(edge.a, edge.b);
        if (isReflex(polygon, corner)) continue;
        Node& node = nodes[std::max(edge.a, edge.b) - n];
        node.tip = std::max(node.tip, distance(node.point, polygon[corner]));
      }
    }
    uint32_t begin = 0;
    for (Node& node : nodes) {
      node.first = begin;
      begin += node.count;
      node.count = 0;
    }
    around.resize(begin);
    arc_of.resize(begin);
    for (const auto& edge : skeleton.edges) {
      if (edge.kind != Kind::skeleton) continue;
      Node &a = nodes[edge.a - n], &b = nodes[edge.b - n];
      arc_of[a.first + a.count] = arc_of[b.first + b.count] = static_cast<uint32_t>(&edge - skeleton.edges.data());
      around[a.first + a.count++] = edge.b - n;
      around[b.first + b.count++] = edge.a - n;
    }
    for (uint32_t i = 1; i < count; ++i) {
      if (nodes[i].radius > nodes[root].radius * (1 + kTie)) root = i;
    }
    order.reserve(count);
    order.push_back(root);
    for (size_t k = 0; k < order.size(); ++k) {
      for (const uint32_t& child : childrenOf(order[k])) {
        if (child == nodes[order[k]].parent) continue;
        nodes[child].parent = order[k];
        const auto& arc = skeleton.edges[arc_of[nodes[order[k]].first + static_cast<uint32_t>(&child - childrenOf(order[k]).begin())]];
        nodes[child].parent_is_a = arc.a - n == order[k];
        nodes[child].left = arc.left;
        nodes[child].right = arc.right;
        nodes[child].to_parent = distance(nodes[child].point, nodes[order[k]].point);
        order.push_back(child);
      }
    }
    for (size_t k = order.size(); k-- > 0;) {
      Node& node = nodes[order[k]];
      if (node.tip > node.reach) {
        node.reach = node.tip;
        node.onward = kNone;
      }
      if (node.parent == kNone) continue;
      Node& parent = nodes[node.parent];
      const double reach = node.reach + node.to_parent;
      if (reach > parent.reach) {
        parent.reach = reach;
        parent.onward = order[k];
      }
    }
  }

  struct Range {
    const uint32_t *from, *to;
    const uint32_t* begin() const { return from; }
    const uint32_t* end() const { return to; }
  };
  /// And the parent.
  Range childrenOf(uint32_t i) const {
    const uint32_t* first = around.data() + nodes[i].first;
    return {first, first + nodes[i].count};
  }

  /// How far the child's side reaches beyond the ball of its parent.
  double proud(uint32_t child) const {
    const Node& node = nodes[child];
    return node.to_parent + node.reach - nodes[node.parent].radius;
  }

  double opening(const std::vector<Vec2>& polygon, uint32_t child) const {
    const Vec2 x = nodes[nodes[child].parent].point;
    Vec2 foot[2];
    int k = 0;
    for (const uint32_t e : {nodes[child].left, nodes[child].right}) {
      const Vec2 a = polygon[e], b = polygon[e + 1 < polygon.size() ? e + 1 : 0], along = b - a;
      const double t = std::clamp(dot(x - a, along) / dot(along, along), 0.0, 1.0);
      foot[k] = a + along * t - x;
      foot[k] = foot[k] / length(foot[k]);
      ++k;
    }
    return dot(foot[0], foot[1]);
  }

  double beyond(const std::vector<Vec2>& polygon, uint32_t child) const {
    const Vec2 x = nodes[nodes[child].parent].point;
    // which of left/right comes first counter-clockwise: going from parent to child, right edge first
    uint32_t e[2] = {nodes[child].right, nodes[child].left};
    if (!nodes[child].parent_is_a) std::swap(e[0], e[1]);
    Vec2 foot[2], n[2];
    for (int k = 0; k < 2; ++k) {
      const Vec2 a = polygon[e[k]], b = polygon[e[k] + 1 < polygon.size() ? e[k] + 1 : 0], along = b - a;
      const double t = std::clamp(dot(x - a, along) / dot(along, along), 0.0, 1.0);
      foot[k] = a + along * t;
      n[k] = (foot[k] - x) / length(foot[k] - x);
    }
    double most = 0, area = 0;
    Vec2 last = foot[0];
    for (uint32_t i = e[0]; i != e[1];) {
      i = i + 1 < polygon.size() ? i + 1 : 0;
      const bool end = i == e[1] ;
      for (int k = 0; k < 2; ++k) {
        most = std::max(most, dot(polygon[i] - foot[k], n[k]));
        const double d0 = std::max(0.0, dot(last - foot[k], n[k])), d1 = std::max(0.0, dot(polygon[i] - foot[k], n[k]));
        area += (d0 + d1) / 2 * dot(polygon[i] - last, perpendicular(n[k])) * 1;
      }
      (void)end;
      last = polygon[i];
    }
    static const bool kArea = std::getenv("AREA");
    return kArea ? std::sqrt(std::max(0.0, area)) : most;
  }

  /// The radius where the way to the child's tip leaves the ball of its parent.
  double mouth(uint32_t child) const {
    double left = nodes[nodes[child].parent].radius;
    double before = left;
    for (uint32_t i = child;;) {
      const Node& node = nodes[i];
      if (left <= node.to_parent) {
        const double t = node.to_parent > 0 ? left / node.to_parent : 1;
        return before + (node.radius - before) * t;
      }
      left -= node.to_parent;
      before = node.radius;
      if (node.onward == kNone) {
        return node.tip > 0 ? before * std::max(0.0, 1 - left / node.tip) : 0;
      }
      i = node.onward;
    }
  }

  std::vector<Node> nodes;
  std::vector<uint32_t> around, arc_of;
  std::vector<uint32_t> order;  // parents before children
  uint32_t root = 0;
};

class Extracting {
 public:
  Extracting(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
             const MirrorLine* mirror)
      : polygon_(polygon), mirror_(mirror), tree_(polygon, skeleton) {
    const double across = std::sqrt(std::fabs(signedArea(polygon)));
    const double round = perimeter(polygon);
    size_ = 0; (void)across; (void)round;
    const Vec2 c = areaCentroid(polygon);
    for (const Vec2 p : polygon) size_ = std::max(size_, 2 * distance(p, c));
  }

  Axis run() {
    keep();
    Axis axis;
    if (isBlob()) {
      axis = blob();
    } else {
      finishEnds();
      std::vector<uint32_t> renamed(kept_.size());
      for (uint32_t i = 0; i < kept_.size(); ++i) {
        renamed[i] = static_cast<uint32_t>(axis.points.size());
        axis.points.push_back(kept_[i].point);
        if (kept_[i].parent != kNone) axis.edges.push_back({renamed[kept_[i].parent], renamed[i]});
      }
    }
    for (const Vec2 point : axis.points) axis.radii.push_back(distanceToBorder(polygon_, point));
    return axis;
  }

 private:
  struct Kept {
    Vec2 point;
    double radius;
    uint32_t parent;  // in kept_
    uint32_t node;    // of the tree
    uint32_t children = 0;
    double ends = 1;  // see endingAt
    double inside = 0;  // how far it still is to where the limb leaves the ball of its junction
  };

  double significance(uint32_t child) const {
    const double proud = tree_.proud(child);
    const double ball = tree_.nodes[tree_.nodes[child].parent].radius;
    const double mouth = tree_.mouth(child);
    const double slender = mouth > 0 ? proud / mouth : 0;
    if (std::getenv("AXIS")) {
      const double bulge0 = tree_.beyond(polygon_, child); const double c = tree_.opening(polygon_, child), half = std::sqrt(std::max(0.0, (1 + c) / 2));
      if (proud > 0.015 * size_) std::fprintf(stderr, "at %.0f %.0f R %.0f  S/size %.3f S/R %.2f slender %.2f phi %.0f SCORE %.3f D/size %.3f D/R %.2f %s\n", tree_.nodes[tree_.nodes[child].parent].point.x, tree_.nodes[tree_.nodes[child].parent].point.y, ball, proud/size_, proud/ball, slender, 2*std::acos(half)*57.3, (bulge0 / 0.6 + proud / 0.45) / (ball + 0.1 * size_) / 0.85, tree_.beyond(polygon_,child)/size_, tree_.beyond(polygon_,child)/ball, tree_.nodes[tree_.nodes[child].parent].onward == child ? "onward":"");
    }
    const double bulge = tree_.beyond(polygon_, child);
    static const double kBulge = std::getenv("BULGE") ? std::atof(std::getenv("BULGE")) : 0.6;
    static const double kLeast = std::getenv("LEAST") ? std::atof(std::getenv("LEAST")) : 0.04;
    static const double kPr = std::getenv("PROUD") ? std::atof(std::getenv("PROUD")) : 0.45;
    static const double kC = std::getenv("SIZEC") ? std::atof(std::getenv("SIZEC")) : 0.0;
    static const double kScore = std::getenv("SCORE") ? std::atof(std::getenv("SCORE")) : 1.25;
    (void)slender;
    return std::min(proud / (kLeast * size_), (bulge / kBulge + proud / kPr) / (ball + kC * size_) / kScore);
  }

  void keep() {
    kept_.push_back({tree_.nodes[tree_.root].point, tree_.nodes[tree_.root].radius, kNone,
                     tree_.root});
    for (uint32_t k = 0; k < kept_.size(); ++k) {
      const uint32_t at = kept_[k].node;
      const auto& node = tree_.nodes[at];
      std::vector<uint32_t> significant;
      for (const uint32_t child : tree_.childrenOf(at)) {
        if (child != node.parent && significance(child) >= 1) significant.push_back(child);
      }
      if (k > 0 && significant.size() < 2) {
        const uint32_t next = significant.empty() ? node.onward : significant[0];
        if (next == kNone) continue;
        const Ending ending = endingAt(at, next, kept_[k].inside > 0);
        kept_[k].ends = ending.share;
        if (ending.decided && ending.share <= 0) add(next, k, false);
        continue;
      }
      for (const uint32_t child : significant) add(child, k, true);
    }
  }

  void add(uint32_t child, uint32_t parent, bool begins) {
    const auto& node = tree_.nodes[child];
    Kept next{node.point, node.radius, parent, child};
    next.inside = (begins ? kept_[parent].radius : kept_[parent].inside) - node.to_parent;
    kept_.push_back(next);
    ++kept_[parent].children;
  }

  /// The child in which a limb without branches goes on.
  uint32_t onwardFrom(uint32_t at) const {
    const auto& node = tree_.nodes[at];
    uint32_t found = kNone;
    for (const uint32_t child : tree_.childrenOf(at)) {
      if (child == node.parent || significance(child) < 1) continue;
      if (found != kNone) return kNone;
      found = child;
    }
    return found == kNone ? node.onward : found;
  }

  /// Whether a limb ends at a node, before its child.
  struct Ending {
    double share = 1;     // 0: not at all, 1: plainly
    bool decided = true;  // goes on without ending anywhere else
  };
  Ending endingAt(uint32_t at, uint32_t child, bool inside) const {
    const auto& node = tree_.nodes[at];
    double second = node.tip, limb = 0;
    for (const uint32_t other : tree_.childrenOf(at)) {
      if (other == node.parent || other == child) continue;
      const double reach = tree_.nodes[other].to_parent + tree_.nodes[other].reach;
      if (!(reach > second)) continue;
      second = reach;
      limb = significance(other);
    }
    const double proud = tree_.proud(child);
    if (!(proud > 0)) return {1, true};
    const double fork = ((second - node.radius) / proud - kForkFrom) / (kForkTo - kForkFrom);
    // A prong that is a limb of its own goes on beside one that is nothing.
    const double own = significance(child);
    const double prong = inside ? 0 : (limb - kProngFrom) / (kProngTo - kProngFrom);
    const double nearly =
        std::clamp(std::max(prong, (kLimbTo - own) / (kLimbTo - kLimbFrom)), 0.0, 1.0);
    const double on = std::max((proud / node.radius - kGoesOnFrom) / (kGoesOnTo - kGoesOnFrom),
                               (own - kGoesOnFrom) / (1 - kGoesOnFrom));
    const double goes = inside ? 1 : std::clamp(on, 0.0, 1.0);
    if (std::getenv("ENDS") && fork > 0) std::fprintf(stderr, "[at %.0f %.0f R %.0f S1 %.0f fork %.2f M1 %.2f M2 %.2f inside %d]\n", node.point.x, node.point.y, node.radius, proud, fork, own, limb, inside);
    return {1 - std::clamp(1 - fork * nearly, 0.0, 1.0) * goes, fork <= 0 && goes >= 1};
  }

  bool isBlob() const {
    double total = 0;
    for (const Kept& kept : kept_) {
      if (kept.children > (kept.parent == kNone ? 2u : 1u)) return false;
      if (kept.parent != kNone) total += distance(kept.point, kept_[kept.parent].point);
    }
    return total <= kBlobLength * kept_[0].radius;
  }

  void finishEnds() {
    const uint32_t count = static_cast<uint32_t>(kept_.size());
    const bool root_ends = kept_[0].children == 1;
    std::vector<uint32_t> child(count, kNone);
    for (uint32_t i = 1; i < count; ++i) child[kept_[i].parent] = i;
    for (uint32_t i = 1; i < count; ++i) {
      if (kept_[i].children > 0) continue;
      std::vector<uint32_t> way{i};
      while (way.back() != 0 && (way.size() == 1 || kept_[way.back()].children == 1)) {
        way.push_back(kept_[way.back()].parent);
      }
      finishEnd(way);
    }
    if (!root_ends) return addBody();
    std::vector<uint32_t> way{0};
    while (kept_[way.back()].children == 1) way.push_back(child[way.back()]);
    finishEnd(way);
  }

  /// A body whose limbs all leave it on one side gets a bone towards the other.
  void addBody() {
    const Kept root = kept_[0];
    if (mirror_ && std::fabs(mirror_->side(root.point)) > kOnLine * root.radius) return;
    const double ball = 3.14159265358979 * root.radius * root.radius;
    if (ball < kBodyShare * signedArea(polygon_)) return;
    const uint32_t count = static_cast<uint32_t>(kept_.size());
    // Where its limbs leave its ball, or end in it.
    std::vector<Vec2> ways;
    for (uint32_t i = 1; i < count; ++i) {
      const Kept& one = kept_[i];
      const Vec2 away = one.point - root.point, before = kept_[one.parent].point - root.point;
      const bool ends = one.children == 0 && length(away) < root.radius;
      const bool leaves = length(away) >= root.radius && length(before) < root.radius;
      if ((ends || leaves) && length(away) > 0) ways.push_back(away / length(away));
    }
    for (const uint32_t child : tree_.childrenOf(root.node)) {
      // Is it the body that goes on there?
      uint32_t at = child;
      double along = tree_.nodes[at].to_parent;
      while (along < 0.5 * root.radius && tree_.nodes[at].onward != kNone) {
        at = tree_.nodes[at].onward;
        along += tree_.nodes[at].to_parent;
      }
      if (along >= 0.5 * root.radius && tree_.nodes[at].radius > kBodyLimb * root.radius) return;
    }
    if (ways.size() < 2) return;
    // The widest gap between them, counter-clockwise; it grows with the angle: 2 for half a turn.
    double widest = 0;
    Vec2 middle;
    for (const Vec2 a : ways) {
      double least = 4;
      Vec2 next;
      for (const Vec2 b : ways) {
        const double turn = cross(a, b) >= 0 ? 1 - dot(a, b) : 3 + dot(a, b);
        if (b == a || turn >= least) continue;
        least = turn;
        next = b;
      }
      if (!(least < 4) || least <= widest) continue;
      widest = least;
      middle = perpendicular(a) - perpendicular(next);
    }
    if (widest < kBodyGap || !(length(middle) > 0)) return;
    middle = middle / length(middle);
    const double room = exitOf(polygon_, root.point, middle);
    const Vec2 place = root.point + middle * std::min(kLeastBone * root.radius,
                                                     room - kNearestEnd * root.radius);
    if (!segmentInside(polygon_, root.point, place)) return;
    kept_.push_back({place, distanceToBorder(polygon_, place), 0, kNone});
    ++kept_[0].children;
  }

  /// way: from an end to the next junction or the other end.
  void finishEnd(const std::vector<uint32_t>& way) {
    std::vector<Vec2> line;
    for (const uint32_t i : way) line.push_back(kept_[i].point);
    const Kept end = kept_[way[0]];
    // What lies in the ball of the junction is none of the limb.
    const Vec2 base = line.back();
    const bool alone = kept_[way.back()].children < 2 || way.back() == way[0];
    const double ball = alone ? 0 : kept_[way.back()].radius;
    double radii = 0, total = 0;
    for (size_t k = 0; k + 1 < way.size(); ++k) {
      if (k > 0 && distance(line[k], base) < ball) break;
      const double step = distance(line[k], line[k + 1]);
      radii += step * (kept_[way[k]].radius + kept_[way[k + 1]].radius) / 2;
      total += step;
    }
    const double limb = std::max(total > 0 ? radii / total : 0, end.radius);
    // Where it may end or go on, it ends between what comes of both.
    std::vector<Vec2> places{bluntEnd(line, end.radius, limb, ball)};
    std::vector<double> ends{end.ends};
    std::vector<Vec2> longer = line;
    double inside = end.inside;
    for (uint32_t i = end.node; i != kNone && ends.back() < 1;) {
      i = onwardFrom(i);
      if (i == kNone) break;
      inside -= tree_.nodes[i].to_parent;
      longer.insert(longer.begin(), tree_.nodes[i].point);
      places.push_back(bluntEnd(longer, tree_.nodes[i].radius, limb, ball));
      const uint32_t next = onwardFrom(i);
      ends.push_back(next == kNone ? 1 : std::max(ends.back(), endingAt(i, next, inside > 0).share));
    }
    if (std::getenv("ENDS")) { for (size_t k = 0; k < places.size(); ++k) std::fprintf(stderr, "(%.0f %.0f R %.0f w %.2f -> %.0f %.0f) ", longer[places.size()-1-k].x, longer[places.size()-1-k].y, k==0?end.radius:0, ends[k], places[k].x, places[k].y); std::fprintf(stderr, " limb %.0f ball %.0f\n", limb, ball); }
    Vec2 place = places[0] * ends[0];
    for (size_t k = 1; k < places.size(); ++k) place = place + places[k] * (ends[k] - ends[k - 1]);
    place = place + places.back() * (1 - ends.back());
    if (distance(place, end.point) > kLeastStep * end.radius && segmentInside(polygon_, end.point, place)) {
      kept_.push_back({place, distanceToBorder(polygon_, place), way[0], kNone});
      return;
    }
    (void)0;
  }

  /// Where a limb has its last joint, on or behind the end of its axis, which is the line's front.
  /// ball: of the junction at the line's back, 0 where there is none.
  Vec2 bluntEnd(const std::vector<Vec2>& line, double radius, double limb, double ball) const {
    Vec2 from = line.back();
    double back = 0;
    for (size_t k = 0; k + 1 < line.size(); ++k) {
      const double step = distance(line[k], line[k + 1]);
      if (back + step >= kAim * radius) {
        from = lerp(line[k], line[k + 1], step > 0 ? (kAim * radius - back) / step : 1);
        break;
      }
      back += step;
    }
    const Vec2 towards = line.front() - from;
    const double size = length(towards);
    if (!(size > 0)) return line.front();
    const double room = exitOf(polygon_, line.front(), towards / size);
    double total = room;
    for (size_t k = 0; k + 1 < line.size(); ++k) total += distance(line[k], line[k + 1]);
    const double from_end =
        ball > 0 ? std::min(kFromEnd * limb, std::max(kNearestEnd * limb, total - kLeastBone * ball))
                 : kFromEndAlone * limb;
    return line.front() + towards * (std::max(0.0, room - from_end) / size);
  }

  /// One bone along the longer direction of the area; of what has none, upright.
  Axis blob() const {
    const Vec2 middle = kept_[0].point;
    double xx = 0, xy = 0, yy = 0, all = 0;
    const Vec2 centre = areaCentroid(polygon_);
    Vec2 p = polygon_.back() - centre;
    for (const Vec2 vertex : polygon_) {
      const Vec2 q = vertex - centre;
      const double area = cross(p, q);
      xx += area * (p.x * p.x + p.x * q.x + q.x * q.x);
      yy += area * (p.y * p.y + p.y * q.y + q.y * q.y);
      xy += area * (2 * p.x * p.y + p.x * q.y + q.x * p.y + 2 * q.x * q.y) / 2;
      p = q;
    }
    all = xx + yy;
    // The doubled angle of the longer direction, as long as that is clear; and a little upright.
    Vec2 twice{(xx - yy) / all - 0.04, 2 * xy / all};
    const double size = length(twice);
    twice = size > 0 ? twice / size : Vec2{-1, 0};
    Vec2 direction{std::sqrt(std::max(0.0, (1 + twice.x) / 2)),
                   std::sqrt(std::max(0.0, (1 - twice.x) / 2))};
    if (twice.y < 0) direction.y = -direction.y;
    const double ahead = exitOf(polygon_, middle, direction),
                 behind = exitOf(polygon_, middle, -direction);
    const double end = kFromEndAlone * kept_[0].radius;
    Axis axis;
    axis.points = {middle - direction * std::max(behind - end, behind * 0.5),
                   middle + direction * std::max(ahead - end, ahead * 0.5)};
    axis.edges = {{0, 1}};
    return axis;
  }

  const std::vector<Vec2>& polygon_;
  const MirrorLine* mirror_;
  Tree tree_;
  double size_ = 0;
  std::vector<Kept> kept_;
};

}  // namespace

Result<Axis> extractAxis(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
                         const AxisOptions& options) {
  const size_t n = polygon.size();
  if (n < 3 || skeleton.nodes.size() <= n || skeleton.times.size() != skeleton.nodes.size()) {
    return Status::skeletonFailed;
  }
  Axis axis = Extracting(polygon, skeleton, options.mirror ? &*options.mirror : nullptr).run();
  if (axis.edges.empty() || axis.points.size() != axis.edges.size() + 1) {
    return Status::skeletonFailed;
  }
  return axis;
}

}  // namespace marrow
