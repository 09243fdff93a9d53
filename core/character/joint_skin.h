// From weights of bones to what a vertex follows. Internal to this room.
#pragma once

#include <vector>

#include "pose/skin.h"
#include "rig/rig.h"
#include "weights/skin_weights.h"
#include "weights/weight_strokes.h"

namespace marrow {

/// The weights of bones as those of the joints that they leave.
std::vector<JointWeights> jointWeights(const std::vector<Influences>& influences, const Rig& rig);

/// The largest few, equal ones all or none (see shareKept); none: the first joint.
VertexSkin skinOf(JointWeights weights);

}  // namespace marrow
