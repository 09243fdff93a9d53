// What the app shows and how: never part of the document, never undone.
#pragma once

#include <optional>
#include <string>

#include "camera.h"
#include "document/command.h"
#include "input.h"

namespace marrow {

struct ViewSwitches {
  bool mesh = true;
  bool wireframe = false;
  bool bones = true;
  bool straight_skeleton = false;
  bool proxy = false;
};

/// One calm sentence at the bottom of the canvas, gone after a while.
struct Toast {
  std::string text;
  double shown_ms = 0;  // when it appeared
};

/// One open sheet at a time where the canvas is narrow.
struct PanelsOpen {
  bool part = true;  // shown while a part is selected
  bool view = false;
  bool performance = false;
  bool help = false;
};

/// A setting under the user's hand: shown, but not in the document until the hand lets go.
struct PendingEdit {
  Command command;
};

struct UiState {
  ViewSize size;
  double dpr = 1;  // device pixels per CSS pixel
  double now_ms = 0;

  Camera camera;
  CameraGlide glide;

  ViewSwitches show;
  PanelsOpen open;
  std::string selected;  // id of a part; one that is gone means nothing is selected
  std::optional<PendingEdit> edit;
  std::optional<Toast> toast;
  double hint_since_ms = -1;  // when the invitation appeared; −1: not yet
  PointerKind last_pointer = PointerKind::mouse;

  /// Phones: panels become bars and sheets.
  bool narrow() const { return size.width < 700; }
  /// Fingers need larger targets than a mouse.
  bool touch() const { return narrow() || last_pointer == PointerKind::touch; }
};

}  // namespace marrow
