// Who a pointer belongs to: a panel, the drawing tool or the camera.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "tools/draw_tool.h"
#include "tools/navigate_tool.h"
#include "ui_state.h"

namespace marrow {

/// What the tools need to know of the rest.
struct Surroundings {
  std::function<bool(Vec2)> panel_at;  // is there a panel under this pixel?
  Vec3 pivot;                          // what the view turns about
};

/// A pointer belongs to whom it went down on until it goes up.
///
/// Primary button, one finger, pen: draw; without moving: a click. Secondary button or Alt and
/// drag: turn; middle: pan; two fingers: see NavigateTool. A second finger cancels a stroke that
/// has just begun and is ignored by one that is under way; touches are ignored while a pen draws.
class Tools {
 public:
  struct Outcome {
    bool to_panels = false;          // the panels are to have this event
    bool turns_to_front = false;     // a stroke began in another view
    std::optional<Command> command;  // a stroke is finished
    std::optional<Vec2> click_px;    // a click on the canvas
  };
  Outcome pointer(const PointerEvent& event, UiState& ui, const Surroundings& around);
  void wheel(const WheelEvent& event, UiState& ui);
  /// To be called when a frame's input has been given.
  void settle(UiState& ui, Vec3 pivot) { navigate_.settle(ui.camera, ui.size, pivot); }

  /// Gives up a stroke under way; whether there was one.
  bool cancelStroke();
  const DrawTool& drawing() const { return draw_; }
  bool navigating() const { return navigate_.active(); }

 private:
  enum class Owner : uint8_t { panel, draw, navigate, nobody };

  Outcome down(const PointerEvent& event, UiState& ui, const Surroundings& around);
  Outcome move(const PointerEvent& event, UiState& ui, const Surroundings& around);
  Outcome up(const PointerEvent& event, UiState& ui, const Surroundings& around);
  Owner ownerOfTouch(const PointerEvent& event);
  void beginStroke(const PointerEvent& event, UiState& ui, const Surroundings& around);
  bool penIsNear(double time_ms) const;
  /// Young or short enough to be the first finger of a gesture.
  bool hasJustBegun(double time_ms) const;
  /// Turns the view to where the stroke is drawn, once; whether it was another one.
  bool showDrawingView(UiState& ui, Vec3 pivot);

  DrawTool draw_;
  NavigateTool navigate_;
  std::map<int, Owner> owners_;
  Camera camera_at_start_;      // where the view was when the stroke began
  bool view_is_shown_ = false;  // the view has turned to where the stroke is drawn
  PointerKind drawing_kind_ = PointerKind::mouse;
  double last_pen_ms_ = -1e9;
};

}  // namespace marrow
