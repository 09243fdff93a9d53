#include "skeleton/axis_tree.h"

#include <algorithm>
#include <utility>

#include "sketch/polygon.h"

namespace marrow {
namespace {

using Kind = StraightSkeleton::Kind;

// A limb reaches at least this part of the shape's size beyond the ball that it leaves,
constexpr double kLeastReach = 0.04;
// and as far, against that ball's radius, as these say together: both of them, times the last.
constexpr double kReach = 0.45;
constexpr double kBulge = 0.6;
constexpr double kBoth = 1.25;
// What reaches less than this part of the least is not looked at closer: nobody tells it apart.
constexpr double kNothing = 0.4;
constexpr double kTie = 1e-9;
// What limbs that were there are more of one for, and others less;
constexpr double kMemory = 1.2;
// they were there where their end was farther from the middle of the ball than this part of it.
constexpr double kOutside = 0.5;

bool isReflex(const std::vector<Vec2>& polygon, size_t i) {
  const size_t n = polygon.size();
  const Vec2 before = polygon[i > 0 ? i - 1 : n - 1], after = polygon[i + 1 < n ? i + 1 : 0];
  return cross(polygon[i] - before, after - polygon[i]) <= 0;
}

}  // namespace

AxisTree::AxisTree(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton)
    : polygon_(polygon) {
  const Vec2 middle = areaCentroid(polygon);
  for (const Vec2 p : polygon) size_ = std::max(size_, 2 * distance(p, middle));

  const uint32_t n = static_cast<uint32_t>(polygon.size());
  nodes_.resize(skeleton.nodes.size() - n);
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].point = nodes_[i].corner = skeleton.nodes[n + i];
    nodes_[i].radius = skeleton.times[n + i];
  }
  memory_.assign(nodes_.size(), 1);
  significance_.assign(nodes_.size(), -1);
  addArcs(skeleton);
  grow(skeleton);
}

void AxisTree::addArcs(const StraightSkeleton& skeleton) {
  const uint32_t n = static_cast<uint32_t>(polygon_.size());
  for (const auto& edge : skeleton.edges) {
    if (edge.kind == Kind::skeleton) {
      ++nodes_[edge.a - n].count;
      ++nodes_[edge.b - n].count;
    } else if (edge.kind == Kind::peripheral) {
      const uint32_t corner = std::min(edge.a, edge.b);
      if (isReflex(polygon_, corner)) continue;
      Node& node = nodes_[std::max(edge.a, edge.b) - n];
      const double tip = distance(node.point, polygon_[corner]);
      if (!(tip > node.tip)) continue;
      node.tip = tip;
      node.corner = polygon_[corner];
    }
  }
  uint32_t begin = 0;
  for (Node& node : nodes_) {
    node.first = begin;
    begin += node.count;
    node.count = 0;
  }
  around_.resize(begin);
  arcs_.resize(begin);
  for (uint32_t e = 0; e < skeleton.edges.size(); ++e) {
    if (skeleton.edges[e].kind != Kind::skeleton) continue;
    const uint32_t a = skeleton.edges[e].a - n, b = skeleton.edges[e].b - n;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      const uint32_t at = nodes_[from].first + nodes_[from].count++;
      around_[at] = to;
      arcs_[at] = e;
    }
  }
}

/// From the root to the leaves, and the ways back.
void AxisTree::grow(const StraightSkeleton& skeleton) {
  const uint32_t n = static_cast<uint32_t>(polygon_.size());
  uint32_t root = 0;
  for (uint32_t i = 1; i < nodes_.size(); ++i) {
    if (nodes_[i].radius > nodes_[root].radius * (1 + kTie)) root = i;
  }
  order_.reserve(nodes_.size());
  order_.push_back(root);
  for (size_t k = 0; k < order_.size(); ++k) {
    const uint32_t at = order_[k];
    for (uint32_t i = nodes_[at].first; i < nodes_[at].first + nodes_[at].count; ++i) {
      if (around_[i] == nodes_[at].parent) continue;
      Node& child = nodes_[around_[i]];
      const auto& arc = skeleton.edges[arcs_[i]];
      child.parent = at;
      child.to_parent = distance(child.point, nodes_[at].point);
      child.before = arc.right;
      child.behind = arc.left;
      if (arc.a - n != at) std::swap(child.before, child.behind);
      order_.push_back(around_[i]);
    }
  }
  for (size_t k = order_.size(); k-- > 0;) {
    Node& node = nodes_[order_[k]];
    if (node.tip >= node.reach) {
      node.reach = node.tip;
      node.onward = kNone;
    } else {
      node.corner = nodes_[node.onward].corner;
    }
    if (node.parent == kNone) continue;
    Node& parent = nodes_[node.parent];
    const double reach = node.reach + node.to_parent;
    if (!(reach > parent.reach)) continue;
    parent.reach = reach;
    parent.onward = order_[k];
  }
}

/// How far the border of the child's side lies beyond the tangents to its parent's ball in the
/// points where the two edges beside the arc touch it.
double AxisTree::bulge(uint32_t child) const {
  const size_t n = polygon_.size();
  const Vec2 middle = nodes_[nodes_[child].parent].point;
  const uint32_t edges[2] = {nodes_[child].before, nodes_[child].behind};
  Vec2 foot[2], outward[2];
  for (int k = 0; k < 2; ++k) {
    const Vec2 a = polygon_[edges[k]];
    const Vec2 along = polygon_[edges[k] + 1 < n ? edges[k] + 1 : 0] - a;
    const double t = std::clamp(dot(middle - a, along) / dot(along, along), 0.0, 1.0);
    foot[k] = a + along * t;
    outward[k] = (foot[k] - middle) / length(foot[k] - middle);
  }
  double most = 0;
  for (size_t i = edges[0]; i != edges[1];) {
    i = i + 1 < n ? i + 1 : 0;
    for (int k = 0; k < 2; ++k) most = std::max(most, dot(polygon_[i] - foot[k], outward[k]));
  }
  return most;
}

double AxisTree::significance(uint32_t child) const {
  double& found = significance_[child];
  if (found >= 0) return found;
  const double reach = proud(child), ball = nodes_[nodes_[child].parent].radius;
  found = std::max(0.0, reach / (kLeastReach * size_));
  if (found < kNothing) return found;
  found = std::min(found, (reach / kReach + bulge(child) / kBulge) / (ball * kBoth));
  found *= memory_[child];
  return found;
}

void AxisTree::remember(const std::vector<Vec2>& ends) {
  memory_.assign(nodes_.size(), 1 / kMemory);
  for (const Vec2 end : ends) {
    uint32_t at = root();
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      if (distance(nodes_[i].point, end) < distance(nodes_[at].point, end)) at = i;
    }
    for (; nodes_[at].parent != kNone; at = nodes_[at].parent) {
      const Node& parent = nodes_[nodes_[at].parent];
      if (distance(parent.point, end) > kOutside * parent.radius) memory_[at] = kMemory;
    }
  }
}

}  // namespace marrow
