#include "panels/menu_rows.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr ImU32 kEmpty = IM_COL32(41, 46, 60, 12);

ImDrawList& list() { return *ImGui::GetWindowDrawList(); }

bool pressedRow(const char* id, ImVec2 size, bool enabled) {
  const bool clicked = ImGui::InvisibleButton(id, size) && enabled;
  notePlace(id);
  if (enabled && (ImGui::IsItemActive() || ImGui::IsItemHovered())) {
    list().AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                         ImGui::IsItemActive() ? Theme::kPress : Theme::kHover, 9);
  }
  return clicked;
}

void textAt(ImFont* font, const char* text, float x, float y, ImU32 color) {
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  list().AddText(font, size, {std::round(x), std::round(y - size / 2)}, color, text);
}

float widthOf(ImFont* font, const char* text) {
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  return font->CalcTextSizeA(size, FLT_MAX, 0, text).x;
}

}  // namespace

PanelBox menuBox(const UiState& ui, float width) {
  if (!ui.narrow()) return leftColumnBox(ui, width);
  PanelBox box = sheetBox(ui);
  if (!lowCanvas(ui)) box.max_height = canvasHeight(ui) * 0.7f;
  return box;
}

bool menuRow(const char* id, const char* icon, const char* text, const char* keys, float height,
             bool enabled) {
  const bool clicked = pressedRow(id, {ImGui::GetContentRegionAvail().x, height}, enabled);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float y = (low.y + high.y) / 2;
  const ImU32 color = enabled ? Theme::kText : Theme::kDisabled;
  textAt(fonts().icons, icon, low.x + 18 - widthOf(fonts().icons, icon) / 2, y, color);
  textAt(fonts().regular, text, low.x + 42, y, color);
  if (*keys) {
    textAt(fonts().regular, keys, high.x - 10 - widthOf(fonts().regular, keys), y,
           enabled ? Theme::kSoftText : Theme::kDisabled);
  }
  return clicked;
}

void thumbnailAt(const Thumbnail* thumbnail, ImVec2 low, ImVec2 high, float rounding) {
  if (!thumbnail || !thumbnail->ready) {
    list().AddRectFilled(low, high, kEmpty, rounding);
    return;
  }
  // Cut to the place's shape, not squeezed.
  const double shape = (high.x - low.x) / std::max(high.y - low.y, 1.0f);
  const double own = Thumbnail::kSize.width / Thumbnail::kSize.height;
  const auto cut_x = static_cast<float>(std::max(0.0, (1 - shape / own) / 2));
  const auto cut_y = static_cast<float>(std::max(0.0, (1 - own / shape) / 2));
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(thumbnail->texture));
  // A texture's rows begin at the bottom.
  list().AddImageRounded(texture, low, high, {cut_x, 1 - cut_y}, {1 - cut_x, cut_y}, IM_COL32_WHITE,
                         rounding);
  list().AddRect(low, high, Theme::kHairline, rounding);
}

bool thumbnailCard(const char* id, const Thumbnail* thumbnail, const char* name, float width) {
  const float picture = std::round((width - 8) * 0.75f), label = 30;
  const bool clicked = pressedRow(id, {width, picture + label + 4}, true);
  const ImVec2 low = ImGui::GetItemRectMin();
  thumbnailAt(thumbnail, {low.x + 4, low.y + 4}, {low.x + width - 4, low.y + 4 + picture}, 8);
  const std::string shown = shortened(name, width - 12);
  textAt(fonts().regular, shown.c_str(),
         low.x + (width - widthOf(fonts().regular, shown.c_str())) / 2,
         low.y + 4 + picture + label / 2, Theme::kText);
  return clicked;
}

bool thumbnailRow(const char* id, const Thumbnail* thumbnail, const char* name, const char* words,
                  float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool clicked = pressedRow(id, {width, height}, true);
  const ImVec2 low = ImGui::GetItemRectMin();
  const float side = height - 8, left = std::round(side * 4 / 3) + 16;
  thumbnailAt(thumbnail, {low.x + 4, low.y + 4}, {low.x + left - 12, low.y + 4 + side}, 6);
  textAt(fonts().regular, shortened(name, width - left - 8).c_str(), low.x + left,
         low.y + height / 2 - 10, Theme::kText);
  textAt(fonts().regular, shortened(words, width - left - 8).c_str(), low.x + left,
         low.y + height / 2 + 10, Theme::kSoftText);
  return clicked;
}

bool paleButton(const char* id, const char* text, float width, float height, const char* tooltip,
                bool danger) {
  ButtonLook look{tooltip};
  look.width = width;
  look.raised = true;
  look.danger = danger;
  return textButton(id, text, height, look);
}

bool accentButton(const char* id, const char* text, float width, float height) {
  const bool clicked = ImGui::InvisibleButton(id, {width, height});
  notePlace(id);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  list().AddRectFilled(low, high, Theme::kAccent, 9);
  if (ImGui::IsItemActive()) list().AddRectFilled(low, high, Theme::kPress, 9);
  textAt(fonts().regular, text, (low.x + high.x - widthOf(fonts().regular, text)) / 2,
         (low.y + high.y) / 2, IM_COL32_WHITE);
  return clicked;
}

std::string shortened(const std::string& text, float width) {
  if (widthOf(fonts().regular, text.c_str()) <= width) return text;
  std::string cut = text;
  while (!cut.empty()) {
    do {
      cut.pop_back();
    } while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80);
    const std::string shown = cut + "\xE2\x80\xA6";
    if (widthOf(fonts().regular, shown.c_str()) <= width) return shown;
  }
  return "\xE2\x80\xA6";
}

}  // namespace marrow
