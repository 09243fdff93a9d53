// Who a pointer belongs to: a panel, the tool in hand or the camera.
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
  /// Whether the tool takes hold of something there; else the view turns.
  std::function<bool(Vec2)> takes;
};

/// A pointer belongs to whom it went down on until it goes up.
///
/// Primary button, one finger, pen: the tool in hand; without moving: a click. Secondary button or
/// Alt and drag: turn; middle: pan; two fingers: see NavigateTool. A second finger cancels what has
/// just begun and is ignored by what is under way; touches are ignored while a pen draws.
class Tools {
 public:
  /// What the tool in hand is told. Between begin and end, click or cancel comes any number of
  /// moves.
  enum class Gesture : uint8_t { none, begin, move, end, click, cancel };
  struct Outcome {
    bool to_panels = false;  // the panels are to have this event
    Gesture gesture = Gesture::none;
  };
  Outcome pointer(const PointerEvent& event, UiState& ui, const Surroundings& around);
  void wheel(const WheelEvent& event, UiState& ui);
  /// To be called when a frame's input has been given.
  void settle(UiState& ui, Vec3 pivot) { navigate_.settle(ui.camera, ui.size, pivot); }

  /// Gives up what the hand is doing; whether it was doing anything.
  bool cancelGesture();
  /// Takes the gesture's points away: it ends.
  std::vector<Vec2> takePoints() { return draw_.end(); }
  /// The way of the pointer that holds the tool.
  const DrawTool& drawing() const { return draw_; }
  bool navigating() const { return navigate_.active(); }

 private:
  enum class Owner : uint8_t { panel, draw, navigate, nobody };

  Outcome down(const PointerEvent& event, UiState& ui, const Surroundings& around);
  Outcome move(const PointerEvent& event, UiState& ui, const Surroundings& around);
  Outcome up(const PointerEvent& event);
  Owner ownerOfTouch(const PointerEvent& event);
  void beginGesture(const PointerEvent& event, UiState& ui);
  bool penIsNear(double time_ms) const;
  /// Young or short enough to be the first finger of two.
  bool hasJustBegun(double time_ms) const;

  DrawTool draw_;
  NavigateTool navigate_;
  std::map<int, Owner> owners_;
  PointerKind drawing_kind_ = PointerKind::mouse;
  double last_pen_ms_ = -1e9;
};

}  // namespace marrow
