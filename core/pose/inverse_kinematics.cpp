#include "pose/inverse_kinematics.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr double kStraight = 1e-7;  // of its length, that a chain may be shorter by and be straight

bool isFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// From one point, so far into the direction of another; any direction where they are one.
Vec3 towards(Vec3 from, Vec3 to, double far) {
  const Vec3 way = to - from;
  const double size = length(way);
  return size > 0 ? from + way * (far / size) : from + Vec3{0, far, 0};
}

/// Where the joints of a chain have to be for its end to come to the target; the first stays.
/// False where they are already.
bool bend(std::vector<Vec3>& chain, Vec3 target, const ReachOptions& options) {
  const size_t n = chain.size();
  std::vector<double> lengths(n - 1);
  double reach = 0;
  for (size_t i = 0; i + 1 < n; ++i) reach += lengths[i] = distance(chain[i], chain[i + 1]);
  const Vec3 base = chain[0];
  if (distance(chain[n - 1], target) <= options.near * reach) return false;
  if (distance(base, target) >= reach) {
    for (size_t i = 0; i + 1 < n; ++i) chain[i + 1] = towards(chain[i], target, lengths[i]);
    return true;
  }
  // A straight chain never bends when it is pushed along itself: it is given a way to go.
  const Vec3 way = chain[n - 1] - base, pull = target - base;
  const Vec3 side = cross(way, pull);
  const bool is_straight = length(way) > (1 - kStraight) * reach;
  if (n > 2 && is_straight &&
      dot(side, side) < 1e-12 * dot(way, way) * std::max(dot(pull, pull), dot(way, way))) {
    const Vec3 aside = std::abs(way.z) < 0.9 * length(way) ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    const Vec3 normal = cross(cross(way, aside), way);
    const double size = length(normal);
    for (size_t i = 1; i + 1 < n && size > 0; ++i) {
      chain[i] = chain[i] + normal * (1e-3 * reach / size);
    }
  }
  for (int round = 0; round < options.rounds; ++round) {
    if (distance(chain[n - 1], target) <= options.near * reach) break;
    chain[n - 1] = target;
    for (size_t i = n - 1; i-- > 0;) chain[i] = towards(chain[i + 1], chain[i], lengths[i]);
    chain[0] = base;
    for (size_t i = 0; i + 1 < n; ++i) chain[i + 1] = towards(chain[i], chain[i + 1], lengths[i]);
  }
  return true;
}

class Reacher {
 public:
  Reacher(const Rig& rig, const Pose& pose, const ReachOptions& options)
      : rig_(rig), options_(options), pose_(pose), motions_(posed(rig, pose)) {}

  Pose take() { return std::move(pose_); }
  Vec3 placeOf(uint32_t joint) const { return motions_[joint](rig_.joints[joint].position); }

  void moveRoot(uint32_t root, Vec3 target) {
    JointMotion& own = pose_[rig_.joints[root].id];
    own.move = own.move + (target - placeOf(root));
    motions_ = posed(rig_, pose_);
  }

  /// path: joints from the base to the end, each the parent of the next.
  void bendTo(const std::vector<uint32_t>& path, Vec3 target) {
    std::vector<Vec3> chain;
    for (const uint32_t joint : path) chain.push_back(placeOf(joint));
    if (!bend(chain, target, options_)) return;
    for (size_t i = 0; i + 1 < path.size(); ++i) {
      const Rigid& now = motions_[path[i]];
      const Vec3 from = now(rig_.joints[path[i + 1]].position) - now(rig_.joints[path[i]].position);
      turn(path[i], between(from, chain[i + 1] - chain[i]));
      motions_[path[i + 1]] = parentMotion(path[i + 1]) * ownMotion(path[i + 1]);
    }
    motions_ = posed(rig_, pose_);
  }

 private:
  Rigid parentMotion(uint32_t joint) const {
    const int32_t parent = rig_.joints[joint].parent;
    return parent < 0 ? Rigid{} : motions_[static_cast<size_t>(parent)];
  }
  Rigid ownMotion(uint32_t joint) const {
    const auto found = pose_.find(rig_.joints[joint].id);
    if (found == pose_.end()) return {};
    return rotationAbout(rig_.joints[joint].position, normalised(found->second.rotation),
                         found->second.move);
  }
  /// Turns a joint, and its motion, in space.
  void turn(uint32_t joint, const Quaternion& rotation) {
    JointMotion& own = pose_[rig_.joints[joint].id];
    const Quaternion parent = parentMotion(joint).rotation;
    own.rotation = normalised(conjugate(parent) * rotation * parent * normalised(own.rotation));
    motions_[joint] = parentMotion(joint) * ownMotion(joint);
  }

  const Rig& rig_;
  const ReachOptions& options_;
  Pose pose_;
  std::vector<Rigid> motions_;
};

/// From the nearest joint above that is `fixed`, or else the root, down to the joint.
std::vector<uint32_t> pathTo(const Rig& rig, uint32_t joint, const std::vector<char>& fixed) {
  std::vector<uint32_t> path{joint};
  while (rig.joints[path.back()].parent >= 0) {
    path.push_back(static_cast<uint32_t>(rig.joints[path.back()].parent));
    if (fixed[path.back()]) break;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

Pose reach(const Rig& rig, const Pose& pose, uint32_t joint, Vec3 target,
           const std::vector<uint32_t>& pins, const ReachOptions& options) {
  if (joint >= rig.joints.size() || !isFinite(target)) return pose;
  std::vector<char> fixed(rig.joints.size(), 0);
  Reacher reacher(rig, pose, options);
  std::vector<std::pair<uint32_t, Vec3>> held;  // parents before their children
  for (const uint32_t pin : pins) {
    if (pin >= rig.joints.size() || pin == joint || fixed[pin]) continue;
    fixed[pin] = 1;
    held.push_back({pin, reacher.placeOf(pin)});
  }
  std::sort(held.begin(), held.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });

  const std::vector<uint32_t> path = pathTo(rig, joint, fixed);
  if (path.size() == 1) {
    reacher.moveRoot(joint, target);
  } else {
    reacher.bendTo(path, target);
  }
  for (const uint32_t on_the_way : path) fixed[on_the_way] = 1;
  for (const auto& [pin, place] : held) {
    const std::vector<uint32_t> chain = pathTo(rig, pin, fixed);
    if (chain.size() > 1) reacher.bendTo(chain, place);
  }
  return reacher.take();
}

}  // namespace marrow
