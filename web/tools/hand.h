// What the tool in hand does with a gesture: draws, selects, moves, changes an outline, sets the
// line of symmetry. Turns gestures into commands; while one is under way its effect is shown as
// UiState::edit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/brush_tool.h"
#include "tools/contour_tool.h"
#include "tools/draw_tool.h"
#include "tools/gizmo.h"
#include "tools/pose_tool.h"
#include "tools/stroke_place.h"
#include "tools/transform_tool.h"
#include "ui_state.h"

namespace marrow {

class Hand {
 public:
  enum class Mode : uint8_t { idle, stroke, box, transform, contour, line, pose, brush };

  /// What it needs to know of the rest.
  struct World {
    const Document& document;
    const Evaluation& evaluation;
    Vec3 ground;  // the middle of what the model stands on
    // While poses are made:
    const Stance& stance;
    std::shared_ptr<const Figure> figure = {};
  };

  void begin(const DrawTool& gesture, bool shift, UiState& ui, const World& world);
  void move(const DrawTool& gesture, UiState& ui, const World& world);
  /// The gesture was a drag. What is to be done, if anything.
  std::optional<Command> end(const DrawTool& gesture, UiState& ui, const World& world);
  void cancel(UiState& ui);

  /// G, R and S: the selection follows the pointer until a click. False where nothing that can be
  /// changed is selected.
  bool beginByKey(TransformKind kind, Vec2 pointer_px, UiState& ui, const World& world);
  /// The pointer moves without a button.
  void follow(Vec2 pointer_px, UiState& ui);
  /// A character typed meanwhile; whether it was for the hand.
  bool key(char character, UiState& ui);
  std::optional<Command> finishByKey(UiState& ui);

  Mode mode() const { return mode_; }
  bool followsKey() const {
    return (mode_ == Mode::transform && transform_.byKey()) || posing().byKey();
  }
  const TransformTool& transform() const { return transform_; }
  const ContourTool& contour() const { return contour_; }
  const PoseTool& posing() const { return pose_; }
  const StrokePlace& place() const { return place_; }
  /// Corners of the box, or ends of the line, CSS pixels.
  Vec2 from_px() const { return from_px_; }
  Vec2 to_px() const { return to_px_; }

 private:
  void showTransform(UiState& ui);
  void showPose(UiState& ui);
  Command poseCommand(const UiState& ui) const;
  void beginPose(const UiState& ui, const World& world);
  bool beginBrush(const UiState& ui, const World& world);

  Mode mode_ = Mode::idle;
  bool shift_ = false;
  Vec2 from_px_, to_px_;
  std::string pressed_;  // id of the placed part under a press that has not moved yet
  StrokePlace place_;
  TransformTool transform_;
  ContourTool contour_;
  PoseTool pose_;
  std::string fresh_pose_;   // name of the pose that a first move begins; may be empty
  std::string pose_before_;  // what was shown then
  double amount_before_ = 0;
  BrushTool brush_;
};

/// Ids of the selected parts that can be changed on the canvas.
std::vector<std::string> changeable(const Selection& selection, const Evaluation& evaluation);
/// Middle of what is selected; nothing where nothing is.
std::optional<Vec3> selectionPivot(const Selection& selection, const Evaluation& evaluation);
/// The plane of symmetry that stands upright on the screen over a line, straightened where it is
/// nearly level or upright. Nothing for a line shorter than a few pixels.
std::optional<Plane> planeOverLine(Vec2 a_px, Vec2 b_px, const Camera& camera, ViewSize size);

}  // namespace marrow
