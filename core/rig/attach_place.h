// Where exactly a part hangs on another one. Internal to connecting.
#pragma once

#include "rig/body_overlap.h"
#include "rig/part_proxy.h"

namespace marrow {

/// A part that is connected.
struct AttachSide {
  const PartProxy& proxy;
  const PartBody& body;
};

/// Fills in the places of a connection: on the child, where its bones are nearest to the parent's
/// among what lies in the overlap, or else nearest to the overlap; on the parent, where its bones
/// are nearest to that. Where a bone between the two would leave both bodies, the next best places
/// are taken, at last those whose bone leaves them least. Of places that are as good, the one in
/// the middle of the overlap: a fin hangs by its middle. Within a ball around an end or a junction
/// of the child it hangs by that. O(bones² + bones × points of the overlap).
void placeAtOverlap(const AttachSide& child, const AttachSide& parent, Connection& connection);

/// Fills in the place on the parent's skeleton nearest to p; gives its distance. [Equation 3, with
/// |v_i v_k| sin θ]
double placeOnParent(const PartProxy& parent, Vec3 p, Connection& connection);

/// Fills in the place on the child's skeleton nearest to p, as above.
void placeOnChild(const PartProxy& child, Vec3 p, Connection& connection);

}  // namespace marrow
