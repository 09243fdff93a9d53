// A closed simple curve as the hand drew it → evenly spaced vertices, noise averaged away, corners
// kept  [RS §3.1, Fig. 19]
#pragma once

#include <vector>

#include "sketch/arc_curve.h"

namespace marrow {

/// Vertices about `step` apart along the curve. A vertex is the mean of the curve over one step
/// around it, so noise that is shorter than the step goes; where the curve turns sharply within a
/// step, and wherever the even vertices would miss the curve by a good part of a step, a vertex of
/// the curve itself is taken. Where it starts on the curve does not matter, but for rounding.
/// Not necessarily simple: finer steps follow the curve more closely.
std::vector<Vec2> resample(const ArcCurve& curve, double step);

}  // namespace marrow
