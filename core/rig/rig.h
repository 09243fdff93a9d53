// Parts → one character with one hierarchical skeleton.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/frame.h"
#include "document/placed_parts.h"
#include "document/refinement.h"
#include "part/part.h"

namespace marrow {

/// What connecting and refining need to know of a placed part; plain references, to be made anew
/// for every document.
struct RigPart {
  const PlacedPart* placed = nullptr;
  const PartSource* source = nullptr;  // its settings
  const Part* part = nullptr;          // null: no shape came of it; it is left out
};

enum class AttachEvent : uint8_t { split, connect };  // [RS §3.2, Fig. 9]
enum class AttachTest : uint8_t {
  joint,    // the bodies overlap, and a terminal or junction joint of the child is in the parent
  overlap,  // the bodies overlap
  user,     // the user said so
};
const char* toString(AttachEvent event);
const char* toString(AttachTest test);

/// How settings and ids name the branch of a part: "b1" for PartSkeleton::branches[1].
std::string branchKey(uint32_t branch);

/// Where a child's skeleton hangs on its parent's. Indices: of placed parts, of joints and bones of
/// Part::skeleton.
struct Connection {
  uint32_t child = 0, parent = 0;
  AttachEvent event = AttachEvent::connect;
  AttachTest test = AttachTest::joint;
  bool child_split = false;   // hangs by a place within one of its bones, not by a joint
  uint32_t child_joint = 0;   // by which it hangs; where child_split, the bone's first joint
  uint32_t child_bone = 0;    // where child_split
  double child_along = 0;     // where child_split: 0 … 1 from that bone's first joint on
  uint32_t parent_joint = 0;  // of a connect event; of a split event the bone's first joint
  uint32_t parent_bone = 0;   // of a split event
  double along = 0;           // of a split event: 0 … 1 from the bone's first joint to its second
  Vec3 child_position, parent_position;  // world
};
bool operator==(const Connection& a, const Connection& b);

/// The skeleton of everything: a forest.
struct Rig {
  struct Joint {
    /// Stays while the joint does, and comes back with it: "part-3/n0" (terminal or junction 0 of
    /// the part's own), "part-3/b1.17" (sample 17 of its branch 1), "part-3/a:part-5" (where that
    /// part hangs on a branch), "part-3/h" (where part-3 itself hangs by a branch). A '/' in a
    /// part's id is doubled.
    std::string id;
    /// Unique, and the same whatever the thresholds: the part's name, its side where it has a twin,
    /// the number along the branch: "Leg.L.2". 1 is nearest to the root. Other branches than the
    /// first have a letter, "Leg.L.B1", and begin behind the junction where they leave it. Numbers
    /// are those of the skeleton with the default ε_s, so some may be missing; a joint that only a
    /// finer skeleton has is called after the one before it, with its sample: "Leg.L.2_17". A
    /// second part of the same name is "Leg 2".
    std::string name;
    uint32_t part = 0;                   // placed part it belongs to
    uint32_t branch = 0;                 // of the part's own branches, the one it lies on
    int32_t parent = -1;                 // joint; −1: a root
    Vec3 position;                       // world
    double radius = 0;                   // of the ball there, model units
    JointKind kind = JointKind::sleeve;  // by its bones in the rig
  };
  std::vector<Joint> joints;                   // parents before their children
  std::vector<std::array<uint32_t, 2>> bones;  // parent, child: one per joint that is no root
  std::vector<uint32_t> roots;                 // joints, one per tree, in modelling order
  std::vector<Connection> connections;         // by child, of parts with bones
  /// Placed parts without bones of their own, each with the joint at the end of the bone that
  /// carries it, or −1.
  std::vector<std::pair<uint32_t, int32_t>> carried;
};
bool operator==(const Rig::Joint& a, const Rig::Joint& b);
bool operator==(const Rig& a, const Rig& b);

}  // namespace marrow
