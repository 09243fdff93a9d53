#include "warm_up.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr double kTurn = 6.28318530717958647692;

// A closed curve whose distance from the middle swings `lobes` times by `swing`; with an uneven
// number of half turns it crosses itself.
std::vector<Vec2> flower(int samples, double lobes, double swing, double turns) {
  std::vector<Vec2> points;
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    const double angle = kTurn * turns * t;
    const double radius = 150 * (1 + swing * std::cos(lobes * kTurn * t));
    points.push_back({radius * std::cos(angle), 0.8 * radius * std::sin(angle)});
  }
  return points;
}

std::vector<Vec2> rectangle(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

}  // namespace

WarmUp::WarmUp()
    : strokes_{rectangle(300, 60),      flower(60, 3, 0.2, 1),  flower(300, 5, 0.45, 1),
               flower(400, 9, 0.35, 1), flower(300, 3, 0.5, 2), flower(200, 2, 0.1, 1)} {}

void WarmUp::step() {
  const std::vector<Vec2>& stroke = strokes_[stroke_];
  const PartOptions options = previewOptions();
  bool finished = false;
  switch (stage_) {
    case 0:
      if (auto outline = makeOutline(stroke)) outline_ = std::move(*outline);
      break;
    case 1:
      if (auto made = straightSkeleton(outline_.polygon)) straight_skeleton_ = std::move(*made);
      break;
    case 2:
      if (auto axis = extractAxis(outline_.polygon, straight_skeleton_)) axis_ = std::move(*axis);
      break;
    case 3:
      if (auto made = placeJoints(outline_.polygon, axis_, outline_.scale())) {
        skeleton_ = std::move(*made);
      }
      break;
    case 4:
      if (auto flat = triangulate(outline_.dense, options.triangulation)) flat_ = std::move(*flat);
      break;
    case 5:
      if (auto mesh = inflate(flat_, 50)) {
        vertexNormals(*mesh);
        proxyRadii(skeleton_, *mesh);
      }
      break;
    case 6:
      (void)buildPart(stroke, options);
      break;
    default:
      (void)buildPart(stroke);
      finished = true;
  }
  stage_ = finished ? 0 : stage_ + 1;
  if (!finished) return;
  ++runs_;
  stroke_ = (stroke_ + 1) % strokes_.size();
}

void WarmUp::slice(double budget_ms, Clock clock) {
  const double start_ms = clock();
  double now_ms = start_ms;
  while (!done_ && now_ms - start_ms < budget_ms) {
    step();
    const double after_ms = clock();
    longest_ms_ = std::max(longest_ms_, after_ms - now_ms);
    spent_ms_ += after_ms - now_ms;
    now_ms = after_ms;
    done_ = spent_ms_ >= kEnough_ms;
  }
}

}  // namespace marrow
