#include "tools/brush_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow {
namespace {

constexpr double kStep_px = 6;  // of the way between two moves

/// Twice the area of the triangle, counter-clockwise on a screen whose y points down.
double area(Vec3 a, Vec3 b, Vec2 p) {
  return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
}

}  // namespace

SeenFigure::SeenFigure(std::shared_ptr<const Figure> figure, const std::vector<Rigid>& motions,
                       Skinning how, const Camera& camera, ViewSize size)
    : figure_(std::move(figure)) {
  const Vec3 back = camera.axes()[2];
  const SkinnedVertices posed = posedVertices(*figure_, motions, how);
  for (const Vec3 at : posed.positions) {
    const Vec2 pixel = camera.toScreen(at, size);
    seen_.push_back({pixel.x, pixel.y, dot(back, at)});
  }
}

std::optional<FigureHit> SeenFigure::at(Vec2 pixel) const {
  std::optional<FigureHit> hit;
  if (!figure_) return hit;
  for (size_t t = 0; t < figure_->triangles.size(); ++t) {
    const auto& triangle = figure_->triangles[t];
    const Vec3 a = seen_[triangle[0]], b = seen_[triangle[1]], c = seen_[triangle[2]];
    const double u = area(b, c, pixel), v = area(c, a, pixel), w = area(a, b, pixel);
    // Those that face the viewer run the other way round on a screen whose y points down.
    if (u > 0 || v > 0 || w > 0 || !(u + v + w < 0)) continue;
    const double sum = u + v + w;
    const double depth = (u * a.z + v * b.z + w * c.z) / sum;
    if (hit && depth <= hit->depth) continue;
    const auto place = [&](size_t k) {
      const auto& p = figure_->vertices[triangle[k]].position;
      return figure_->origin + Vec3{p[0], p[1], p[2]};
    };
    hit = FigureHit{t, (place(0) * u + place(1) * v + place(2) * w) / sum, depth};
  }
  return hit;
}

std::string SeenFigure::partOf(size_t triangle) const {
  for (const Figure::Stretch& stretch : figure_->stretches) {
    if (triangle >= stretch.first && triangle < stretch.first + stretch.count) return stretch.part;
  }
  return {};
}

bool BrushTool::begin(SeenFigure seen, const Brush& brush, Vec2 pixel, const Document& document,
                      const Rig& rig) {
  seen_ = std::move(seen);
  stroke_ = {};
  stroke_.kind = brush.kind;
  stroke_.joint = brush.joint;
  stroke_.radius = brush.radius;
  stroke_.strength = brush.strength;
  last_px_ = pixel;
  const auto hit = seen_.at(pixel);
  if (!hit) return false;
  stroke_.part = seen_.partOf(hit->triangle);
  stroke_.points.push_back(hit->at_rest);
  stroke_ = forJointOfRig(document, rig, std::move(stroke_));
  return true;
}

void BrushTool::move(Vec2 pixel) {
  const Vec2 from = last_px_;
  const double steps = std::ceil(distance(from, pixel) / kStep_px);
  for (double k = 1; k <= steps; ++k) dab(lerp(from, pixel, k / steps));
  last_px_ = pixel;
}

void BrushTool::dab(Vec2 pixel) {
  if (stroke_.points.size() >= WeightStroke::kMostPoints) return;
  if (const auto hit = seen_.at(pixel)) stroke_.points.push_back(hit->at_rest);
}

std::optional<Command> BrushTool::command() const {
  if (stroke_.points.empty() || stroke_.part.empty()) return std::nullopt;
  return AddWeightStroke{stroke_};
}

}  // namespace marrow
