// How the ids of joints (see Rig::Joint::id) are made of those of placed parts.
#pragma once

#include <string>

namespace marrow {

/// As ids of parts stand in those of joints: each '/' is doubled.
std::string quotedPart(const std::string& placed_id);
std::string unquotedPart(const std::string& quoted);

/// How much of a joint's id its part's is, as it stands there: up to the first '/' that is not
/// doubled.
size_t lengthOfPart(const std::string& joint);
/// The id of the placed part that the joint belongs to.
std::string partOfJoint(const std::string& joint);

}  // namespace marrow
