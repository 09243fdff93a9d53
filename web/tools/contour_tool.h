// Changes the outline of a part: drags one of its points, or draws over a stretch of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera.h"
#include "document/command.h"
#include "document/evaluation.h"

namespace marrow {

/// Points of the outline, evenly spread on the screen, to show that it can be dragged; world.
std::vector<Vec3> contourHandles(const Part& part, const Frame& frame, const Camera& camera);

/// The place in the frame's plane under a pixel; nothing where the plane is seen edge-on.
std::optional<Vec2> planePoint(Vec2 pixel, const Frame& frame, const Camera& camera, ViewSize size);

class ContourTool {
 public:
  /// drags: a point of the outline, else draws. False where the part's plane is seen edge-on, and
  /// where there is no point to drag.
  bool begin(Vec2 pixel, const PlacedPart& placed, const EvaluatedPart& evaluated,
             const Camera& camera, ViewSize size, bool drags, bool touch);
  void move(Vec2 pixel);
  void end() { active_ = false; }

  bool active() const { return active_; }
  /// A point is dragged, nothing is drawn.
  bool drags() const { return drags_; }
  /// What was drawn so far; world.
  std::vector<Vec3> ink() const;
  /// The document's change so far; nothing where what was drawn does not meet the outline.
  std::optional<SetStroke> command() const;

 private:
  bool active_ = false, drags_ = false;
  std::string id_;
  Frame frame_;
  Camera camera_;
  ViewSize size_;
  std::vector<Vec2> outline_;  // as it was
  double perimeter_ = 0, reach_ = 0;
  std::vector<Vec2> points_;  // in the part's plane: drawn, or the first and last of a drag
};

}  // namespace marrow
