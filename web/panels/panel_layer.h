// Dear ImGui around the panels: input in, draw lists out. Knows no OpenGL and no platform.
#pragma once

#include "input.h"
#include "panels/panel.h"

namespace marrow {

class PanelLayer {
 public:
  PanelLayer();
  ~PanelLayer();
  PanelLayer(const PanelLayer&) = delete;
  PanelLayer& operator=(const PanelLayer&) = delete;

  /// Makes the fonts sharp at this density.
  void setDensity(double dpr);
  /// Changes when the font atlas does.
  int fontsVersion() const { return fonts_version_; }

  /// Whether a panel lies under this pixel, as of the last frame.
  bool panelAt(Vec2 pixel) const;
  void pointer(const PointerEvent& event);
  void wheel(const WheelEvent& event);
  void key(const KeyEvent& event);
  void text(const TextEvent& event);
  /// A text field has the keyboard.
  bool wantsText() const;

  /// Draws all panels into ImGui's draw lists.
  Requests frame(const PanelInput& input, UiState& ui);
  /// Of what is to be drawn.
  uint64_t fingerprint() const;

 private:
  int fonts_version_ = 0;
  double dpr_ = 0;
  double last_frame_ms_ = 0;
  PanelsOpen last_open_;
  bool touch_lifted_ = false;  // no pointer hovers after a finger is gone
  bool keys_down_ = false;
};

}  // namespace marrow
