#include "panels/layout.h"

#include "icons.h"

namespace marrow {

bool titleRow(const char* title, const UiState& ui) {
  const float side = ui.touch() ? 44.0f : 32.0f;
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::PushFont(fonts().title);
  ImGui::SetCursorPosY(at.y + (side - ImGui::GetFontSize()) / 2);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::SetCursorPos({at.x + width - side + 6, at.y});
  const bool closed = iconButton("close", kIconX, side, {"Close  (Esc)"});
  ImGui::SetCursorPos({at.x, at.y + side + 4});
  return closed;
}

}  // namespace marrow
