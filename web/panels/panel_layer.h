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

  /// Takes the keyboard away from a text field, which then tells what was typed.
  void letGoOfText();

  /// Draws all panels into ImGui's draw lists.
  Requests frame(const PanelInput& input, UiState& ui);
  /// What the panels of the last frame take of the canvas. by_model_sheets: only what lies
  /// there for a while and is about the model, which is to be seen beside it.
  Insets covered(const UiState& ui, bool by_model_sheets) const;
  /// Of what is to be drawn.
  uint64_t fingerprint() const;

 private:
  bool keepOneAtLeft(PanelsOpen& open);  // whether one had to go

  int fonts_version_ = 0;
  double dpr_ = 0;
  double last_frame_ms_ = 0;
  PanelsOpen last_open_;
  bool touch_lifted_ = false;   // no pointer hovers after a finger is gone
  int frames_met_ = 0;          // in which that reached as far as a panel at the left
  bool left_is_newer_ = false;  // than what the last stroke took
  bool keys_down_ = false;
};

}  // namespace marrow
