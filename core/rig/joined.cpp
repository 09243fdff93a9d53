#include "rig/joined.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr uint32_t kNone = JoinedSkeleton::kNone;
constexpr double kTie = 1e-9;

/// A place on a branch where a part hangs, or by which its own part does.
struct Place {
  uint32_t part, branch;
  double u;
  bool own;
  uint32_t connection;
};

/// One end of a connection.
struct ConnectedAt {
  uint32_t part;
  bool split;
  uint32_t joint, bone;
  double along;
};

class Joining {
 public:
  Joining(const std::vector<RigPart>& parts, const std::vector<Connection>& connections)
      : parts_(parts), connections_(connections) {}

  JoinedSkeleton run() {
    addParts();
    placeConnections();
    addBranches();
    for (size_t i = 0; i < connections_.size(); ++i) {
      const Connection& connection = connections_[i];
      if (!hasBones(connection.child)) continue;
      addEdge({held_at_[i], hangs_by_[i], kNone, 0, 0,
               distance(connection.child_position, connection.parent_position)});
      Node& node = result_.nodes[held_at_[i]];
      node.hangs = std::min(node.hangs, connection.child);
    }
    linkNeighbours();
    chooseRoots();
    for (const uint32_t root : result_.roots) walkFrom(root);
    findWays();
    return std::move(result_);
  }

 private:
  using Node = JoinedSkeleton::Node;
  using Edge = JoinedSkeleton::Edge;

  bool hasBones(uint32_t part) const { return result_.parts[part].skeleton != nullptr; }

  void addParts() {
    result_.parts.resize(parts_.size());
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      const RigPart& part = parts_[i];
      if (!part.part || !part.source->skeleton || part.part->skeleton.bones.empty()) continue;
      auto& joined = result_.parts[i];
      joined.skeleton = &part.part->skeleton;
      joined.scale = part.placed->frame.scale();
      joined.first_node = static_cast<uint32_t>(result_.nodes.size());
      for (uint32_t j = 0; j < joined.skeleton->joints.size(); ++j) {
        if (joined.skeleton->joints[j].kind == JointKind::sleeve) break;
        Node node;
        node.part = i;
        node.joint = j;
        result_.nodes.push_back(node);
      }
    }
  }

  /// Finds the nodes at both ends of each connection, or places on branches that become some.
  void placeConnections() {
    held_at_.assign(connections_.size(), kNone);
    hangs_by_.assign(connections_.size(), kNone);
    for (uint32_t i = 0; i < connections_.size(); ++i) {
      const Connection& c = connections_[i];
      if (!hasBones(c.child)) continue;
      const bool split = c.event == AttachEvent::split;
      place({c.parent, split, c.parent_joint, c.parent_bone, c.along}, false, i);
      place({c.child, c.child_split, c.child_joint, c.child_bone, c.child_along}, true, i);
    }
    std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
      if (a.part != b.part) return a.part < b.part;
      if (a.branch != b.branch) return a.branch < b.branch;
      return a.u != b.u ? a.u < b.u : a.connection < b.connection;
    });
  }

  void place(const ConnectedAt& at, bool own, uint32_t connection) {
    const auto& part = result_.parts[at.part];
    const PartSkeleton& skeleton = *part.skeleton;
    uint32_t& node = nodeOf(own, connection);
    if (!at.split && skeleton.joints[at.joint].kind != JointKind::sleeve) {
      node = part.first_node + at.joint;
      return;
    }
    Place place{at.part, 0, 0, own, connection};
    for (const auto& branch : skeleton.branches) {
      const size_t bones = branch.joints.size() - 1;
      if (at.split) {
        const size_t k = at.bone - size_t{branch.first_bone};
        if (at.bone >= branch.first_bone && k < bones) {
          place.u =
              branch.at[k] + at.along * (static_cast<double>(branch.at[k + 1]) - branch.at[k]);
          break;
        }
      } else {
        const auto found = std::find(branch.joints.begin(), branch.joints.end(), at.joint);
        if (found != branch.joints.end()) {
          place.u = branch.at[static_cast<size_t>(found - branch.joints.begin())];
          break;
        }
      }
      ++place.branch;
    }
    // Near a sample it is that sample, near an end the end.
    const double nearest = std::floor(place.u + 0.5);
    if (std::abs(place.u - nearest) < kSamePlace) place.u = nearest;
    const auto& branch = skeleton.branches[place.branch];
    if (place.u <= 0 || place.u >= branch.at.back()) {
      node = part.first_node + (place.u <= 0 ? branch.joints.front() : branch.joints.back());
    } else {
      places_.push_back(place);
    }
  }

  uint32_t& nodeOf(bool own, uint32_t connection) {
    return own ? hangs_by_[connection] : held_at_[connection];
  }

  void addBranches() {
    auto place = places_.begin();
    for (uint32_t i = 0; i < result_.parts.size(); ++i) {
      if (!hasBones(i)) continue;
      const auto& part = result_.parts[i];
      for (uint32_t b = 0; b < part.skeleton->branches.size(); ++b) {
        const auto& branch = part.skeleton->branches[b];
        uint32_t last = part.first_node + branch.joints.front();
        double u = 0;
        for (; place != places_.end() && place->part == i && place->branch == b; ++place) {
          if (u == 0 || place->u - u > kSamePlace) {
            Node node;
            node.part = i;
            node.branch = b;
            node.u = place->u;
            result_.nodes.push_back(node);
            const uint32_t next = static_cast<uint32_t>(result_.nodes.size() - 1);
            addPiece(i, b, last, next, u, node.u);
            last = next;
            u = node.u;
          }
          nodeOf(place->own, place->connection) = last;
          if (place->own) result_.nodes[last].hangs_by = true;
        }
        addPiece(i, b, last, part.first_node + branch.joints.back(), u, branch.at.back());
      }
    }
  }

  void addPiece(uint32_t part, uint32_t branch, uint32_t a, uint32_t b, double u_a, double u_b) {
    const auto& joined = result_.parts[part];
    const auto& shape = joined.skeleton->branches[branch];
    addEdge({a, b, branch, u_a, u_b, (alongAt(shape, u_b) - alongAt(shape, u_a)) * joined.scale});
  }

  void addEdge(const Edge& edge) {
    ++result_.nodes[edge.a].degree;
    ++result_.nodes[edge.b].degree;
    result_.edges.push_back(edge);
  }

  /// The edges of each node, in their order: the part's own, then connections.
  void linkNeighbours() {
    const auto& nodes = result_.nodes;
    starts_.assign(nodes.size() + 1, 0);
    for (size_t i = 0; i < nodes.size(); ++i) starts_[i + 1] = starts_[i] + nodes[i].degree;
    around_.resize(starts_.back());
    std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (uint32_t e = 0; e < result_.edges.size(); ++e) {
      around_[next[result_.edges[e].a]++] = e;
      around_[next[result_.edges[e].b]++] = e;
    }
  }

  void chooseRoots() {
    std::vector<uint32_t> holder(parts_.size(), kNone);
    for (const Connection& connection : connections_) {
      if (hasBones(connection.child)) holder[connection.child] = connection.parent;
    }
    std::vector<uint32_t> chosen;  // part at which the bones of each tree begin
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      if (!hasBones(i) || holder[i] != kNone) continue;
      result_.parts[i].tree = static_cast<uint32_t>(chosen.size());
      chosen.push_back(i);
    }
    std::vector<char> by_user(chosen.size());
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      if (!hasBones(i)) continue;
      uint32_t top = i;
      while (holder[top] != kNone) top = holder[top];
      const uint32_t tree = result_.parts[top].tree;
      result_.parts[i].tree = tree;
      if (!parts_[i].source->root || by_user[tree]) continue;
      by_user[tree] = true;
      chosen[tree] = i;
    }
    for (const uint32_t part : chosen) result_.roots.push_back(rootOf(part));
  }

  /// Of a part's junctions (or ends), the one from which the furthest other is nearest.
  uint32_t rootOf(uint32_t part) {
    const auto& joined = result_.parts[part];
    const auto& joints = joined.skeleton->joints;
    uint32_t count = 0;
    bool has_junction = false;
    while (count < joints.size() && joints[count].kind != JointKind::sleeve) {
      has_junction = has_junction || joints[count].kind == JointKind::junction;
      ++count;
    }
    // In a tree, what is furthest from anywhere is one of the two that are furthest apart.
    const auto furthest = [](const std::vector<double>& far) {
      return static_cast<uint32_t>(std::max_element(far.begin(), far.end()) - far.begin());
    };
    const uint32_t one = furthest(distancesFrom(part, 0, count));
    const std::vector<double> from_one = distancesFrom(part, one, count);
    const std::vector<double> from_other = distancesFrom(part, furthest(from_one), count);

    const double tie = kTie * *std::max_element(from_one.begin(), from_one.end());
    uint32_t best = kNone;
    double nearest = 0;
    for (uint32_t j = 0; j < count; ++j) {
      if (has_junction && joints[j].kind != JointKind::junction) continue;
      const double far = std::max(from_one[j], from_other[j]);
      const bool nearer = best == kNone || far < nearest - tie;
      if (!nearer && !(far < nearest + tie && joints[j].radius > joints[best].radius)) continue;
      best = j;
      nearest = far;
    }
    return joined.first_node + best;
  }

  /// From a terminal or junction to the others of the part, along its own branches.
  std::vector<double> distancesFrom(uint32_t part, uint32_t start, uint32_t count) {
    const auto& branches = result_.parts[part].skeleton->branches;
    std::vector<double> far(count, -1);
    far[start] = 0;
    // Each round gets at least one branch further; most get far, as branches come in order.
    for (bool more = true; more;) {
      more = false;
      for (const auto& branch : branches) {
        const uint32_t a = branch.joints.front(), b = branch.joints.back();
        if ((far[a] < 0) == (far[b] < 0)) continue;
        (far[a] < 0 ? far[a] : far[b]) = std::max(far[a], far[b]) + branch.length();
        more = true;
      }
    }
    return far;
  }

  void walkFrom(uint32_t root) {
    std::vector<uint32_t> todo{root};
    while (!todo.empty()) {
      const uint32_t node = todo.back();
      todo.pop_back();
      result_.order.push_back(node);
      auto& part = result_.parts[result_.nodes[node].part];
      if (part.entry == kNone) part.entry = node;
      for (uint32_t k = starts_[node + 1]; k-- > starts_[node];) {
        const Edge& edge = result_.edges[around_[k]];
        if (around_[k] == result_.nodes[node].edge) continue;
        const uint32_t other = edge.a == node ? edge.b : edge.a;
        result_.nodes[other].parent = node;
        result_.nodes[other].edge = around_[k];
        todo.push_back(other);
      }
    }
  }

  void findWays() {
    for (uint32_t i = 0; i < result_.order.size(); ++i) {
      const uint32_t node = result_.order[i];
      if (result_.isRoot(node)) continue;
      const uint32_t parent = result_.nodes[node].parent;
      if (result_.isEnd(parent)) result_.ways.push_back({parent, i, i, 0, false});
      // Behind a node with two edges comes the rest of its way.
      auto& way = result_.ways.back();
      way.end = i + 1;
      way.length += result_.edges[result_.nodes[node].edge].length;
    }
    std::vector<double> longest(parts_.size(), -1);
    std::vector<uint32_t> keeper(parts_.size(), kNone);
    for (uint32_t w = 0; w < result_.ways.size(); ++w) {
      double own = 0;
      for (uint32_t i = result_.ways[w].first; i < result_.ways[w].end; ++i) {
        const Node& node = result_.nodes[result_.order[i]];
        const Edge& edge = result_.edges[node.edge];
        // The pieces of a part follow one another.
        if (edge.branch == kNone) {
          own = 0;
          continue;
        }
        own += edge.length;
        if (!(own > longest[node.part] * (1 + kTie))) continue;
        longest[node.part] = own;
        keeper[node.part] = w;
      }
    }
    for (const uint32_t way : keeper) {
      if (way != kNone) result_.ways[way].keeps = true;
    }
  }

  const std::vector<RigPart>& parts_;
  const std::vector<Connection>& connections_;
  std::vector<uint32_t> held_at_, hangs_by_;  // by connection: nodes of the parent, of the child
  std::vector<Place> places_;
  std::vector<uint32_t> starts_, around_;
  JoinedSkeleton result_;
};

}  // namespace

JoinedSkeleton joinSkeletons(const std::vector<RigPart>& parts,
                             const std::vector<Connection>& connections) {
  return Joining(parts, connections).run();
}

double alongAt(const PartSkeleton::Branch& branch, double u) {
  const size_t last = branch.samples.size() - 1;
  const size_t k = std::min(static_cast<size_t>(u), last - 1);
  const double t = u - static_cast<double>(k);
  return branch.samples[k].along + (branch.samples[k + 1].along - branch.samples[k].along) * t;
}

}  // namespace marrow
