#include "rig/rig.h"

namespace marrow {

const char* toString(AttachEvent event) {
  switch (event) {
    case AttachEvent::split:
      return "split";
    case AttachEvent::connect:
      return "connect";
  }
  return "";
}

const char* toString(AttachTest test) {
  switch (test) {
    case AttachTest::joint:
      return "joint";
    case AttachTest::overlap:
      return "overlap";
    case AttachTest::user:
      return "user";
  }
  return "";
}

bool operator==(const Connection& a, const Connection& b) {
  return a.child == b.child && a.parent == b.parent && a.event == b.event && a.test == b.test &&
         a.child_split == b.child_split && a.child_joint == b.child_joint &&
         a.child_bone == b.child_bone && a.child_along == b.child_along &&
         a.parent_joint == b.parent_joint && a.parent_bone == b.parent_bone && a.along == b.along &&
         a.child_position == b.child_position && a.parent_position == b.parent_position;
}

bool operator==(const Rig::Joint& a, const Rig::Joint& b) {
  return a.id == b.id && a.name == b.name && a.part == b.part && a.branch == b.branch &&
         a.parent == b.parent && a.position == b.position && a.radius == b.radius &&
         a.kind == b.kind;
}

bool operator==(const Rig& a, const Rig& b) {
  return a.joints == b.joints && a.bones == b.bones && a.roots == b.roots &&
         a.connections == b.connections && a.carried == b.carried;
}

}  // namespace marrow
