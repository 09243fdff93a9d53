// What commands that change parts do to the poses of their joints.
//
// Motions are along the axes of space at rest, so where a part is turned at rest, an elbow would
// bend about another axis of the arm than before. What its joints do within their parents is
// therefore turned along: a joint belongs to one part, as its id says, and follows that one,
// whatever becomes of the part that it hangs on. Where a whole character is turned, scaled or
// mirrored, so is all that its poses show. A copy of a part rests, and joints that are gone keep
// their motions till they come back.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "base/frame.h"

namespace marrow {

struct Document;

/// Joints get other ids. Where a pose has the new one already, that motion is lost.
void renamePosed(const std::function<std::string(const std::string& joint)>& rename,
                 Document& document);

/// What became of a placed part: directions in which its joints move became others.
struct PartTurn {
  Affine turn;     // of axes: a rotation, or one and a mirror image
  Affine stretch;  // of moves: what the part was mapped by; where it was moved to says nothing
};
/// Of a part whose frame a map took to another: it turned as its frame did, and where the map
/// mirrors, what lay before its plane lies behind it.
PartTurn turnOf(const Frame& before, const Affine& map, const Frame& now);

/// The joints of parts, by placed ids, turn about the axes, and move along the directions, that
/// theirs became. Poses and motions that this leaves as they are stay so to the bit; moves that
/// would leave the drawable stay, too. O(joints in all poses · log of the parts).
void turnPosed(const std::map<std::string, PartTurn>& turns, Document& document);

}  // namespace marrow
