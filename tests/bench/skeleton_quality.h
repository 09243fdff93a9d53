// How steady and how symmetric the skeletons of single strokes are.
#pragma once

#include <vector>

#include "bench/quality.h"
#include "support/strokes.h"

namespace marrow::bench {

/// drawings: closed strokes of any size. Sizes are the longer sides of their boxes; how far bones
/// are apart is the two-sided Hausdorff distance of all points on them.
std::vector<QualityRow> skeletonQuality(const std::vector<strokes::NamedStroke>& drawings,
                                        bool verbose = false);

}  // namespace marrow::bench
