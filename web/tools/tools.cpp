#include "tools/tools.h"

#include <algorithm>

namespace marrow {
namespace {

// A stroke younger or shorter than this gives way to a second finger.
constexpr double kStrokeIsYoung_ms = 250;
constexpr double kStrokeIsShort_px = 40;
// A hand rests on the glass while its pen is a little above it.
constexpr double kPenIsNear_ms = 500;

}  // namespace

Tools::Outcome Tools::pointer(const PointerEvent& event, UiState& ui, const Surroundings& around) {
  if (event.kind == PointerKind::pen) last_pen_ms_ = event.time_ms;
  if (event.type != PointerEvent::Type::move) settle(ui, around.pivot);
  switch (event.type) {
    case PointerEvent::Type::down:
      return down(event, ui, around);
    case PointerEvent::Type::move:
      return move(event, ui, around);
    case PointerEvent::Type::up:
    case PointerEvent::Type::cancel:
      return up(event);
    case PointerEvent::Type::leave:
      break;
  }
  Outcome outcome;
  outcome.to_panels = true;
  return outcome;
}

void Tools::wheel(const WheelEvent& event, UiState& ui) {
  if (draw_.active()) return;
  ui.glide.stop();
  NavigateTool::wheel(event, ui.camera, ui.size);
}

bool Tools::cancelGesture() {
  const bool was_active = draw_.active();
  if (was_active) owners_[draw_.pointer()] = Owner::nobody;
  draw_.cancel();
  return was_active;
}

bool Tools::penIsNear(double time_ms) const { return time_ms - last_pen_ms_ < kPenIsNear_ms; }

bool Tools::hasJustBegun(double time_ms) const {
  return time_ms - draw_.started_ms() < kStrokeIsYoung_ms ||
         draw_.travelled_px() < kStrokeIsShort_px;
}

Tools::Owner Tools::ownerOfTouch(const PointerEvent& event) {
  if (penIsNear(event.time_ms)) return Owner::nobody;
  if (draw_.active()) {
    const bool gives_way = drawing_kind_ == PointerKind::touch && hasJustBegun(event.time_ms);
    return gives_way ? Owner::navigate : Owner::nobody;
  }
  return navigate_.active() ? Owner::navigate : Owner::draw;
}

Tools::Outcome Tools::down(const PointerEvent& event, UiState& ui, const Surroundings& around) {
  Outcome outcome;
  ui.last_pointer = event.kind;
  ui.pressed_ms = event.time_ms;
  const bool panel_is_held = std::any_of(owners_.begin(), owners_.end(), [](const auto& entry) {
    return entry.second == Owner::panel;
  });
  if (!draw_.active() && !navigate_.active() && around.panel_at(event.position_px)) {
    owners_[event.id] = panel_is_held ? Owner::nobody : Owner::panel;
    outcome.to_panels = !panel_is_held;
    return outcome;
  }
  outcome.to_panels = false;
  if (panel_is_held) {
    owners_[event.id] = Owner::nobody;
    return outcome;
  }
  Owner owner = Owner::draw;
  NavigateTool::Mode mode = NavigateTool::Mode::fingers;
  if (event.kind == PointerKind::touch) {
    owner = ownerOfTouch(event);
  } else if (event.button != Button::primary || event.alt) {
    owner = draw_.active() ? Owner::nobody : Owner::navigate;
    mode = event.button == Button::middle ? NavigateTool::Mode::pan : NavigateTool::Mode::orbit;
  } else if (draw_.active() && drawing_kind_ != event.kind) {
    cancelGesture();  // the hand came down before the pen
  } else if (draw_.active()) {
    owner = Owner::nobody;
  }
  if (owner == Owner::draw && !around.takes(event.position_px)) {
    owner = Owner::navigate;
    mode = NavigateTool::Mode::orbit;
  }
  owners_[event.id] = owner;
  if (owner == Owner::draw) {
    beginGesture(event, ui);
    outcome.gesture = Gesture::begin;
  }
  if (owner == Owner::navigate) {
    if (draw_.active()) {
      PointerEvent first = event;  // the finger that had begun to draw joins in from where it is
      first.id = draw_.pointer();
      first.position_px = draw_.last_px();
      draw_.cancel();
      outcome.gesture = Gesture::cancel;
      owners_[first.id] = Owner::navigate;
      navigate_.add(first, mode);
    }
    ui.glide.stop();
    navigate_.add(event, mode);
  }
  return outcome;
}

void Tools::beginGesture(const PointerEvent& event, UiState& ui) {
  for (auto& [pointer, owner] : owners_) {
    if (owner == Owner::navigate) owner = Owner::nobody;
  }
  navigate_.clear();
  if (ui.glide.running()) ui.camera = ui.glide.destination();
  ui.glide.stop();
  draw_.begin(event, ui.camera, ui.size);
  drawing_kind_ = event.kind;
}

Tools::Outcome Tools::move(const PointerEvent& event, UiState& ui, const Surroundings& around) {
  Outcome outcome;
  const auto found = owners_.find(event.id);
  if (found == owners_.end()) {  // hovering
    outcome.to_panels = true;
    return outcome;
  }
  switch (found->second) {
    case Owner::panel:
      outcome.to_panels = true;
      break;
    case Owner::draw:
      draw_.move(event);
      outcome.gesture = Gesture::move;
      break;
    case Owner::navigate:
      navigate_.move(event, ui.camera, around.pivot);
      break;
    case Owner::nobody:
      break;
  }
  return outcome;
}

Tools::Outcome Tools::up(const PointerEvent& event) {
  Outcome outcome;
  const auto found = owners_.find(event.id);
  if (found == owners_.end()) {
    outcome.to_panels = true;
    return outcome;
  }
  const Owner owner = found->second;
  owners_.erase(found);
  outcome.to_panels = owner == Owner::panel;
  // A finger left over from a gesture stays with the camera: it must not begin to draw.
  if (owner == Owner::navigate) navigate_.remove(event.id);
  if (owner != Owner::draw || !draw_.active()) return outcome;
  if (event.type == PointerEvent::Type::cancel) {
    draw_.cancel();
    outcome.gesture = Gesture::cancel;
  } else {
    outcome.gesture = draw_.isStroke() ? Gesture::end : Gesture::click;
    if (outcome.gesture == Gesture::click) draw_.cancel();
  }
  return outcome;
}

}  // namespace marrow
