// Which part hangs on which, and where  [RS §3.2, Equation 3, Figs 8 and 9]
#pragma once

#include <vector>

#include "rig/rig.h"

namespace marrow {

struct ConnectOptions {
  double overlap =
      0.15;  // proxies overlap plainly where they do by this share of the smaller radius
};

/// One connection at most per part with bones, none closing a circle. A function of the document:
/// thresholds play no part in it, so refining never changes who hangs where.
///
/// Attachments that the user gave come first. Every other part is tested against the earlier ones,
/// not against its own mirror image, and hangs on the one that it penetrates deepest relative to
/// the radius there, the earlier one on a tie: by a terminal or junction joint of its own inside
/// the parent's balls and cones; failing that, by an overlap of the proxies. Twins that nothing
/// else holds may hang on each other. The place is the nearest one over (terminal or junction joint
/// of the child) × (bone or joint of the parent). O(n²) boxes, and joints × bones where boxes meet.
std::vector<Connection> connectParts(const std::vector<RigPart>& parts,
                                     const ConnectOptions& options = {});

}  // namespace marrow
