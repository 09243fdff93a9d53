// Takes hold of a joint of the posed character: pulls it, and what is above it follows, or turns
// the bone that leads to it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera.h"
#include "pose/pose.h"
#include "tools/transform_tool.h"

namespace marrow {

/// The character as it is posed now.
struct Stance {
  Rig rest;
  Rig posed;  // the same joints where the pose has them
  Pose pose;
  Pose wanted;                 // what it glides to; else the same
  std::vector<uint32_t> pins;  // joints that stay
  std::vector<char> hidden;    // by joint: its part is not shown; empty: none is
};

/// The joint with this id.
std::optional<uint32_t> jointOf(const Rig& rig, const std::string& id);

/// A chosen joint stands for the bone that ends in it: the joint that turns that bone. A root
/// stands for itself.
uint32_t boneOf(const Rig& rig, uint32_t joint);

/// The joint that a press there takes hold of: one that is near, or else an end of the bone whose
/// limb is under the pixel.
std::optional<uint32_t> jointToGrab(Vec2 pixel, const Stance& stance, const Camera& camera,
                                    ViewSize size, bool touch);

class PoseTool {
 public:
  enum class Way : uint8_t { pull, turn };

  void begin(const Stance& stance, uint32_t joint, Way way, Vec2 pointer_px, const Camera& camera,
             ViewSize size);
  /// G and R: it follows the pointer without a button, along an axis or by a number where one is
  /// typed.
  void beginByKey(const Stance& stance, uint32_t joint, TransformKind kind, Vec2 pointer_px,
                  const Camera& camera, ViewSize size);
  void move(Vec2 pointer_px);
  bool key(char character);
  void end() { active_ = false; }

  bool active() const { return active_; }
  bool byKey() const { return active_ && by_key_; }
  bool changed() const { return changed_; }
  uint32_t joint() const { return joint_; }
  const Pose& pose() const { return pose_; }
  /// What was asked for, where the joint could not come as far; model space.
  std::optional<Vec3> outOfReach() const;
  std::string label() const { return transform_.label(); }

 private:
  void follow();
  void pullTo(Vec3 target);
  bool missed() const;  // where the joint was pulled to
  uint32_t pivotJoint() const;

  bool active_ = false, by_key_ = false, changed_ = false;
  Way way_ = Way::pull;
  Stance stance_;
  uint32_t joint_ = 0;
  Camera camera_;
  Vec2 start_px_;
  Vec3 start_, target_;  // of the joint
  TransformTool transform_;
  Pose pose_;
};

}  // namespace marrow
