#include "pose/mirror.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "document/weight_stroke.h"
#include "pose/pose.h"

namespace marrow {
namespace {

constexpr double kStill = 1e-9;  // turns and moves below are none

/// A rotation seen in the mirror: its axis is mirrored and it turns the other way.
Quaternion mirroredRotation(const Quaternion& q, const Plane& plane) {
  const Vec3 axis = mirroredDirection({q.x, q.y, q.z}, plane);
  return {-axis.x, -axis.y, -axis.z, q.w};
}

JointMotion mirroredMotion(const JointMotion& motion, const Plane& plane) {
  return {mirroredRotation(motion.rotation, plane), mirroredDirection(motion.move, plane)};
}

Vec3 nearestOnBone(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 way = b - a;
  const double all = dot(way, way);
  if (!(all > 0)) return a;
  return a + way * std::min(std::max(dot(p - a, way) / all, 0.0), 1.0);
}

class Partners {
 public:
  Partners(const Rig& rig, const std::vector<PlacedPart>& placed, const Plane& plane)
      : rig_(rig),
        placed_(placed),
        plane_(plane),
        children_(rig.joints.size()),
        opposite_(rig.joints.size(), kNoPartner) {
    for (const auto& [parent, child] : rig.bones) children_[parent].push_back(child);
    for (uint32_t i = 0; i < rig.joints.size(); ++i) joints_[sourceOf(i)].push_back(i);
  }

  std::vector<uint32_t> find() {
    findOpposite();
    std::vector<uint32_t> partners = opposite_;
    // By their bones: what lies opposite may run the other way, where a tree begins at one side.
    std::vector<char> decided(partners.size(), 0);
    for (const auto& [joint, child] : rig_.bones) {
      const uint32_t here = opposite_[joint], there = opposite_[child];
      if (here == kNoPartner || there == kNoPartner || decided[joint]) continue;
      const bool same_way = isParent(here, there);
      if (!same_way && !isParent(there, here)) continue;
      partners[joint] = same_way ? here : there;
      // Another bone may yet run the other way: then the chain counts, not the limbs that hang on.
      decided[joint] = !same_way;
    }
    for (uint32_t i = 0; i < partners.size(); ++i) {
      if (!children_[i].empty() && !goesWith(i, partners[i])) partners[i] = nearestTo(i);
    }
    return partners;
  }

 private:
  struct Pair {
    double apart;
    uint32_t a, b;
  };

  size_t sourceOf(uint32_t joint) const { return placed_[rig_.joints[joint].part].source; }
  bool isParent(uint32_t parent, uint32_t child) const {
    return rig_.joints[child].parent == static_cast<int32_t>(parent);
  }
  bool goesWith(uint32_t joint, uint32_t partner) const {
    if (partner == kNoPartner) return false;
    const uint32_t here = opposite_[joint];
    return std::any_of(children_[joint].begin(), children_[joint].end(), [&](uint32_t child) {
      const uint32_t there = opposite_[child];
      if (there == kNoPartner) return false;
      return partner == here ? isParent(here, there) : partner == there;
    });
  }

  /// Joints at each other's mirror places; ends with ends.
  void findOpposite() {
    const auto isEnd = [&](uint32_t joint) {
      return children_[joint].size() + (rig_.joints[joint].parent < 0 ? 0 : 1) < 2;
    };
    std::vector<Pair> pairs;
    for (const auto& [source, joints] : joints_) {
      for (auto a = joints.begin(); a != joints.end(); ++a) {
        const Vec3 image = mirrored(rig_.joints[*a].position, plane_);
        for (auto b = a; b != joints.end(); ++b) {
          if (isEnd(*a) != isEnd(*b)) continue;
          const double apart = distance(image, rig_.joints[*b].position);
          if (apart <= std::max(rig_.joints[*a].radius, rig_.joints[*b].radius)) {
            pairs.push_back({apart, *a, *b});
          }
        }
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& one, const Pair& other) {
      if (one.apart != other.apart) return one.apart < other.apart;
      return one.a != other.a ? one.a < other.a : one.b < other.b;
    });
    for (const Pair& pair : pairs) {
      if (opposite_[pair.a] != kNoPartner || opposite_[pair.b] != kNoPartner) continue;
      opposite_[pair.a] = pair.b;
      opposite_[pair.b] = pair.a;
    }
  }

  /// The one whose bone passes by the mirror place of the middle of its own.
  uint32_t nearestTo(uint32_t joint) const {
    const Rig::Joint& own = rig_.joints[joint];
    const Vec3 end = rig_.joints[children_[joint].front()].position;
    const Vec3 place = mirrored(lerp(own.position, end, 0.5), plane_);
    uint32_t best = kNoPartner;
    double nearest = 0;
    for (const uint32_t a : joints_.at(sourceOf(joint))) {
      for (const uint32_t b : children_[a]) {
        const Rig::Joint &from = rig_.joints[a], &to = rig_.joints[b];
        const double away = distance(nearestOnBone(from.position, to.position, place), place);
        const double reach = std::max(own.radius, std::max(from.radius, to.radius));
        if (away > reach || (best != kNoPartner && away >= nearest)) continue;
        nearest = away;
        best = a;
      }
    }
    return best;
  }

  const Rig& rig_;
  const std::vector<PlacedPart>& placed_;
  const Plane& plane_;
  std::vector<std::vector<uint32_t>> children_;
  std::map<size_t, std::vector<uint32_t>> joints_;  // by their part's source
  std::vector<uint32_t> opposite_;
};

/// The branch and the number of a sample's id: "part-3/b1." and 17.
std::optional<std::pair<std::string, double>> sampleIn(const std::string& id) {
  const size_t dot = id.rfind('.');
  const size_t digits = dot == std::string::npos ? 0 : id.size() - dot - 1;
  if (digits == 0 || digits > 9) return std::nullopt;
  double number = 0;
  for (const char c : id.substr(dot + 1)) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return std::pair(id.substr(0, dot + 1), number);
}

/// What is known of joints that the rig does not have.
class Lost {
 public:
  Lost(const Rig& rig, const std::vector<uint32_t>& partners) {
    for (uint32_t i = 0; i < rig.joints.size(); ++i) {
      known_.insert(rig.joints[i].id);
      if (const auto sample = sampleIn(rig.joints[i].id)) {
        branches_[sample->first].push_back({sample->second, partners[i] == i});
      }
    }
  }

  bool isKnown(const std::string& id) const { return known_.count(id) > 0; }
  /// By the nearest joint of its branch.
  bool isInPlane(const std::string& id) const {
    const auto sample = sampleIn(id);
    const auto branch = sample ? branches_.find(sample->first) : branches_.end();
    if (branch == branches_.end()) return false;
    const auto away = [&](const Known& one) { return std::abs(one.number - sample->second); };
    return std::min_element(branch->second.begin(), branch->second.end(),
                            [&](const Known& a, const Known& b) { return away(a) < away(b); })
        ->in_plane;
  }

 private:
  struct Known {
    double number;
    bool in_plane;
  };
  std::set<std::string> known_;
  std::map<std::string, std::vector<Known>> branches_;
};

/// Whether a joint does within its parent what its partner does within its own.
bool isAlike(const Rig& rig, const std::vector<uint32_t>& partners, uint32_t joint) {
  const int32_t own = rig.joints[joint].parent, other = rig.joints[partners[joint]].parent;
  if (own < 0 || other < 0) return own < 0 && other < 0;
  return partners[static_cast<size_t>(own)] == static_cast<uint32_t>(other);
}

}  // namespace

std::vector<uint32_t> mirrorPartners(const Rig& rig, const std::vector<PlacedPart>& placed,
                                     const Plane& plane) {
  return Partners(rig, placed, plane).find();
}

OppositeJoints::OppositeJoints(const Document& document, const Rig& rig)
    : document_(document), rig_(rig) {
  for (uint32_t i = 0; i < rig.joints.size(); ++i) joints_.emplace(rig.joints[i].id, i);
}

std::string OppositeJoints::of(const std::string& joint, const Plane& plane) {
  const std::string opposite = oppositeJoint(document_, joint);
  const auto own = joints_.find(joint);
  if (own == joints_.end() || hasOppositeId(joint)) return opposite;
  if (!plane_ || !(*plane_ == plane)) {
    partners_ = mirrorPartners(rig_, placedParts(document_), plane);
    plane_ = plane;
  }
  const uint32_t partner = partners_[own->second];
  if (partner == kNoPartner || partners_[partner] != own->second) return joint;
  const std::string& other = rig_.joints[partner].id;
  return hasOppositeId(other) ? joint : other;
}

bool OppositeJoints::hasOppositeId(const std::string& joint) const {
  const std::string opposite = oppositeJoint(document_, joint);
  return opposite != joint && joints_.count(opposite) > 0;
}

Pose mirroredPose(const Document& document, const Rig& rig, const Pose& pose, const Plane& plane) {
  const std::vector<uint32_t> partners = mirrorPartners(rig, placedParts(document), plane);
  const std::vector<Rigid> before = posed(rig, pose);
  std::vector<Quaternion> turns(rig.joints.size());  // in the image, in space
  Pose rest = pose;                                  // of the joints that the rig does not have
  Pose result;
  for (uint32_t i = 0; i < partners.size(); ++i) {
    const Rig::Joint& joint = rig.joints[i];
    const uint32_t partner = partners[i];
    const auto parent = static_cast<size_t>(joint.parent);
    const Quaternion above = joint.parent < 0 ? Quaternion{} : turns[parent];
    JointMotion motion;
    if (partner == kNoPartner) {
      const auto own = pose.find(joint.id);
      if (own != pose.end()) result[joint.id] = motion = own->second;
    } else if (isAlike(rig, partners, i)) {
      const auto other = pose.find(rig.joints[partner].id);
      if (other != pose.end()) result[joint.id] = motion = mirroredMotion(other->second, plane);
    } else {
      const Rigid& there = before[partner];
      motion.rotation = normalised(conjugate(above) * mirroredRotation(there.rotation, plane));
      const auto other = pose.find(rig.joints[partner].id);
      const int32_t held = rig.joints[partner].parent;
      if (joint.parent < 0) {
        motion.move = mirrored(there(mirrored(joint.position, plane)), plane) - joint.position;
      } else if (held >= 0 && other != pose.end()) {
        const Vec3 move = before[static_cast<size_t>(held)].direction(other->second.move);
        motion.move = rotated(conjugate(above), mirroredDirection(move, plane));
      }
      const Quaternion& q = motion.rotation;
      const double still = kStill * (1 + length(joint.position));
      if (length({q.x, q.y, q.z}) > kStill || length(motion.move) > still) {
        result[joint.id] = motion;
      } else {
        motion = {};
      }
    }
    turns[i] = normalised(above * normalised(motion.rotation));
  }
  for (const Rig::Joint& joint : rig.joints) rest.erase(joint.id);
  const Lost lost(rig, partners);
  for (const auto& [id, motion] : rest) {
    const std::string opposite = oppositeJoint(document, id);
    const bool swaps = opposite != id && !lost.isKnown(opposite);
    const bool flips = swaps || (opposite == id && lost.isInPlane(id));
    result[swaps ? opposite : id] = flips ? mirroredMotion(motion, plane) : motion;
  }
  return result;
}

}  // namespace marrow
