#include "panels/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "icons.h"
#include "imgui_internal.h"

namespace marrow {
namespace {

constexpr float kTooltipDelay_s = 0.45f;
constexpr float kTooltipWidth = 260;

std::vector<WidgetPlace> places;  // belongs to the one ImGui context, as ImGui's own state does

ImDrawList& list() { return *ImGui::GetWindowDrawList(); }

ImVec2 middle(ImVec2 low, ImVec2 high) { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }

// What is being typed, until the user is done with it. ImGui forgets it where its field is not made
// any more, and where another widget takes the keyboard before the field's turn.
struct Typing {
  std::string panel, id, owner, before;
  std::array<char, 512> text{};
  ImGuiID item = 0;
  int frame = 0;  // the last one that had the field
};
std::vector<Typing> typing;  // belongs to the one ImGui context, as ImGui's own state does

// A shadow made of a few soft rims.
void drawShadow(ImVec2 low, ImVec2 high) {
  ImDrawList& back = *ImGui::GetBackgroundDrawList();
  for (int i = 6; i >= 1; --i) {
    const auto grow = static_cast<float>(i) * 2;
    back.AddRectFilled({low.x - grow, low.y - grow + 3}, {high.x + grow, high.y + grow + 3},
                       IM_COL32(40, 36, 60, 4), Theme::kRounding + grow);
  }
}

void drawCentred(ImFont* font, const char* text, ImVec2 at, ImU32 color) {
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text);
  list().AddText(font, size, {std::round(at.x - extent.x / 2), std::round(at.y - extent.y / 2)},
                 color, text);
}

ImU32 background(const ButtonLook& look) {
  if (ImGui::IsItemActive()) return Theme::kPress;
  if (look.on) return Theme::kAccentSoft;
  if (ImGui::IsItemHovered()) return look.raised ? Theme::kPress : Theme::kHover;
  return look.raised ? Theme::kHover : 0;
}

// What a press that began on a panel turns out to be: fingers that scroll must not move a slider
// or press a button on the way.
enum class Press { undecided, scroll, other };
constexpr float kDecided_px = 7;
Press press = Press::other;  // belongs to the one ImGui context, as ImGui's own state does
bool fingers = false;        // the panel that is being made is for fingers

void scrollByFinger(bool touch) {
  fingers = touch;
  const ImGuiIO& io = ImGui::GetIO();
  if (!touch) return;
  if (io.MouseClicked[0]) press = Press::undecided;
  if (!io.MouseDown[0]) return;
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  const ImVec2 start = io.MouseClickedPos[0];
  if (!window.InnerRect.Contains(start) || window.ScrollMax.y <= 0) return;
  const ImVec2 way{io.MousePos.x - start.x, io.MousePos.y - start.y};
  if (press == Press::undecided && std::max(std::abs(way.x), std::abs(way.y)) > kDecided_px) {
    press = std::abs(way.y) > std::abs(way.x) ? Press::scroll : Press::other;
    if (press == Press::scroll) ImGui::ClearActiveID();
  }
  if (press == Press::scroll) ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

// Whether a finger that holds a slider may still mean to scroll.
bool mayScroll() {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  const bool scrolls = window.ScrollMax.y > 0;
  return fingers && scrolls && press == Press::undecided;
}

// The clickable area of a button; false where it is disabled.
bool pressed(const char* id, ImVec2 size, const ButtonLook& look) {
  const bool clicked = ImGui::InvisibleButton(id, size) && look.enabled;
  notePlace(id);
  if (look.enabled) {
    list().AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), background(look), 9);
  }
  tooltipForLastItem(look.tooltip);
  return clicked;
}

ImU32 foreground(const ButtonLook& look) {
  if (!look.enabled) return Theme::kDisabled;
  if (look.danger) return Theme::kDanger;
  if (look.quiet && !ImGui::IsItemHovered()) return Theme::kDisabled;
  return look.on ? Theme::kAccent : Theme::kText;
}

}  // namespace

void beginPanel(const char* name, const PanelBox& box) {
  ImGui::SetNextWindowPos(box.position, ImGuiCond_Always, box.anchor);
  const float limit = box.max_height > 0 ? box.max_height : FLT_MAX;
  if (box.width > 0) {
    ImGui::SetNextWindowSizeConstraints({box.width, 0}, {box.width, limit});
  } else {
    ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, limit});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, box.bar ? ImVec2(5, 5) : ImVec2(16, 14));
  if (box.bar) ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 2));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, box.touch ? 4.0f : 10.0f);
  ImGui::Begin(name, nullptr, box.drawn_through ? kFlags | ImGuiWindowFlags_NoMouseInputs : kFlags);
  ImGui::PopStyleVar();
  // ImGui puts new windows of this kind behind the others: a sheet would lie below the tools.
  if (!box.bar) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (!ImGui::GetCurrentWindow()->Hidden) drawShadow(low, {low.x + size.x, low.y + size.y});
  ImGui::PopStyleVar(box.bar ? 2 : 1);
  if (box.bar) ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 2));
  if (!box.bar) ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 8));
  scrollByFinger(box.touch);
}

void endPanel() {
  ImGui::PopStyleVar();
  ImGui::End();
}

std::optional<PanelSpan> panelSpan(const char* name) {
  const ImGuiWindow* window = ImGui::FindWindowByName(name);
  if (!window || !window->WasActive || window->Hidden) return std::nullopt;
  const ImVec2 low = window->Pos, size = window->Size;
  return PanelSpan{low.x, low.y, low.x + size.x, low.y + size.y};
}

void beginScrolling(const char* name, float height, bool touch) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild(name, {0, height}, false, ImGuiWindowFlags_NoNav);
  scrollByFinger(touch);
}

void endScrolling() {
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

bool iconButton(const char* id, const char* icon, float side, const ButtonLook& look) {
  const bool clicked = pressed(id, {look.width > 0 ? look.width : side, side}, look);
  drawCentred(fonts().icons, icon, middle(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()),
              foreground(look));
  return clicked;
}

bool textButton(const char* id, const char* text, float height, const ButtonLook& look) {
  const float width = look.width > 0 ? look.width : ImGui::CalcTextSize(text).x + 20;
  const bool clicked = pressed(id, {width, height}, look);
  drawCentred(fonts().regular, text, middle(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()),
              foreground(look));
  return clicked;
}

bool switchRow(const char* id, const char* icon, const char* text, bool on, float height) {
  const bool clicked = pressed(id, {ImGui::GetContentRegionAvail().x, height}, {});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float y = (low.y + high.y) / 2;
  drawCentred(fonts().icons, icon, {low.x + 12, y}, on ? Theme::kAccent : Theme::kText);
  const float size = ImGui::GetFontSize();
  list().AddText({low.x + 34, std::round(y - size / 2)}, Theme::kText, text);
  const ImVec2 knob{high.x - 14, y};
  list().AddRectFilled({knob.x - 26, y - 10}, {knob.x + 10, y + 10},
                       on ? Theme::kAccent : IM_COL32(41, 46, 60, 70), 10);
  list().AddCircleFilled({on ? knob.x : knob.x - 16, y}, 7.5f, IM_COL32_WHITE, 24);
  return clicked;
}

bool disclosure(const char* id, const char* icon, const char* text, const char* note, bool open,
                float height) {
  const bool clicked = pressed(id, {ImGui::GetContentRegionAvail().x, height}, {});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float y = (low.y + high.y) / 2, text_y = std::round(y - ImGui::GetFontSize() / 2);
  drawCentred(fonts().icons, icon, {low.x + 12, y}, Theme::kText);
  const float note_width = *note ? ImGui::CalcTextSize(note).x + 8 : 0;
  const float end = high.x - 26;
  if (*note) list().AddText({end - note_width + 4, text_y}, Theme::kSoftText, note);
  fittingText(text, {low.x + 34, text_y}, end - note_width - low.x - 34, Theme::kText);
  drawCentred(fonts().icons, open ? kIconChevronDown : kIconChevronRight, {high.x - 11, y},
              Theme::kSoftText);
  return clicked;
}

size_t choices(const std::vector<Choice>& all, size_t current, float height) {
  float wanted = 0;
  for (const Choice& one : all) wanted += ImGui::CalcTextSize(one.label).x;
  const float width = ImGui::GetContentRegionAvail().x;
  const float room = (width - wanted) / static_cast<float>(all.size());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  list().AddRectFilled(at, {at.x + width, at.y + height}, Theme::kHover, 9);
  size_t chosen = current;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 8));
  for (size_t i = 0; i < all.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    ButtonLook look;
    look.on = i == current;
    look.width = ImGui::CalcTextSize(all[i].label).x + room;
    if (textButton(all[i].id, all[i].label, height, look)) chosen = i;
  }
  ImGui::PopStyleVar();
  return chosen;
}

SliderEvent slider(const char* id, float& value, float mark, float height, float width) {
  SliderEvent event;
  if (width <= 0) width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton(id, {width, height});
  notePlace(id);
  const ImVec2 low = ImGui::GetItemRectMin();
  const float radius = 10;
  const float from = low.x + radius, to = low.x + width - radius, y = low.y + height / 2;
  event.reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
  if (event.reset) ImGui::ClearActiveID();
  const bool tapped = ImGui::IsItemDeactivated() && mayScroll();
  if (tapped) press = Press::other;
  if ((ImGui::IsItemActive() && !mayScroll()) || tapped) {
    float wanted = std::clamp((ImGui::GetIO().MousePos.x - from) / (to - from), 0.0f, 1.0f);
    if (std::abs(wanted - mark) * (to - from) < 4) wanted = mark;
    event.changed = wanted != value;
    value = wanted;
  }
  event.released = ImGui::IsItemDeactivated();
  const float x = from + (to - from) * value;
  const float mark_x = from + (to - from) * mark;
  list().AddRectFilled({from - 2, y - 2}, {to + 2, y + 2}, Theme::kTrack, 2);
  list().AddRectFilled({std::min(x, mark_x), y - 2}, {std::max(x, mark_x), y + 2}, Theme::kAccent,
                       2);
  list().AddCircleFilled({mark_x, y}, 3.5f, Theme::kSoftText, 16);
  list().AddCircleFilled({x, y + 1}, radius, IM_COL32(40, 36, 60, 40), 32);
  list().AddCircleFilled({x, y}, radius - 1, IM_COL32_WHITE, 32);
  list().AddCircle(
      {x, y}, radius - 1,
      ImGui::IsItemHovered() || ImGui::IsItemActive() ? Theme::kAccent : Theme::kSoftText, 32,
      1.5f);
  return event;
}

std::optional<std::string> textField(const char* id, const std::string& owner,
                                     const std::string& text, const char* hint, float width) {
  const std::string panel = ImGui::GetCurrentWindow()->RootWindow->Name;
  const auto own = std::find_if(typing.begin(), typing.end(), [&](const Typing& one) {
    return one.panel == panel && one.id == id && one.owner == owner;
  });
  const bool was_typing = own != typing.end();
  Typing now;
  if (was_typing) {
    now = std::move(*own);
    typing.erase(own);
  } else {
    now.panel = panel;
    now.id = id;
    now.owner = owner;
    text.copy(now.text.data(), now.text.size() - 1);
    now.before = now.text.data();
  }
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const bool cut = !was_typing && ImGui::CalcTextSize(now.text.data()).x > width - 2 * padding.x;
  ImGui::SetNextItemWidth(width);
  ImGui::PushID(owner.c_str());
  if (cut) ImGui::PushStyleColor(ImGuiCol_Text, 0);
  ImGui::InputTextWithHint(
      (std::string("##") + id).c_str(), hint, now.text.data(), now.text.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (cut) ImGui::PopStyleColor();
  ImGui::PopID();
  notePlace(id);
  if (cut && !ImGui::IsItemActive()) {
    const ImVec2 low = ImGui::GetItemRectMin();
    fittingText(now.text.data(), {low.x + padding.x, low.y + padding.y}, width - 2 * padding.x,
                Theme::kText);
  }
  if (ImGui::IsItemActive()) {
    now.item = ImGui::GetItemID();
    now.frame = ImGui::GetFrameCount();
    typing.push_back(std::move(now));
    return std::nullopt;
  }
  if (!was_typing || now.before == now.text.data()) return std::nullopt;
  return now.text.data();
}

std::optional<TypedText> leftText(const char* panel) {
  const auto left = std::find_if(typing.begin(), typing.end(), [&](const Typing& one) {
    return one.panel == panel && one.frame != ImGui::GetFrameCount();
  });
  if (left == typing.end()) return std::nullopt;
  const Typing gone = std::move(*left);
  typing.erase(left);
  if (ImGui::GetActiveID() == gone.item) ImGui::ClearActiveID();
  if (gone.before == gone.text.data()) return std::nullopt;
  return TypedText{gone.owner, gone.text.data()};
}

bool swatch(const char* id, Color color, bool chosen, float side) {
  const bool clicked = ImGui::InvisibleButton(id, {side, side});
  notePlace(id);
  const ImVec2 at = middle(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  const float radius = side / 2 - 6;
  list().AddCircleFilled(at, radius, IM_COL32(color.r, color.g, color.b, 255), 32);
  list().AddCircle(at, radius, IM_COL32(41, 46, 60, 60), 32, 1);
  if (chosen) list().AddCircle(at, radius + 3.5f, Theme::kAccent, 32, 2);
  if (ImGui::IsItemHovered() && !chosen) list().AddCircle(at, radius + 3.5f, Theme::kTrack, 32, 2);
  return clicked;
}

void iconAt(const char* icon, ImVec2 at, ImU32 color) {
  drawCentred(fonts().icons, icon, at, color);
}

void fittingText(const char* text, ImVec2 at, float width, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  const ImVec2 end{at.x + width, at.y + ImGui::GetFontSize() + 4};
  ImGui::RenderTextEllipsis(&list(), at, end, end.x, end.x, text, nullptr, nullptr);
  ImGui::PopStyleColor();
}

void heading(const char* text) {
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void headingWithNote(const char* text, const char* note) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
  heading(text);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(note).x);
  softText(note);
  ImGui::PopStyleVar();
}

void softText(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, Theme::kSoftText);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

const std::vector<WidgetPlace>& widgetPlaces() { return places; }

void notePlace(const char* id) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  if (window.Hidden) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (!window.InnerClipRect.Contains(middle(low, high))) return;  // scrolled away
  places.push_back({window.RootWindow->Name, id, low, high});
}

void forgetPlaces() { places.clear(); }

void tooltipForLastItem(const char* text) {
  if (!*text || !ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
  if (GImGui->HoveredIdTimer < kTooltipDelay_s) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 padding{10, 7};
  const ImVec2 extent = ImGui::CalcTextSize(text, nullptr, false, kTooltipWidth);
  const ImVec2 size{extent.x + 2 * padding.x, extent.y + 2 * padding.y};
  const bool above = high.y + size.y + 10 > screen.y;
  const float x =
      std::clamp((low.x + high.x - size.x) / 2, 6.0f, std::max(6.0f, screen.x - size.x - 6));
  const ImVec2 at{std::round(x), std::round(above ? low.y - size.y - 8 : high.y + 8)};
  ImDrawList& front = *ImGui::GetForegroundDrawList();
  front.AddRectFilled(at, {at.x + size.x, at.y + size.y}, Theme::kTooltip, 8);
  front.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + padding.x, at.y + padding.y},
                Theme::kTooltipText, text, nullptr, kTooltipWidth);
}

bool tooltipIsDue() {
  return GImGui->HoveredId != 0 && GImGui->HoveredIdTimer < kTooltipDelay_s + 0.05f;
}

}  // namespace marrow
