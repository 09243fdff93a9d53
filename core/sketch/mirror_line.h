// Is a shape its own mirror image, up to the hand's tremor?
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// A line in the plane across which things are mirrored.
struct MirrorLine {
  Vec2 through;
  Vec2 along;  // unit

  Vec2 mirrored(Vec2 p) const {
    const Vec2 away = p - through;
    return through + along * (2 * dot(away, along)) - away;
  }
  /// Distance from it, positive on its left.
  double side(Vec2 p) const { return cross(along, p - through); }
  Vec2 foot(Vec2 p) const { return through + along * dot(p - through, along); }
};

struct MirrorFit {
  MirrorLine line;
  /// Area that the shape shares with its mirror image ÷ the area of both together; about.
  double overlap = 0;
  /// Midway between the shape and its mirror image: the curve from about where it meets the line
  /// counter-clockwise to about where it meets it again, as fine as the samples are.
  std::vector<Vec2> half;
};

/// Such a half with its mirror image: closed, counter-clockwise, first vertex on the line, the
/// images of vertices 1, 2, … last, last but one, …
std::vector<Vec2> mirroredWhole(const MirrorFit& fit);

/// The line across which a closed curve is most like its mirror image. Of lines that fit about
/// equally well, the most upright one.
///
/// samples: at even distances, counter-clockwise, at least 12. Nothing where it is not like its
/// mirror image at all. O(samples) after O(1) work on some hundred of them.
/// How: both run along the curve in opposite directions, so their alignment is one number, how far
/// along they start; the correlation for all of them is one sum each. For the best one the two
/// sides are brought together by dynamic programming.
std::optional<MirrorFit> findMirrorLine(const std::vector<Vec2>& samples);

}  // namespace marrow
