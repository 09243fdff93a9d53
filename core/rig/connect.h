// Which part hangs on which, and where  [RS §3.2, Equation 3, Figs 8 and 9]
#pragma once

#include <vector>

#include "rig/rig.h"

namespace marrow {

struct ConnectOptions {
  double overlap =
      0.15;  // proxies overlap plainly where they do by this share of the smaller radius
};

/// One connection at most per part, none closing a circle, by child. A function of the document:
/// thresholds play no part in it, so refining never changes who hangs where.
///
/// Attachments that the user gave come first, in modelling order. One that names a part that is not
/// there, or has no bones, or hangs on the child itself, is passed over. A twin hangs on the mirror
/// image of what its part was told: on the other one of a pair, else across the child's plane.
///
/// Every other part is tested against the earlier ones, not against its own mirror image, and hangs
/// on the one that it penetrates deepest relative to the radius there, the earlier one on a tie: by
/// a terminal or junction joint of its own inside the parent's balls and cones; failing that, by an
/// overlap of the proxies, or of the bodies where the proxies are too coarse to tell. Where only
/// one of a pair of twins finds a parent, the other hangs on that one's other side, unless it is
/// plainly away from it. Then twins that nothing holds are tested against their parts, and at last
/// what still hangs nowhere against the later parts of other trees: legs that were drawn before the
/// body are no trees of their own.
///
/// The place is the nearest one over (terminal or junction joint of the child) × (bone or joint of
/// the parent). Parts without bones of their own (PartSource::skeleton) are children like the
/// others, but hold nothing. O(n²) boxes, and joints × bones where boxes meet.
std::vector<Connection> connectParts(const std::vector<RigPart>& parts,
                                     const ConnectOptions& options = {});

}  // namespace marrow
