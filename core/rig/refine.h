// Sub-skeletons and connections → a rig, as coarse as asked for  [RS §3.3, Figs 10 and 11]
#pragma once

#include <vector>

#include "rig/rig.h"

namespace marrow {

/// Always from the unrefined skeletons, so that a threshold taken back gives back the same rig.
///
/// ε_s decides which samples of a branch are joints; it is measured on the outline of the part that
/// holds the tree, not on each part's own. What a bone needs to stay inside is always one. The
/// other three compare lengths along the unrefined axes, between joints as they are in the
/// unrefined, connected skeleton. A way is the path from one joint that has not two bones (or is a
/// root) to the next; the thresholds of a way are those of the part at its far end.
/// - merge: a way between two junctions shorter than ε_m becomes one joint, in the mean of them,
/// and
///   so on through the cluster;
/// - prune: a way from a junction to a terminal shorter than ε_t goes;
/// - collapse: a way between inner joints shorter than ε_c becomes one joint. A sleeve goes where
///   its way ends at an inner joint, or where a sleeve that matters more is, within ε_c; not
///   where a bone needs it to stay inside.
/// The way that holds most of a part stays whatever the thresholds: each part keeps a bone.
///
/// So more of any threshold, at any scope, never gives more joints, whatever the others are, and
/// the joints it leaves were all there before: a joint that takes others in is the one nearest to
/// the root, with its id and name.
///
/// The root of a tree is the part nobody holds, or the one the user chose; there, the junction (or
/// end) from which all others are nearest. Every tree has one, whatever the thresholds.
///
/// connections: what connectParts gave for the same parts.
Rig refineRig(const std::vector<RigPart>& parts, const std::vector<Connection>& connections,
              const Refinement& model);

/// connectParts and refineRig.
Rig makeRig(const std::vector<RigPart>& parts, const Refinement& model);

}  // namespace marrow
