// Sub-skeletons and connections → the unrefined skeleton of everything, as a graph that no
// threshold changes. Internal to refining.
#pragma once

#include <cstdint>
#include <vector>

#include "rig/rig.h"

namespace marrow {

/// A forest, seen from its roots.
struct JoinedSkeleton {
  static constexpr uint32_t kNone = 0xFFFFFFFF;

  /// A terminal or junction of a part, or a place on a branch where others hang or by which the
  /// part itself does.
  struct Node {
    uint32_t part = 0;
    uint32_t branch = kNone;  // of a place on a branch
    double u = 0;             // of such a place: a sample of the branch, or between two
    uint32_t joint = kNone;   // of a terminal or junction
    uint32_t hangs = kNone;   // first part that hangs here
    bool hangs_by = false;    // of a place on a branch: the part itself hangs by it
    uint32_t degree = 0;
    // Seen from the root.
    uint32_t parent = kNone;
    uint32_t edge = kNone;  // that leads to the parent
  };
  /// A stretch of a branch, or the bone of a connection.
  struct Edge {
    uint32_t a = 0, b = 0;    // nodes; on a branch, u grows from a to b
    uint32_t branch = kNone;  // of the nodes' part; of a connection kNone
    double u_a = 0, u_b = 0;  // on the branch
    double length = 0;        // along the unrefined axis, world
  };
  /// A path through nodes with two edges, between others (a root is always one of these).
  struct Way {
    uint32_t start = 0;           // node, nearer to the root
    uint32_t first = 0, end = 0;  // its further nodes, without `start`: order[first] to before
                                  // order[end]
    double length = 0;            // world
    bool keeps = false;           // the one that holds most of some part
  };
  struct Part {
    const PartSkeleton* skeleton = nullptr;  // null: has no bones here
    double scale = 1;                        // world units per unit of its plane
    uint32_t first_node = 0;                 // the node of its joint 0
    uint32_t entry = kNone;                  // its node nearest to the root
    uint32_t tree = kNone;                   // index of the root
  };

  std::vector<Part> parts;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  std::vector<uint32_t> roots;  // nodes
  std::vector<uint32_t> order;  // nodes, each way after the one that leads to it
  std::vector<Way> ways;

  bool isRoot(uint32_t node) const { return nodes[node].parent == kNone; }
  /// Whether a way ends here.
  bool isEnd(uint32_t node) const { return nodes[node].degree != 2 || isRoot(node); }
  /// Whether a joint here can be one with others.
  bool isInner(uint32_t node) const { return nodes[node].degree > 1; }
};

/// Places on a branch nearer than this part of a sample's step are one.
constexpr double kSamePlace = 1e-7;

JoinedSkeleton joinSkeletons(const std::vector<RigPart>& parts,
                             const std::vector<Connection>& connections);

/// Arc length from a branch's start to between two samples, in the part's plane.
double alongAt(const PartSkeleton::Branch& branch, double u);

}  // namespace marrow
