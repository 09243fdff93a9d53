#include "character/joint_skin.h"

#include <algorithm>
#include <array>
#include <utility>

namespace marrow {
namespace {

/// The weights of bones as those of the joints that they leave.
JointWeights ofVertex(const Influences& influences, const Rig& rig) {
  std::array<JointWeight, kMostInfluences> weights;
  auto end = weights.begin();
  for (const Influence& one : influences) {
    if (!(one.weight > 0)) continue;
    const uint32_t joint = rig.bones[one.bone][0];
    const auto at = std::find_if(weights.begin(), end,
                                 [&](const JointWeight& other) { return other.joint >= joint; });
    if (at != end && at->joint == joint) {
      at->weight += one.weight;
    } else {
      std::move_backward(at, end, end + 1);
      *at = {joint, one.weight};
      ++end;
    }
  }
  return JointWeights(weights.begin(), end);
}

}  // namespace

std::vector<JointWeights> jointWeights(const std::vector<Influences>& influences, const Rig& rig) {
  std::vector<JointWeights> weights;
  weights.reserve(influences.size());
  for (const Influences& one : influences) weights.push_back(ofVertex(one, rig));
  return weights;
}

VertexSkin skinOf(JointWeights joints) {
  std::sort(joints.begin(), joints.end(), [](const JointWeight& a, const JointWeight& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  if (joints.size() > VertexSkin::kMost) {
    const double gone = joints[VertexSkin::kMost].weight;
    joints.resize(VertexSkin::kMost);
    if (shareKept(joints[0].weight, gone) > 0) {
      for (JointWeight& one : joints) one.weight *= shareKept(one.weight, gone);
      while (!(joints.back().weight > 0)) joints.pop_back();
    }
  }
  double sum = 0;
  for (const JointWeight& one : joints) sum += one.weight;
  VertexSkin skin;
  if (!(sum > 0)) return skin;
  double others = 0;
  for (size_t k = joints.size(); k-- > 0;) {
    skin.joints[k] = joints[k].joint;
    skin.weights[k] = k > 0 ? joints[k].weight / sum : 1 - others;
    others += skin.weights[k];
  }
  // Equal but for the rounding of the rest: the order stays.
  for (size_t k = 0; k + 1 < joints.size() && skin.weights[k] < skin.weights[k + 1]; ++k) {
    std::swap(skin.weights[k], skin.weights[k + 1]);
    std::swap(skin.joints[k], skin.joints[k + 1]);
  }
  return skin;
}

}  // namespace marrow
