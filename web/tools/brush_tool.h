// The weight brush: paints on the posed character where the surface lies under the pointer.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera.h"
#include "document/command.h"
#include "figure/figure.h"

namespace marrow {

/// A place on the figure that can be seen.
struct FigureHit {
  size_t triangle = 0;
  Vec3 at_rest;  // where it lies at rest; space
  double depth = 0;
};

/// A figure in a pose, seen by a camera: to find what lies under pixels.
class SeenFigure {
 public:
  SeenFigure() = default;
  /// motions: of the figure's joints. O(vertices).
  SeenFigure(std::shared_ptr<const Figure> figure, const std::vector<Rigid>& motions, Skinning how,
             const Camera& camera, ViewSize size);
  /// The nearest to the viewer. O(triangles).
  std::optional<FigureHit> at(Vec2 pixel) const;
  /// Id of the placed part that a triangle belongs to.
  std::string partOf(size_t triangle) const;

 private:
  std::shared_ptr<const Figure> figure_;
  std::vector<Vec3> seen_;  // x, y: CSS pixels; z: towards the viewer
};

class BrushTool {
 public:
  struct Brush {
    WeightStroke::Kind kind = WeightStroke::Kind::add;
    std::string joint;  // whose weight is meant
    double radius = 0;  // model units
    double strength = 1;
  };
  /// Whether there is something to paint on under the pixel.
  bool begin(SeenFigure seen, const Brush& brush, Vec2 pixel, const Document& document,
             const Rig& rig);
  /// The pointer goes on from where it was; between, there is paint as well.
  void move(Vec2 pixel);
  void end() { seen_ = {}; }
  /// What has been painted, if anything.
  std::optional<Command> command() const;

 private:
  void dab(Vec2 pixel);

  SeenFigure seen_;
  WeightStroke stroke_;
  Vec2 last_px_;
};

}  // namespace marrow
