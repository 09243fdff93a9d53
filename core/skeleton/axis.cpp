#include "skeleton/axis.h"

#include <algorithm>
#include <cmath>

#include "skeleton/axis_tree.h"
#include "skeleton/inside.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = AxisTree::kNone;
constexpr double kPi = 3.14159265358979323846;

// A limb goes on while it reaches this part of its own radius beyond its ball: to the middle of a
// blunt end, and far into a pointed one. From the first to the second it ends ever less.
constexpr double kGoesOnFrom = 0.42;
constexpr double kGoesOnTo = 0.7;
// A limb whose longest prong reaches beyond its ball goes on into it, unless the second one reaches
// more than this part as far; from the larger part on the limb ends between them.
constexpr double kForkFrom = 0.35;
constexpr double kForkTo = 0.75;
// A second prong that is so much of a limb of its own ends it as well, unless the first is more.
constexpr double kProngFrom = 0.55;
constexpr double kProngTo = 0.85;
constexpr double kLimbFrom = 0.8;
constexpr double kLimbTo = 1.1;
// Where a limb's last joint lies: this part of the limb's mean radius from the outline.
constexpr double kFromEnd = 0.9;
// Nearer, but not nearer than this, where it would be too near to the junction that the limb comes
// from: by this part of the radius there.
constexpr double kNearestEnd = 0.35;
constexpr double kLeastBone = 0.75;
constexpr double kFromEndAlone = 0.6;  // of a shape without junctions
// A body whose ball is so much of the whole area, with limbs thinner than this part of its radius,
// and none in a wide angle (150°: 1 − cos), has a bone of its own there.
constexpr double kBodyShare = 0.4;
constexpr double kBodyLimb = 0.8;
constexpr double kBodyGap = 1.87;
constexpr double kOnLine = 0.05;  // of a radius: nearer to the mirror line than this is on it
// The way from the last balls that tells where a limb points, in radii.
constexpr double kAim = 1.5;
// An axis shorter than this many radii is a point: a blob.
constexpr double kBlobLength = 0.5;
// A blob that is hardly longer than wide has its bone upright: by this part of its second moments.
constexpr double kUpright = 0.04;
// Ends nearer than this many radii to the end of the axis are no others than that.
constexpr double kLeastStep = 0.1;

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

class Extracting {
 public:
  Extracting(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
             const AxisOptions& options)
      : polygon_(polygon),
        mirror_(options.mirror ? &*options.mirror : nullptr),
        tree_(polygon, skeleton) {
    if (options.hints) tree_.remember(options.hints->ends);
  }

  Axis run() {
    keep();
    Axis axis;
    if (isBlob()) {
      axis = blob();
    } else {
      finishEnds();
      for (uint32_t i = 0; i < kept_.size(); ++i) {
        axis.points.push_back(kept_[i].point);
        axis.radii.push_back(kept_[i].radius);
        if (kept_[i].parent != kNone) axis.edges.push_back({kept_[i].parent, i});
      }
    }
    return axis;
  }

 private:
  struct Kept {
    Vec2 point;
    double radius;
    uint32_t parent;  // in kept_
    uint32_t node;    // of the tree
    uint32_t children = 0;
    double ends = 1;       // see endingAt
    bool goes_on = false;  // to an end that is no node
    double inside = 0;     // how far it still is to where the limb leaves the ball of its junction
  };

  /// The part of the tree whose sides are limbs.
  void keep() {
    kept_.push_back({tree_[tree_.root()].point, tree_[tree_.root()].radius, kNone, tree_.root()});
    for (uint32_t k = 0; k < kept_.size(); ++k) {
      const uint32_t at = kept_[k].node;
      std::vector<uint32_t> limbs;
      for (const uint32_t child : tree_.neighbours(at)) {
        if (child != tree_[at].parent && tree_.significance(child) >= 1) limbs.push_back(child);
      }
      if (k == 0 || limbs.size() > 1) {
        for (const uint32_t child : limbs) add(child, k, true);
        continue;
      }
      const uint32_t next = limbs.empty() ? tree_[at].onward : limbs[0];
      if (next == kNone) continue;
      const Ending ending = endingAt(at, next, kept_[k].inside > 0);
      kept_[k].ends = ending.share;
      if (ending.goes_on) add(next, k, false);
    }
  }

  void add(uint32_t child, uint32_t parent, bool begins) {
    const auto& node = tree_[child];
    Kept next{node.point, node.radius, parent, child};
    next.inside = (begins ? kept_[parent].radius : kept_[parent].inside) - node.to_parent;
    kept_.push_back(next);
    ++kept_[parent].children;
  }

  /// The child in which a limb without branches goes on.
  uint32_t onwardFrom(uint32_t at) const {
    const auto& node = tree_[at];
    uint32_t found = kNone;
    for (const uint32_t child : tree_.neighbours(at)) {
      if (child == node.parent || tree_.significance(child) < 1) continue;
      if (found != kNone) return kNone;
      found = child;
    }
    return found == kNone ? node.onward : found;
  }

  /// Whether a limb ends at a node, before its child.
  struct Ending {
    double share = 1;      // 0: not at all, 1: plainly
    bool goes_on = false;  // not at all, beyond all doubt
  };
  Ending endingAt(uint32_t at, uint32_t child, bool inside) const {
    const auto& node = tree_[at];
    double second = node.tip, limb = 0;
    for (const uint32_t other : tree_.neighbours(at)) {
      if (other == node.parent || other == child) continue;
      const double reach = tree_[other].to_parent + tree_[other].reach;
      if (!(reach > second)) continue;
      second = reach;
      limb = tree_.significance(other);
    }
    const double proud = tree_.proud(child);
    if (!(proud > 0)) return {1, false};
    const double fork = ((second - node.radius) / proud - kForkFrom) / (kForkTo - kForkFrom);
    // A prong that is a limb of its own goes on beside one that is nothing.
    const double own = tree_.significance(child);
    const double prong = inside ? 0 : (limb - kProngFrom) / (kProngTo - kProngFrom);
    const double nearly =
        std::clamp(std::max(prong, (kLimbTo - own) / (kLimbTo - kLimbFrom)), 0.0, 1.0);
    const double on = std::max((proud / node.radius - kGoesOnFrom) / (kGoesOnTo - kGoesOnFrom),
                               (own - kGoesOnFrom) / (1 - kGoesOnFrom));
    const double goes = inside ? 1 : std::clamp(on, 0.0, 1.0);
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
    if (kPi * root.radius * root.radius < kBodyShare * signedArea(polygon_)) return;
    if (bodyGoesOn()) return;
    const Vec2 way = widestGap(waysFromRoot());
    if (!(length(way) > 0)) return;
    const double room = exitOf(polygon_, root.point, way);
    const double reach = std::min(kLeastBone * root.radius, room - kNearestEnd * root.radius);
    const Vec2 place = root.point + way * reach;
    if (!segmentInside(polygon_, root.point, place)) return;
    kept_.push_back({place, distanceToBorder(polygon_, place), 0, kNone});
    ++kept_[0].children;
  }

  /// Whether the body itself is longer than its ball, nearly as wide.
  bool bodyGoesOn() const {
    const Kept& root = kept_[0];
    for (const uint32_t child : tree_.neighbours(root.node)) {
      uint32_t at = child;
      double along = tree_[at].to_parent;
      while (along < root.radius / 2 && tree_[at].onward != kNone) {
        at = tree_[at].onward;
        along += tree_[at].to_parent;
      }
      if (along >= root.radius / 2 && tree_[at].radius > kBodyLimb * root.radius) return true;
    }
    return false;
  }

  /// Where limbs leave the root's ball, or end in it: unit vectors.
  std::vector<Vec2> waysFromRoot() const {
    const Kept& root = kept_[0];
    std::vector<Vec2> ways;
    for (uint32_t i = 1; i < kept_.size(); ++i) {
      const Kept& one = kept_[i];
      const Vec2 away = one.point - root.point, before = kept_[one.parent].point - root.point;
      const bool ends = one.children == 0 && !one.goes_on && length(away) < root.radius;
      const bool leaves = length(away) >= root.radius && length(before) < root.radius;
      if ((ends || leaves) && length(away) > 0) ways.push_back(away / length(away));
    }
    return ways;
  }

  /// The middle of the widest angle without ways, if that is wide: a unit vector; else none.
  static Vec2 widestGap(const std::vector<Vec2>& ways) {
    double widest = 0;  // grows with the angle: 2 for half a turn
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
    const double size = length(middle);
    return widest >= kBodyGap && size > 0 ? middle / size : Vec2{};
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
      inside -= tree_[i].to_parent;
      longer.insert(longer.begin(), tree_[i].point);
      places.push_back(bluntEnd(longer, tree_[i].radius, limb, ball));
      const uint32_t next = onwardFrom(i);
      ends.push_back(next == kNone ? 1
                                   : std::max(ends.back(), endingAt(i, next, inside > 0).share));
    }
    Vec2 place = places[0] * ends[0];
    for (size_t k = 1; k < places.size(); ++k) place = place + places[k] * (ends[k] - ends[k - 1]);
    place = place + places.back() * (1 - ends.back());
    if (!(distance(place, end.point) > kLeastStep * end.radius)) return;
    if (!segmentInside(polygon_, end.point, place)) return;
    kept_.push_back({place, distanceToBorder(polygon_, place), way[0], kNone});
    kept_[way[0]].goes_on = true;
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
        ball > 0
            ? std::min(kFromEnd * limb, std::max(kNearestEnd * limb, total - kLeastBone * ball))
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
    Vec2 twice{(xx - yy) / all - kUpright, 2 * xy / all};
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
    for (const Vec2 point : axis.points) axis.radii.push_back(distanceToBorder(polygon_, point));
    return axis;
  }

  const std::vector<Vec2>& polygon_;
  const MirrorLine* mirror_;
  AxisTree tree_;
  std::vector<Kept> kept_;
};

}  // namespace

Result<Axis> extractAxis(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
                         const AxisOptions& options) {
  const size_t n = polygon.size();
  if (n < 3 || skeleton.nodes.size() <= n || skeleton.times.size() != skeleton.nodes.size()) {
    return Status::skeletonFailed;
  }
  Axis axis = Extracting(polygon, skeleton, options).run();
  if (axis.edges.empty() || axis.points.size() != axis.edges.size() + 1) {
    return Status::skeletonFailed;
  }
  return axis;
}

}  // namespace marrow
