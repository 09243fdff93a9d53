#include "document/joint_id.h"

namespace marrow {

std::string quotedPart(const std::string& placed_id) {
  std::string text;
  for (const char c : placed_id) text.append(c == '/' ? 2 : 1, c);
  return text;
}

std::string unquotedPart(const std::string& quoted) {
  std::string id;
  for (size_t i = 0; i < quoted.size(); ++i) {
    id += quoted[i];
    if (quoted[i] == '/' && i + 1 < quoted.size() && quoted[i + 1] == '/') ++i;
  }
  return id;
}

size_t lengthOfPart(const std::string& joint) {
  for (size_t i = 0; i < joint.size(); ++i) {
    if (joint[i] != '/') continue;
    if (i + 1 == joint.size() || joint[i + 1] != '/') return i;
    ++i;
  }
  return joint.size();
}

std::string partOfJoint(const std::string& joint) {
  return unquotedPart(joint.substr(0, lengthOfPart(joint)));
}

}  // namespace marrow
