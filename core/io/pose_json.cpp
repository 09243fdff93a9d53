#include "io/pose_json.h"

#include "io/part_json.h"

namespace marrow {

Json poseToTree(const NamedPose& pose) {
  Json extra = extraFields(pose.extra);
  Json of_joints = takeInner(extra, "joints");
  Json tree = Json::object();
  tree["name"] = pose.name;
  Json& joints = tree["joints"] = Json::object();
  for (const auto& [id, motion] : pose.joints) {
    Json& one = joints[id] = Json::object();
    const Quaternion& q = motion.rotation;
    if (q != Quaternion{}) {
      one["rotation"] = Json::array({toJson(q.x), toJson(q.y), toJson(q.z), toJson(q.w)});
    }
    if (motion.move != Vec3{}) one["move"] = toJson(motion.move);
    appendFields(one, takeInner(of_joints, id.c_str()));
  }
  appendFields(tree, extra);
  return tree;
}

NamedPose readPose(const Json& tree, const std::string& where, Fault& fault) {
  NamedPose pose;
  ObjectReader reader(tree, where, fault);
  pose.name = reader.text("name");
  if (pose.name.empty()) reader.say("name", "is missing.");
  if (const Json* joints = reader.object("joints")) {
    ObjectReader of_joints(*joints, reader.where("joints"), fault);
    if (joints->size() > NamedPose::kMostJoints) reader.say("joints", "are too many.");
    for (const auto& item : joints->items()) {
      if (fault.error()) break;
      const Json* object = of_joints.object(item.key());
      if (!object) break;
      ObjectReader one(*object, of_joints.where(item.key()), fault);
      const auto motion = withUnitRotation({one.rotation("rotation"), one.vector("move", {})});
      if (!motion) one.say("rotation", "is no rotation.");
      pose.joints[item.key()] = motion.value_or(JointMotion{});
      of_joints.keepInner(item.key(), one);
    }
    reader.keepInner("joints", of_joints);
  }
  pose.extra = toText(reader.rest());
  return pose;
}

}  // namespace marrow
