#include "tools/pose_tool.h"

#include <algorithm>
#include <cmath>

#include "pose/inverse_kinematics.h"

namespace marrow {
namespace {

constexpr double kJointReach_px = 14, kJointTouch_px = 26;
constexpr double kAlike_px = 3;  // as near as the nearest
constexpr double kBoneReach_px = 10, kBoneTouch_px = 20;
constexpr double kFirstMove_px = 2;
constexpr double kMissed = 0.02;  // × the distance to the target: that much is out of reach

/// The joint nearest to the root that is of the same part.
uint32_t limbOf(const Rig& rig, uint32_t joint) {
  for (int32_t up = rig.joints[joint].parent; up >= 0;
       up = rig.joints[static_cast<size_t>(up)].parent) {
    if (rig.joints[static_cast<size_t>(up)].part != rig.joints[joint].part) break;
    joint = static_cast<uint32_t>(up);
  }
  return joint;
}

Quaternion rotationOf(const Affine& map) { return rotationTo(map.x, map.y, map.z); }

}  // namespace

std::optional<uint32_t> jointOf(const Rig& rig, const std::string& id) {
  for (size_t i = 0; i < rig.joints.size(); ++i) {
    if (rig.joints[i].id == id) return static_cast<uint32_t>(i);
  }
  return std::nullopt;
}

uint32_t boneOf(const Rig& rig, uint32_t joint) {
  const int32_t parent = rig.joints[joint].parent;
  return parent < 0 ? joint : static_cast<uint32_t>(parent);
}

std::optional<uint32_t> jointToGrab(Vec2 pixel, const Stance& stance, const Camera& camera,
                                    ViewSize size, bool touch) {
  const Rig& posed = stance.posed;
  const auto isHidden = [&](size_t joint) {
    return joint < stance.hidden.size() && stance.hidden[joint];
  };
  // Of several that are meant the one in front; of joints in one place the last: a limb rather than
  // what it hangs on.
  const Vec3 back = camera.axes()[2];
  std::optional<uint32_t> found;
  double front = 0;
  const auto offer = [&](uint32_t joint, Vec3 at) {
    const double depth = dot(back, at);
    if (found && depth < front) return;
    found = joint;
    front = depth;
  };
  std::vector<Vec2> places;
  places.reserve(posed.joints.size());
  double nearest = touch ? kJointTouch_px : kJointReach_px;
  for (size_t i = 0; i < posed.joints.size(); ++i) {
    places.push_back(camera.toScreen(posed.joints[i].position, size));
    if (!isHidden(i)) nearest = std::min(nearest, distance(places.back(), pixel));
  }
  const double reach_px = touch ? kJointTouch_px : kJointReach_px;
  for (uint32_t i = 0; i < places.size(); ++i) {
    if (isHidden(i)) continue;
    const double far = distance(places[i], pixel);
    if (far <= reach_px && far <= nearest + kAlike_px) offer(i, posed.joints[i].position);
  }
  if (found) return found;
  for (const auto& [head, tail] : posed.bones) {
    if (isHidden(tail)) continue;
    const Rig::Joint &a = posed.joints[head], &b = posed.joints[tail];
    const Vec2 way = places[tail] - places[head];
    const double along = dot(way, way) > 0
                             ? std::clamp(dot(pixel - places[head], way) / dot(way, way), 0.0, 1.0)
                             : 0;
    const double radius = a.radius + (b.radius - a.radius) * along;
    const double limb_px = std::max(radius * camera.zoom, touch ? kBoneTouch_px : kBoneReach_px);
    if (distance(pixel, places[head] + way * along) > limb_px) continue;
    // A root moves everything: only by its own joint.
    const bool by_tail = along > 0.5 || a.parent < 0 || isHidden(head);
    offer(by_tail ? tail : head, lerp(a.position, b.position, along));
  }
  return found;
}

void PoseTool::begin(const Stance& stance, uint32_t joint, Way way, Vec2 pointer_px,
                     const Camera& camera, ViewSize size) {
  stance_ = stance;
  joint_ = joint;
  way_ = way;
  active_ = true;
  by_key_ = changed_ = false;
  camera_ = camera;
  start_px_ = pointer_px;
  start_ = target_ = stance.posed.joints[joint].position;
  pose_ = stance.pose;
  const bool is_root = stance.posed.joints[joint].parent < 0;
  transform_.begin(way == Way::turn && is_root ? TransformKind::rotate : TransformKind::move,
                   TransformAxis::none, {}, start_, pointer_px, camera, size, false);
}

void PoseTool::beginByKey(const Stance& stance, uint32_t joint, TransformKind kind, Vec2 pointer_px,
                          const Camera& camera, ViewSize size) {
  begin(stance, joint, kind == TransformKind::rotate ? Way::turn : Way::pull, pointer_px, camera,
        size);
  by_key_ = true;
  const uint32_t about = kind == TransformKind::rotate ? pivotJoint() : joint;
  transform_.begin(kind, TransformAxis::none, {}, stance.posed.joints[about].position, pointer_px,
                   camera, size, true);
}

uint32_t PoseTool::pivotJoint() const { return boneOf(stance_.rest, joint_); }

void PoseTool::move(Vec2 pointer_px) {
  if (!changed_ && distance(pointer_px, start_px_) < kFirstMove_px) return;
  changed_ = true;
  transform_.move(pointer_px);
  follow();
}

bool PoseTool::key(char character) {
  if (!byKey() || !transform_.key(character)) return false;
  changed_ = true;
  follow();
  return true;
}

void PoseTool::follow() {
  const Affine map = transform_.command().map;
  if (way_ == Way::pull) {
    pullTo(start_ + map.move);
    return;
  }
  if (transform_.kind() == TransformKind::rotate) {
    pose_ = turned(stance_.rest, stance_.pose, pivotJoint(), rotationOf(map));
    return;
  }
  const uint32_t head = pivotJoint();
  const Vec3 middle = stance_.posed.joints[head].position;
  pose_ = turned(stance_.rest, stance_.pose, head,
                 between(start_ - middle, start_ + map.move - middle));
}

// The limb bends; only where it is too short, what it hangs on follows.
void PoseTool::pullTo(Vec3 target) {
  target_ = target;
  pose_ = stance_.pose;
  if (const uint32_t base = limbOf(stance_.rest, joint_); base != joint_) {
    std::vector<uint32_t> pins = stance_.pins;
    pins.push_back(base);
    pose_ = reach(stance_.rest, stance_.pose, joint_, target, pins);
    if (!missed()) return;
  }
  pose_ = reach(stance_.rest, pose_, joint_, target, stance_.pins);
}

bool PoseTool::missed() const {
  const Vec3 at = posed(stance_.rest, pose_)[joint_](stance_.rest.joints[joint_].position);
  return distance(at, target_) > kMissed * distance(start_, target_);
}

std::optional<Vec3> PoseTool::outOfReach() const {
  if (!active_ || !changed_ || way_ != Way::pull || !missed()) return std::nullopt;
  return target_;
}

}  // namespace marrow
