// What the platform reports: pointers, wheel, keys and text, in CSS pixels from the canvas's
// top left corner, y down.
#pragma once

#include <cstdint>
#include <variant>

#include "base/vec.h"

namespace marrow {

enum class PointerKind : uint8_t { mouse, touch, pen };

enum class Button : uint8_t { primary, middle, secondary };

struct PointerEvent {
  enum class Type : uint8_t { down, move, up, cancel, leave };
  Type type = Type::move;
  PointerKind kind = PointerKind::mouse;
  int id = 0;
  Button button = Button::primary;  // of `down` and `up`
  Vec2 position_px;
  double pressure = 0.5;  // 0 … 1
  double time_ms = 0;
  bool alt = false, shift = false;  // held
};

struct WheelEvent {
  Vec2 position_px;
  double zoom = 0;  // natural logarithm of the zoom's factor
  Vec2 pan_px;      // what follows the fingers on a trackpad
};

enum class Key : uint8_t {
  none,
  undo,        // Ctrl Z
  redo,        // Shift Ctrl Z, Ctrl Y
  select_all,  // Ctrl A
  open,        // Ctrl O
  save,        // Ctrl S
  save_as,     // Shift Ctrl S
  escape,
  backspace,
  enter,
  left_arrow,
  right_arrow,
  home,
  end,
  delete_forward,
};

/// A key with a name, or one that writes a character of ASCII.
struct KeyEvent {
  Key key = Key::none;
  char character = 0;
};

struct TextEvent {
  char32_t character = 0;
};

using InputEvent = std::variant<PointerEvent, WheelEvent, KeyEvent, TextEvent>;

}  // namespace marrow
