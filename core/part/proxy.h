// Cylinder–ball proxy of a part  [RS §3.2, Fig. 9]
#pragma once

#include <vector>

#include "skeleton/joints.h"
#include "surface/mesh.h"

namespace marrow {

/// One radius per joint, model units: the mean distance from the joint to the contour in which the
/// plane through the joint, perpendicular to a bone, cuts the mesh; the mean over its bones. A
/// bone's cone has its ends' radii. Only the loop of the contour that surrounds the joint counts,
/// and of it what is no further than 1.5 given radii to either side in the part's plane: beyond,
/// the cut runs along another limb. Where a cut misses the mesh, the joint's given radius stays.
std::vector<double> proxyRadii(const PartSkeleton& skeleton, const Mesh& mesh);

}  // namespace marrow
