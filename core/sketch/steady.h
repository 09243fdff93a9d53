// A closed curve → the polygon that its skeleton is made from: a little change of the curve changes
// it little.
#pragma once

#include <vector>

#include "sketch/arc_curve.h"

namespace marrow {

/// Samples of a closed curve at even distances of about a third of `step`, averaged over about
/// `step` to either side: neither where the hand's samples lie nor how it trembles shows. Where it
/// starts on the curve does not matter, but for rounding.
std::vector<Vec2> steadyCurve(const ArcCurve& curve, double step);

/// Of such samples the vertices that are needed to keep within a fiftieth of `step`; of long
/// curves, which would have more than a thousand, within a fifth. Not necessarily simple: smaller
/// steps follow the curve more closely.
std::vector<Vec2> fewVertices(const std::vector<Vec2>& samples, double step);

/// A counter-clockwise polygon with edges shorter than `step` across corners that turn sharply
/// inward. The straight skeleton's vertices would run ahead of the others there, the faster the
/// sharper, and cut the shape in two. With bevels it comes close to the medial axis [Tănase &
/// Veltkamp 2004].
std::vector<Vec2> bevelled(const std::vector<Vec2>& polygon, double step);

}  // namespace marrow
