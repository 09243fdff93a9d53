// Sub-skeletons and connections → a rig, as coarse as asked for  [RS §3.3, Figs 10 and 11]
#pragma once

#include <vector>

#include "rig/rig.h"

namespace marrow {

/// Always from the unrefined skeletons, so that a threshold taken back gives back the same rig.
///
/// ε_s decides which samples of a branch are joints. The other three compare lengths along the
/// unrefined axes, and classes of joints (terminal, junction) are those of the unrefined, connected
/// skeleton: more of any threshold never gives more joints, whatever the others are.
/// - merge: a way between two junctions shorter than ε_m becomes one joint, and so on through the
///   cluster;
/// - prune: a way from a junction to a terminal shorter than ε_t goes; not one that holds the
///   longest branch of a part, or a root;
/// - collapse: ways between inner joints shorter than ε_c become one joint; sleeves go to the
///   junction within ε_c, or in groups no longer than ε_c to their middle.
/// A joint that takes others in keeps its id: the one nearest to the root.
///
/// The root of a tree is the part nobody holds, or the one the user chose; there, the junction (or
/// end) from which all others are nearest. Every tree has one, whatever the thresholds.
Rig refineRig(const std::vector<RigPart>& parts, const std::vector<Connection>& connections,
              const Refinement& model);

/// connectParts and refineRig.
Rig makeRig(const std::vector<RigPart>& parts, const Refinement& model);

}  // namespace marrow
