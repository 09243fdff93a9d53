#include "skeleton/axis.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "skeleton/inside.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

using Kind = StraightSkeleton::Kind;

// A tip counts as a limb of its own when it reaches this many inscribed radii from where it starts:
// the corner of a square reaches 1.41, that of an equilateral triangle 2.
constexpr double kSpikeReach = 2.5;
constexpr double kSpikeReachBetweenNotches = 1.6;  // both neighbours of the tip are reflex
constexpr double kBranchReach = 1.5;
// Where the joint of a sharp tip goes: a quarter of the spike's base radius is left there.
constexpr double kSpikePart = 0.75;
// An axis shorter than this many inscribed radii is a point: a blob.
constexpr double kBlobLength = 0.5;
// How far the one bone of a blob goes from the middle to the border on either side.
constexpr double kDiameterPart = 0.5;
// An edge that moves in a collapse keeps this part of its smaller ball free.
constexpr double kClearance = 0.5;
// Lengths and radii that differ by less than this part count as equal, so that rounding does not
// decide between symmetric choices.
constexpr double kTie = 1e-9;

struct Tree {
  std::vector<Vec2> points;
  std::vector<double> radii;
  std::vector<double> reach;  // how far the shape goes beyond the node, were it a terminal
  std::vector<std::vector<uint32_t>> neighbours;
  std::vector<char> alive;

  size_t degree(uint32_t i) const { return neighbours[i].size(); }

  uint32_t add(Vec2 point, double radius) {
    points.push_back(point);
    radii.push_back(radius);
    reach.push_back(radius);
    neighbours.emplace_back();
    alive.push_back(1);
    return static_cast<uint32_t>(points.size() - 1);
  }
  void connect(uint32_t a, uint32_t b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  void disconnect(uint32_t a, uint32_t b) {
    auto& list = neighbours[a];
    list.erase(std::find(list.begin(), list.end(), b));
  }
  void removeLeaf(uint32_t leaf) {
    if (degree(leaf) == 1) disconnect(neighbours[leaf][0], leaf);
    neighbours[leaf].clear();
    alive[leaf] = 0;
  }
};

bool isReflex(const std::vector<Vec2>& polygon, size_t i) {
  const size_t n = polygon.size();
  const Vec2 before = polygon[(i + n - 1) % n], after = polygon[(i + 1) % n];
  return cross(polygon[i] - before, after - polygon[i]) <= 0;
}

/// The inner arcs, and of the arcs into sharp convex tips the greater part.
Tree innerTree(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton) {
  const uint32_t n = static_cast<uint32_t>(polygon.size());
  Tree tree;
  for (size_t i = n; i < skeleton.nodes.size(); ++i) {
    tree.add(skeleton.nodes[i], skeleton.times[i]);
  }
  for (const auto& edge : skeleton.edges) {
    if (edge.kind == Kind::skeleton) tree.connect(edge.a - n, edge.b - n);
  }
  for (const auto& edge : skeleton.edges) {
    if (edge.kind != Kind::peripheral) continue;
    const uint32_t tip = std::min(edge.a, edge.b), node = std::max(edge.a, edge.b) - n;
    if (isReflex(polygon, tip)) continue;
    const Vec2 at = tree.points[node];
    const double radius = tree.radii[node], reach = distance(at, polygon[tip]);
    tree.reach[node] = std::max(tree.reach[node], reach);
    const bool notches = isReflex(polygon, (tip + n - 1) % n) && isReflex(polygon, (tip + 1) % n);
    const double needed = (notches ? kSpikeReachBetweenNotches : kSpikeReach) * radius;
    if (reach < needed * (1 + kTie)) continue;
    const uint32_t leaf = tree.add(lerp(at, polygon[tip], kSpikePart), radius * (1 - kSpikePart));
    tree.reach[leaf] = reach * (1 - kSpikePart);
    tree.connect(node, leaf);
  }
  return tree;
}

double meanLength(const Tree& tree) {
  double sum = 0;
  size_t count = 0;
  for (uint32_t i = 0; i < tree.points.size(); ++i) {
    for (const uint32_t j : tree.neighbours[i]) {
      if (j < i) continue;
      sum += distance(tree.points[i], tree.points[j]);
      ++count;
    }
  }
  return count ? sum / count : 0;
}

/// Takes away, round by round and in each round all at once, the terminal branches whose tips do
/// not stand out from the ball at their junction: corners of blocks, bumps of a trembling hand.
void pruneBumps(Tree& tree) {
  struct Branch {
    std::vector<uint32_t> nodes;  // from the leaf on, without the junction
    uint32_t junction;
    double reach;
  };
  std::vector<Branch> bumps;
  do {
    bumps.clear();
    for (uint32_t leaf = 0; leaf < tree.points.size(); ++leaf) {
      if (!tree.alive[leaf] || tree.degree(leaf) != 1) continue;
      Branch branch{{leaf}, tree.neighbours[leaf][0], tree.reach[leaf]};
      uint32_t last = leaf;
      for (;;) {
        const uint32_t next = branch.junction;
        branch.reach += distance(tree.points[last], tree.points[next]);
        if (tree.degree(next) != 2) break;
        branch.junction =
            tree.neighbours[next][0] == last ? tree.neighbours[next][1] : tree.neighbours[next][0];
        branch.nodes.push_back(next);
        last = next;
      }
      if (tree.degree(branch.junction) < 3) return;  // a path: it has no junction
      const double needed = kBranchReach * tree.radii[branch.junction];
      if (branch.reach < needed * (1 + kTie)) bumps.push_back(branch);
    }
    for (const Branch& bump : bumps) {
      for (const uint32_t node : bump.nodes) tree.removeLeaf(node);
      double& reach = tree.reach[bump.junction];
      reach = std::max(reach, bump.reach);
    }
  } while (!bumps.empty());
}

/// Collapses edges, the shortest first, until all that are left have at least `threshold`.
class Collapse {
 public:
  Collapse(const std::vector<Vec2>& polygon, Tree& tree, double threshold)
      : polygon_(polygon), tree_(tree), threshold_(threshold), versions_(tree.points.size()) {
    for (uint32_t i = 0; i < tree.points.size(); ++i) pushEdgesOf(i, true);
  }

  void run() {
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (!tree_.alive[entry.a] || !tree_.alive[entry.b]) continue;
      if (versions_[entry.a] != entry.version_a || versions_[entry.b] != entry.version_b) continue;
      if (tree_.degree(entry.a) == 1 && tree_.degree(entry.b) == 1) return;  // the last edge
      collapse(entry.a, entry.b);
    }
  }

 private:
  struct Entry {
    double length, radius;
    uint32_t a, b, version_a, version_b;

    bool operator<(const Entry& other) const {  // the queue's top is the greatest
      return std::tie(other.length, radius, other.a, other.b) <
             std::tie(length, other.radius, a, b);
    }
  };

  void pushEdgesOf(uint32_t i, bool once) {
    for (const uint32_t j : tree_.neighbours[i]) {
      if (once && j < i) continue;
      const double length = distance(tree_.points[i], tree_.points[j]);
      if (!(length < threshold_)) continue;
      // In steps, so that lengths equal but for rounding are equal.
      const double step = threshold_ * kTie;
      const double radius = tree_.radii[i] + tree_.radii[j];
      queue_.push({std::floor(length / step + 0.5), std::floor(radius / step + 0.5), std::min(i, j),
                   std::max(i, j), versions_[std::min(i, j)], versions_[std::max(i, j)]});
    }
  }

  /// Positive when a is the better end to keep, negative when b is, 0 when neither.
  double preference(uint32_t a, uint32_t b) const {
    const size_t degree_a = tree_.degree(a), degree_b = tree_.degree(b);
    // A terminal wins over a sleeve, so that a limb keeps its length; junctions win over both.
    const auto rank = [](size_t degree) { return degree == 1 ? 2 : degree == 2 ? 1 : degree; };
    if (rank(degree_a) != rank(degree_b)) return rank(degree_a) > rank(degree_b) ? 1 : -1;
    const double difference = tree_.radii[a] - tree_.radii[b];
    return std::abs(difference) <= kTie * (tree_.radii[a] + tree_.radii[b]) ? 0 : difference;
  }

  void collapse(uint32_t a, uint32_t b) {
    const bool a_ends = tree_.degree(a) == 1, b_ends = tree_.degree(b) == 1;
    if (a_ends && tree_.degree(b) > 2) return dropLeaf(a, b);
    if (b_ends && tree_.degree(a) > 2) return dropLeaf(b, a);
    const double choice = preference(a, b);
    const double first = choice > 0 ? 0 : choice < 0 ? 1 : 0.5;
    for (const double t : {first, 1 - first, 0.5}) {
      Vec2 point = tree_.points[t < 0.5 ? a : b];
      double radius = tree_.radii[t < 0.5 ? a : b];
      if (t == 0.5) {
        point = (tree_.points[a] + tree_.points[b]) * 0.5;
        radius = distanceToBorder(polygon_, point);
      }
      if (!staysInside(a, b, point, radius)) continue;
      mergeInto(a, b, point, radius);
      return;
    }
  }

  /// A fork whose prongs are all short, as at the blunt end of a limb, becomes one prong between
  /// them; any other short prong goes.
  void dropLeaf(uint32_t leaf, uint32_t junction) {
    std::vector<uint32_t> prongs;
    Vec2 sum;
    for (const uint32_t i : tree_.neighbours[junction]) {
      if (tree_.degree(i) > 1) continue;
      if (!(distance(tree_.points[i], tree_.points[junction]) < threshold_)) continue;
      prongs.push_back(i);
      sum = sum + tree_.points[i];
    }
    const Vec2 middle = sum / static_cast<double>(prongs.size());
    if (prongs.size() > 1 && prongs.size() + 1 == tree_.degree(junction) &&
        distance(middle, tree_.points[junction]) > kTie * threshold_ &&
        segmentInside(polygon_, tree_.points[junction], middle)) {
      for (const uint32_t i : prongs) {
        if (i == leaf) continue;
        tree_.reach[leaf] = std::max(tree_.reach[leaf], tree_.reach[i]);
        tree_.removeLeaf(i);
      }
      tree_.points[leaf] = middle;
      tree_.radii[leaf] = distanceToBorder(polygon_, middle);
      touch(leaf);
      touch(junction);
      return;
    }
    tree_.reach[junction] =
        std::max(tree_.reach[junction],
                 tree_.reach[leaf] + distance(tree_.points[leaf], tree_.points[junction]));
    tree_.removeLeaf(leaf);
    touch(junction);
  }

  bool staysInside(uint32_t a, uint32_t b, Vec2 point, double radius) const {
    for (const uint32_t end : {a, b}) {
      if (tree_.points[end] == point) continue;
      for (const uint32_t other : tree_.neighbours[end]) {
        if (other == a || other == b) continue;
        // Between two balls that overlap enough the segment is clear of the border.
        const double smaller = std::min(radius, tree_.radii[other]);
        const double apart = distance(point, tree_.points[other]);
        if (apart == 0) return false;
        if (apart * apart < 4 * (1 - kClearance * kClearance) * smaller * smaller) continue;
        if (!segmentClear(polygon_, point, tree_.points[other], kClearance * smaller)) return false;
      }
    }
    return true;
  }

  void mergeInto(uint32_t a, uint32_t b, Vec2 point, double radius) {
    tree_.disconnect(a, b);
    tree_.disconnect(b, a);
    for (const uint32_t other : tree_.neighbours[b]) {
      std::replace(tree_.neighbours[other].begin(), tree_.neighbours[other].end(), b, a);
      tree_.neighbours[a].push_back(other);
    }
    tree_.neighbours[b].clear();
    tree_.alive[b] = 0;
    tree_.reach[a] = std::max(tree_.reach[a] + distance(tree_.points[a], point),
                              tree_.reach[b] + distance(tree_.points[b], point));
    tree_.points[a] = point;
    tree_.radii[a] = radius;
    touch(a);
  }

  /// Its edges, or the roles of its ends, have changed.
  void touch(uint32_t i) {
    ++versions_[i];
    pushEdgesOf(i, false);
  }

  const std::vector<Vec2>& polygon_;
  Tree& tree_;
  double threshold_;
  std::vector<uint32_t> versions_;
  std::priority_queue<Entry> queue_;
};

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

/// One edge along the longest chord through `middle`. A chord that is longer than its neighbours
/// goes through a vertex, so these directions are enough.
Axis diameter(const std::vector<Vec2>& polygon, Vec2 middle) {
  double longest = 0;
  Vec2 first = middle, second = middle;
  for (const Vec2 vertex : polygon) {
    const double away = distance(vertex, middle);
    if (!(away > 0)) continue;
    const Vec2 direction = (vertex - middle) / away;
    const double ahead = std::min(exitOf(polygon, middle, direction), away);
    const double behind = exitOf(polygon, middle, -direction);
    if (ahead + behind <= longest * (1 + kTie)) continue;
    longest = ahead + behind;
    first = middle - direction * (behind * kDiameterPart);
    second = middle + direction * (ahead * kDiameterPart);
  }
  Axis axis;
  axis.points = {first, second};
  axis.edges = {{0, 1}};
  return axis;
}

/// The node with the largest ball.
uint32_t deepest(const Tree& tree) {
  uint32_t best = 0;
  for (uint32_t i = 0; i < tree.points.size(); ++i) {
    if (tree.alive[i] && (!tree.alive[best] || tree.radii[i] > tree.radii[best])) best = i;
  }
  return best;
}

/// A tree without junctions that is short against its balls.
bool isBlob(const Tree& tree) {
  double total = 0;
  for (uint32_t i = 0; i < tree.points.size(); ++i) {
    if (tree.degree(i) > 2) return false;
    for (const uint32_t j : tree.neighbours[i]) {
      total += 0.5 * distance(tree.points[i], tree.points[j]);
    }
  }
  return total <= kBlobLength * tree.radii[deepest(tree)] * (1 + kTie);
}

}  // namespace

Result<Axis> extractAxis(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
                         const AxisOptions& options) {
  const size_t n = polygon.size();
  if (n < 3 || skeleton.nodes.size() <= n || skeleton.times.size() != skeleton.nodes.size()) {
    return Status::skeletonFailed;
  }
  Tree tree = innerTree(polygon, skeleton);
  const double mean = meanLength(tree);
  const double threshold = std::max(options.collapse_ratio * (1 - kTie), kTie) * mean;
  pruneBumps(tree);
  Collapse(polygon, tree, threshold).run();
  pruneBumps(tree);

  Axis axis;
  if (isBlob(tree)) {
    axis = diameter(polygon, tree.points[deepest(tree)]);
  } else {
    std::vector<uint32_t> renamed(tree.points.size());
    for (uint32_t i = 0; i < tree.points.size(); ++i) {
      if (!tree.alive[i]) continue;
      renamed[i] = static_cast<uint32_t>(axis.points.size());
      axis.points.push_back(tree.points[i]);
      for (const uint32_t j : tree.neighbours[i]) {
        if (j < i) axis.edges.push_back({renamed[j], renamed[i]});
      }
    }
  }
  // The times are smaller than the radii where a reflex corner's mitre has passed.
  for (const Vec2 point : axis.points) axis.radii.push_back(distanceToBorder(polygon, point));
  if (axis.edges.empty() || axis.edges.size() + 1 != axis.points.size()) {
    return Status::skeletonFailed;
  }
  return axis;
}

}  // namespace marrow
