// How much two bodies are inside each other, whatever their skeletons say, and where.
#pragma once

#include <vector>

#include "base/box.h"
#include "rig/rig.h"

namespace marrow {

struct BodyOverlap;

/// A part's body in space, for questions about points. Keeps references to what the part refers to.
class PartBody {
 public:
  /// part: with a shape.
  explicit PartBody(const RigPart& part);

  bool contains(Vec3 world) const { return containsLocal(toLocal(world)); }
  /// World units cubed.
  double volume() const { return volume_; }
  /// Along the axes of space.
  Box3 box() const;

 private:
  template <typename Visit>
  friend double visitShared(const PartBody& one, const PartBody& other, int columns, int deep,
                            const Visit& visit);

  Vec3 toLocal(Vec3 world) const {
    const Vec3 d = world - origin_;
    return {dot(to_x_, d), dot(to_y_, d), dot(to_z_, d)};
  }
  Vec3 toWorld(Vec3 p) const { return origin_ + x_ * p.x + y_ * p.y + z_ * p.z; }
  bool containsLocal(Vec3 p) const {
    if (!(p.z < high_.z && p.z > low_.z)) return false;
    const Vec2 at{p.x, p.y};
    return p.z < relief_.heightAt(at) * thickness_ && p.z > relief_.depthAt(at) * thickness_;
  }
  /// Of its own box, in the axes of the other's plane.
  Box3 boxSeenBy(const PartBody& other) const;

  const Relief& relief_;
  double thickness_, volume_;
  Vec3 origin_, x_, y_, z_, to_x_, to_y_, to_z_;
  Vec3 low_, high_;  // of its box in its own axes
};

/// What two bodies share.
struct BodyOverlap {
  double share = 0;          // of the smaller one's volume
  Vec3 middle;               // centroid
  std::vector<Vec3> points;  // some of it, evenly spread; none where the bodies do not meet
};

/// Good to some hundredths of what is shared, and to a sixteenth of where the boxes of the bodies
/// meet. The same in both orders but for rounding. O(points): a thousand where the boxes meet.
BodyOverlap bodyOverlap(const PartBody& one, const PartBody& other);
/// The share alone, to a tenth where that is plenty.
double sharedVolume(const PartBody& one, const PartBody& other);

}  // namespace marrow
