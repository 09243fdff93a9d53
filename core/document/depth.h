// How deep parts lie, seen by a viewer: in front of each other, behind, level.
#pragma once

#include <optional>

#include "document/command.h"
#include "document/evaluation.h"

namespace marrow {

/// Where parts can lie along the normal of the one named last: the scale of a slider. As long as
/// that part moves along its normal, only `now` changes.
struct DepthScale {
  Vec3 direction;            // unit, of the two normals the one towards the viewer
  double low = 0, high = 0;  // around all other visible parts, with room behind and before them
  double level = 0;          // as deep as the earliest part that it covers or is covered by; where
                             // there is none, as the middle of the others
  double now = 0;            // where the middle of the part is
};
/// Ids of placed parts; hidden parts, twins of the named ones and those without a shape are no
/// others. Nothing where the last id is none of a part with a shape. O(vertices).
std::optional<DepthScale> depthScale(const Evaluation& evaluation, const Ids& ids,
                                     Vec3 towards_viewer);

/// The move along that normal by which the part gets past the next of those that it covers or is
/// covered by: its middle then lies on the near side (`nearer`), or on the far side, of that part.
/// Nothing where there is no such part. O(vertices).
std::optional<Vec3> layerMove(const Evaluation& evaluation, const Ids& ids, Vec3 towards_viewer,
                              bool nearer);

}  // namespace marrow
