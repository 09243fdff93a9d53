// Which part hangs on which, and where  [RS §3.2, Equation 3, Figs 8 and 9]
#pragma once

#include <vector>

#include "rig/rig.h"

namespace marrow {

struct ConnectOptions {
  double share = 0.002;   // bodies overlap where they have more than this of the smaller one's
                          // volume in common: a hundredth always counts, specks never
  double overlap = 0.15;  // or their proxies do, by this share of the smaller radius
};

/// One connection at most per part, none closing a circle, by child. A function of the document:
/// thresholds play no part in it, so refining never changes who hangs where.
///
/// Attachments that the user gave come first, in modelling order. One that names a part that is not
/// there, or has no bones, or hangs on the child itself, is passed over. A twin hangs on the mirror
/// image of what its part was told: on the other one of a pair, else across the child's plane.
///
/// Every other part hangs on an earlier one that it overlaps: whose body has more than specks of
/// the smaller one's volume in common with it, whatever the joints of either say; or which it just
/// touches, while the balls and cones overlap plainly or hold an end of its skeleton. Of several on
/// the one where the bones of either are deepest in the other's balls, relative to the radius, and
/// that shares most with it, the earlier one on a tie; never on its own mirror image. But where a
/// part overlaps several trees that are plainly smaller than it, these were limbs drawn before
/// their body: they hang on it. Where only one of a pair of twins finds a parent, the other hangs
/// on that one's other side, unless it is plainly away from it. Then twins that nothing holds hang
/// on their parts. At last what still are trees of their own but overlap are joined, on the tree
/// whose root is first in modelling order; a tree that meets it with another part than its root is
/// turned round.
///
/// The place is that of placeAtOverlap: where the overlap is, also in the middle of a bone. Parts
/// without bones of their own (PartSource::skeleton) are children like the others, but hold
/// nothing. O(n²) boxes; O(bones² + points of the overlap) where boxes meet.
std::vector<Connection> connectParts(const std::vector<RigPart>& parts,
                                     const ConnectOptions& options = {});

}  // namespace marrow
