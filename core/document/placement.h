// What keeps frames and planes sound, whatever maps and files do to them.
#pragma once

#include <optional>

#include "document/document.h"

namespace marrow {

/// Lengths of a frame's x and y.
constexpr double kSmallestScale = 1 / kLargestCoordinate, kLargestScale = kLargestCoordinate;

/// x and y are orthogonal and equally long, but for rounding, and nothing is beyond the largest
/// coordinate.
bool isSound(const Frame& frame);

/// A sound frame in a plane that any two directions span.
struct FrameFit {
  Frame frame;
  bool even = true;               // the directions were those of a sound frame, but for rounding
  double xx = 1, xy = 0, yy = 1;  // else: where the stroke's points belong in the frame

  Vec2 operator()(Vec2 p) const { return {xx * p.x + xy * p.y, yy * p.y}; }
};
/// Nothing where the directions span no plane, or leave the drawable.
std::optional<FrameFit> fitFrame(Vec3 origin, Vec3 x, Vec3 y);

/// Makes the part's frame sound, and brings its stroke and mesh along; false where there is none.
bool fitInFrame(PartSource& part);

/// All points of the stroke are drawable, in its plane and in space.
bool isDrawable(const std::vector<Vec2>& stroke, const Frame& frame);
/// And those of its mesh, at any thickness.
bool isDrawable(const PartSource& part);

/// The mesh seen in the mirror z = 0.
Mesh flipped(const Mesh& mesh);

/// The plane with a unit normal; nothing where it is none or too far away. What it gives, it gives
/// back unchanged.
std::optional<Plane> normalised(const Plane& plane);

/// The map as seen in the mirror: what it does to twins when their parts are mapped.
Affine mirrored(const Affine& map, const Plane& plane);

/// Where the map takes the plane; nothing where it flattens it, or leaves the drawable.
std::optional<Plane> mapped(const Plane& plane, const Affine& map);

/// Frame, stroke and thickness of the part after the map, which may mirror. A pure move changes the
/// origin alone, a similarity the frame alone; what is stretched unevenly goes into the stroke and
/// the thickness; of an imported part it goes into the mesh. Errors: noArea.
Result<PartSource> mapped(const PartSource& part, const Affine& map);

}  // namespace marrow
