// Which points of a branch become joints: Douglas–Peucker that heeds the shape around the axis and
// stays inside it  [RS §3.1, Algorithms 1 and 2, Fig. 7]
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "base/vec.h"
#include "skeleton/inside.h"
#include "sketch/mirror_line.h"

namespace marrow {

/// A point of a branch with the segment s_i that the polygon cuts from the line across it.
struct BranchSample {
  Vec2 point;
  Vec2 normal;        // unit, across the branch, to its left
  double along = 0;   // arc length from the branch's start
  double left = 0;    // from the point to the border, along the normal
  double right = 0;   // and against it
  double radius = 0;  // inscribed
  double depth = 0;   // z of the axis there; other than 0 in imported parts alone
};

/// The middle of a branch.
struct AxisLine {
  const std::vector<Vec2>& points;
  const std::vector<double>& radii;  // inscribed, one per point
  std::vector<size_t> corners;       // points that the samples are to go through, ascending
};

/// Samples of a branch at even distances of about `step`, first and last point and corners
/// included.
///
/// The line's edges lie inside the region. Between corners it is averaged over about half of the
/// radius to either side: what a hand's tremor makes of the middle goes. Where that would leave the
/// region, the samples follow the line and contain all of its points. Every segment between samples
/// lies inside the region. At most kMaxSamples + the line's points, at least three.
std::vector<BranchSample> sampleBranch(const Region& region, const AxisLine& line, double step);
constexpr size_t kMaxSamples = 256;

/// The same for a line whose one half is the mirror image of the other, with a point in the middle:
/// the samples are so, too.
std::vector<BranchSample> sampleMirroredBranch(const Region& region, const AxisLine& line,
                                               double step, const MirrorLine& mirror);

/// A sample in the mirror, of a branch that is walked the same way.
BranchSample mirrored(const BranchSample& sample, const MirrorLine& mirror);

struct BoundedDpOptions {
  double epsilon = 5.0;       // threshold, model units
  double shape_weight = 1.0;  // α_s of Equation 1
  double shrink = 0.8;        // the threshold's factor for the halves of a bone that left the shape
};

/// The indices of the samples to keep, ascending, first and last included. Every segment between
/// two of them lies inside the region. A larger epsilon keeps a subset.
///
/// Sections count up to 1.1 inscribed radii on either side (beyond, the line across looks into
/// another limb), and errors count for less where a bone would be short against its balls.
/// A bone that leaves the inner half of the region Ω is split at its largest error, and its halves
/// are measured with the threshold × shrink, or with that error where it is larger. (Shrinking the
/// threshold of the whole branch, as Algorithm 2 does, adds joints where none is needed, and a
/// larger start threshold can end with more of them.)
std::vector<size_t> boundedDp(const Region& region, const std::vector<BranchSample>& samples,
                              const BoundedDpOptions& options);

/// For all thresholds at once: one level per sample, model units. A sample is kept by boundedDp
/// where epsilon is below its level, and always where that is infinite (the ends; what a bone needs
/// to stay inside). Only levels above options.epsilon are told apart, the others are 0.
std::vector<double> branchLevels(const Region& region, const std::vector<BranchSample>& samples,
                                 const BoundedDpOptions& options);
/// Raises levels until at every threshold every bone lies inside the region, as branchLevels alone
/// has it; for levels that were changed.
void keepInside(const Region& region, const std::vector<BranchSample>& samples,
                std::vector<double>& levels);
inline bool isKept(double level, double epsilon) {
  return level > epsilon || level == std::numeric_limits<double>::infinity();
}

}  // namespace marrow
