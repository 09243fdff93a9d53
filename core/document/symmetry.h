// The character's plane of symmetry, and which strokes get a twin.
#pragma once

#include <optional>
#include <vector>

#include "document/document.h"

namespace marrow {

/// The plane the user gave; else one through the first part: a body drawn clearly wider than high
/// is seen from its side, so the plane is that of the drawing; any other is seen from its front, so
/// the plane stands upright on the drawing, through the middle of the body. Nothing in a document
/// without parts.
std::optional<Plane> symmetryPlane(const Document& document);

/// Whether a stroke lies off the plane, so that symmetry gives it a twin: where it is drawn on
/// (nearly) parallel to the plane, further from it than half its area ÷ perimeter, which is half of
/// a limb's half width; else where less than an eighth of its extent across the plane lies on the
/// other side.
bool isOffPlane(const std::vector<Vec2>& stroke, const Frame& frame, const Plane& plane);

/// The closed outline that a half outline makes with its mirror image; nothing where the stroke is
/// no half outline: its plane does not stand upright on the plane of symmetry, its ends lie more
/// than `reach` from it or close to each other, or it runs on both sides of it.
std::optional<std::vector<Vec2>> completedByMirror(const std::vector<Vec2>& stroke,
                                                   const Frame& frame, const Plane& plane,
                                                   double reach);

}  // namespace marrow
