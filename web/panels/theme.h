// Colours, fonts and measures of all panels.
#pragma once

#include "imgui.h"
#include "ui_state.h"

namespace marrow {

struct Theme {
  static constexpr ImU32 kPanel = IM_COL32(255, 255, 255, 255);
  static constexpr ImU32 kHairline = IM_COL32(40, 44, 60, 26);
  static constexpr ImU32 kText = IM_COL32(41, 46, 60, 255);
  static constexpr ImU32 kSoftText = IM_COL32(96, 102, 118, 255);
  static constexpr ImU32 kDisabled = IM_COL32(41, 46, 60, 84);
  static constexpr ImU32 kHover = IM_COL32(41, 46, 60, 18);
  static constexpr ImU32 kPress = IM_COL32(41, 46, 60, 34);
  static constexpr ImU32 kAccent = IM_COL32(37, 99, 174, 255);
  static constexpr ImU32 kAccentSoft = IM_COL32(37, 99, 174, 34);
  static constexpr ImU32 kTrack = IM_COL32(41, 46, 60, 36);
  static constexpr ImU32 kDanger = IM_COL32(178, 50, 40, 255);
  static constexpr ImU32 kTooltip = IM_COL32(41, 46, 60, 244);
  static constexpr ImU32 kTooltipText = IM_COL32(255, 255, 255, 255);
  static constexpr float kRounding = 12;
  static constexpr float kMargin = 12;  // between panels and the canvas's edge
};

/// Sizes in CSS pixels.
struct Fonts {
  ImFont* regular = nullptr;  // 15
  ImFont* bold = nullptr;     // 15
  ImFont* title = nullptr;    // 20, semi-bold
  ImFont* icons = nullptr;    // 20
};
const Fonts& fonts();

/// Makes the fonts again, sharp at this density, and forgets the old atlas.
void buildFonts(double dpr);
void applyTheme();

/// Side of a button: larger for fingers.
inline float buttonSide(const UiState& ui) { return ui.touch() ? 44.0f : 38.0f; }

}  // namespace marrow
