#include "sketch/resample.h"

#include <algorithm>
#include <cmath>

#include "sketch/polygon.h"

namespace marrow {
namespace {

// Turning by more than this within a step is a corner: 1 − cos 50°. Below it lies what the pixels
// of a hand's samples make of a smooth line.
constexpr double kCornerTurn = 0.357;
// Between two edges that are this many steps long, even a slight turn is meant: 1 − cos 8°.
constexpr double kLongEdge = 3;
constexpr double kSlightTurn = 0.0097;
// How far the vertices may miss the curve, in steps.
constexpr double kMiss = 0.3;
constexpr int kMissRounds = 4;

double turnBetween(Vec2 in, Vec2 out) {
  const double lengths = length(in) * length(out);
  return lengths > 0 ? 1 - dot(in, out) / lengths : 0;
}

/// The vertices at which the curve turns sharply, in order.
std::vector<size_t> findCorners(const ArcCurve& curve, double step) {
  const std::vector<Vec2>& p = curve.points();
  const size_t n = p.size();
  std::vector<double> turns(n);
  std::vector<size_t> candidates, corners;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 before = p[i > 0 ? i - 1 : n - 1], after = p[i + 1 < n ? i + 1 : 0];
    if (std::min(distance(before, p[i]), distance(p[i], after)) >= kLongEdge * step) {
      turns[i] = turnBetween(p[i] - before, after - p[i]);
      if (turns[i] > kSlightTurn) candidates.push_back(i);
      continue;
    }
    const double arc = curve.arcAt(i);
    turns[i] = turnBetween(p[i] - curve.mean(arc - 1.5 * step, arc - 0.5 * step),
                           curve.mean(arc + 0.5 * step, arc + 1.5 * step) - p[i]);
    if (turns[i] > kCornerTurn) candidates.push_back(i);
  }

  // Of several candidates on one bend the sharpest is its corner.
  const size_t m = candidates.size();
  for (size_t c = 0; c < m; ++c) {
    bool sharpest = true;
    for (const bool ahead : {true, false}) {
      for (size_t k = 1; k < m && sharpest; ++k) {
        const size_t other = candidates[ahead ? (c + k) % m : (c + m - k) % m];
        double gap = std::fabs(curve.arcAt(other) - curve.arcAt(candidates[c]));
        gap = std::min(gap, curve.length() - gap);
        if (gap > 0.75 * step) break;
        const double mine = turns[candidates[c]], theirs = turns[other];
        if (theirs > mine || (theirs == mine && other < candidates[c])) sharpest = false;
      }
    }
    if (sharpest) corners.push_back(candidates[c]);
  }
  return corners;
}

size_t farthestFrom(const std::vector<Vec2>& points, Vec2 from) {
  size_t best = 0;
  double most = distance(points[0], from);
  for (size_t i = 1; i < points.size(); ++i) {
    const double here = distance(points[i], from);
    if (!(here > most)) continue;
    best = i;
    most = here;
  }
  return best;
}

struct Sample {
  Vec2 place;
  double arc;
};

/// Even samples between neighbouring anchors, which are vertices of the curve in order; anchors
/// themselves stay where they are.
std::vector<Sample> sampleBetween(const ArcCurve& curve, const std::vector<size_t>& anchors,
                                  bool keep_anchors, double step) {
  std::vector<Sample> samples;
  samples.reserve(anchors.size() + static_cast<size_t>(1.5 * curve.length() / step));
  for (size_t k = 0; k < anchors.size(); ++k) {
    const bool last = k + 1 == anchors.size();
    const double from = curve.arcAt(anchors[k]);
    const double to = last ? curve.arcAt(anchors[0]) + curve.length() : curve.arcAt(anchors[k + 1]);
    const double count =
        std::max(anchors.size() == 1 ? 3.0 : 1.0, std::floor((to - from) / step + 0.5));
    const double spacing = (to - from) / count;
    for (double i = 0; i < count; ++i) {
      const double arc = from + i * spacing;
      if (i == 0 && keep_anchors) {
        samples.push_back({curve.points()[anchors[k]], arc});
        continue;
      }
      double reach = step / 2;
      if (keep_anchors) reach = std::min({reach, arc - from, to - arc});
      samples.push_back({curve.mean(arc - reach, arc + reach), arc});
    }
  }
  return samples;
}

/// For each chord between samples that misses the curve by more than `allowed`, the vertex of the
/// curve farthest from it; in order.
std::vector<size_t> missedVertices(const ArcCurve& curve, const std::vector<Sample>& samples,
                                   double allowed) {
  std::vector<size_t> missed;
  const size_t n = curve.size();
  size_t vertex = curve.edgeAt(samples[0].arc);  // may be past size(): cyclic
  for (size_t k = 0; k < samples.size(); ++k) {
    const bool last = k + 1 == samples.size();
    const Vec2 a = samples[k].place, b = samples[last ? 0 : k + 1].place;
    const double to = last ? samples[0].arc + curve.length() : samples[k + 1].arc;
    double worst = allowed;
    size_t farthest = n;
    for (;; ++vertex) {
      const double arc =
          vertex < n ? curve.arcAt(vertex) : curve.arcAt(vertex - n) + curve.length();
      if (arc >= to) break;
      if (arc <= samples[k].arc) continue;
      const double miss = distanceToSegment(a, b, curve.points()[vertex % n]);
      if (miss > worst) {
        worst = miss;
        farthest = vertex % n;
      }
    }
    if (farthest < n) missed.push_back(farthest);
  }
  return missed;
}

}  // namespace

std::vector<Vec2> resample(const ArcCurve& curve, double step) {
  std::vector<size_t> anchors = findCorners(curve, step);
  bool keep_anchors = true;
  if (anchors.empty()) {
    anchors.push_back(farthestFrom(curve.points(), areaCentroid(curve.points())));
    keep_anchors = false;
  }

  std::vector<Sample> samples = sampleBetween(curve, anchors, keep_anchors, step);
  for (int round = 0; round < kMissRounds; ++round) {
    const std::vector<size_t> missed = missedVertices(curve, samples, kMiss * step);
    if (missed.empty()) break;
    if (!keep_anchors) anchors.clear();
    keep_anchors = true;
    anchors.insert(anchors.end(), missed.begin(), missed.end());
    std::sort(anchors.begin(), anchors.end());
    anchors.erase(std::unique(anchors.begin(), anchors.end()), anchors.end());
    samples = sampleBetween(curve, anchors, keep_anchors, step);
  }

  std::vector<Vec2> places;
  places.reserve(samples.size());
  for (const Sample& sample : samples) places.push_back(sample.place);
  return places;
}

}  // namespace marrow
