// One pose of a document ↔ JSON tree.
#pragma once

#include <string>

#include "document/pose.h"
#include "io/json.h"
#include "io/object_reader.h"

namespace marrow {

/// {"name", "joints": {id: {"rotation": [x, y, z, w], "move": [x, y, z]}, …}}; a motion's fields
/// may be missing where they are nothing.
Json poseToTree(const NamedPose& pose);
NamedPose readPose(const Json& tree, const std::string& where, Fault& fault);

}  // namespace marrow
