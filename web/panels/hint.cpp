// The invitation on an empty canvas, and short messages.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/box.h"
#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {
namespace {

constexpr float kButtonBelow = 64;  // the invitation's first line
constexpr double kDrawn_ms = 1600;  // the example stroke draws itself once
constexpr double kToastStays_ms = 4200, kToastFades_ms = 300;

// A friendly blob with ears and legs, as a closed smooth curve through these points.
const std::array<ImVec2, 16> kExample{{{-0.95f, 0.10f},
                                       {-0.80f, 0.42f},
                                       {-0.74f, 0.92f},
                                       {-0.48f, 0.60f},
                                       {-0.10f, 0.54f},
                                       {0.36f, 0.56f},
                                       {0.58f, 0.66f},
                                       {0.95f, 0.95f},
                                       {0.84f, 0.40f},
                                       {0.86f, -0.10f},
                                       {0.74f, -0.62f},
                                       {0.48f, -0.66f},
                                       {0.36f, -0.24f},
                                       {-0.20f, -0.24f},
                                       {-0.38f, -0.66f},
                                       {-0.72f, -0.58f}}};

ImVec2 exampleAt(float t) {
  const float scaled = t * static_cast<float>(kExample.size());
  const auto i = static_cast<size_t>(scaled);
  const float f = scaled - std::floor(scaled);
  const auto point = [&](size_t k) { return kExample[k % kExample.size()]; };
  const ImVec2 a = point(i + kExample.size() - 1), b = point(i), c = point(i + 1), d = point(i + 2);
  const auto blend = [f](float p, float q, float r, float s) {  // Catmull–Rom
    return q + 0.5f * f * (r - p + f * (2 * p - 5 * q + 4 * r - s + f * (3 * (q - r) + s - p)));
  };
  return {blend(a.x, b.x, c.x, d.x), blend(a.y, b.y, c.y, d.y)};
}

Vec2 vec2(ImVec2 p) { return {p.x, p.y}; }

void drawCentredLine(ImDrawList& list, ImFont* font, const char* text, float x, float y,
                     ImU32 color) {
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text);
  list.AddText(font, size, {std::round(x - extent.x / 2), std::round(y)}, color, text);
}

}  // namespace

void drawHint(const PanelInput& input, UiState& ui, Requests& requests) {
  const auto button_before = std::exchange(ui.start_button, std::nullopt);
  if (!input.shelf.keeping.empty() || !input.shown.parts.empty() || input.drawing) return;
  const bool offers = input.shelf.keeping.offer() != nullptr;
  if (ui.open.anySheet() || (offers && lowCanvas(ui))) return;
  if (ui.hint_since_ms < 0) ui.hint_since_ms = ui.now_ms;
  const double age_ms = ui.now_ms - ui.hint_since_ms;
  const double progress = std::clamp(age_ms / kDrawn_ms, 0.0, 1.0);
  if (progress < 1) requests.again = true;

  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float radius = std::min({canvasWidth(ui) * 0.26f, canvasHeight(ui) * 0.20f, 150.0f});
  // Low canvases: higher up, so that there is room for the button.
  const float lowest =
      canvasHeight(ui) - 2 * margin(ui) - 2 * barHeight(ui) - kButtonBelow - radius * 0.92f;
  const float highest = margin(ui) + radius;
  const ImVec2 at{canvasWidth(ui) / 2,
                  std::min(canvasHeight(ui) / 2 - radius * 0.25f, std::max(lowest, highest))};
  constexpr int kSteps = 160;
  const int shown = static_cast<int>(std::lround(kSteps * progress));
  list.PathClear();
  for (int i = 0; i <= shown; ++i) {
    const ImVec2 p = exampleAt(static_cast<float>(i) / kSteps * 0.999f);
    list.PathLineTo({at.x + p.x * radius, at.y - p.y * radius});
  }
  list.PathStroke(IM_COL32(41, 46, 60, 60), 0, 3);
  const ImVec2 tip = exampleAt(static_cast<float>(shown) / kSteps * 0.999f);
  list.AddCircleFilled({at.x + tip.x * radius, at.y - tip.y * radius}, 6,
                       IM_COL32(37, 99, 174, 170), 24);
  drawCentredLine(list, fonts().title, "Draw a closed shape", at.x, at.y + radius * 0.92f,
                  Theme::kText);
  drawCentredLine(list, fonts().regular, "It becomes a body with bones while you draw.", at.x,
                  at.y + radius * 0.92f + 30, Theme::kSoftText);
  PanelBox box;
  box.bar = true;
  box.anchor = {0.5f, 0};
  box.position = {std::round(at.x), std::round(at.y + radius * 0.92f + kButtonBelow)};
  const float room = canvasHeight(ui) - 2 * margin(ui) - barHeight(ui) - box.position.y;
  if (room < barHeight(ui)) return;
  // In the middle of the canvas, where strokes begin: only a click on it is for it.
  box.drawn_through = true;
  beginPanel("start", box);
  ButtonLook look;
  look.raised =
      ImGui::IsMousePosValid() && button_before && button_before->has(vec2(ImGui::GetMousePos()));
  textButton("samples", "Or start from a sample", buttonSide(ui), look);
  ui.start_button = Box2{vec2(ImGui::GetItemRectMin()), vec2(ImGui::GetItemRectMax())};
  endPanel();
}

void drawToast(const PanelInput&, UiState& ui, Requests& requests) {
  if (!ui.toast) return;
  const double age_ms = ui.now_ms - ui.toast->shown_ms;
  if (age_ms >= kToastStays_ms + kToastFades_ms) {
    ui.toast.reset();
    requests.again = true;
    return;
  }
  const double fade = std::clamp((age_ms - kToastStays_ms) / kToastFades_ms, 0.0, 1.0);
  if (fade > 0) requests.again = true;
  requests.wake_after_ms = std::min(requests.wake_after_ms, kToastStays_ms - age_ms);

  const float wrap = std::min(canvasWidth(ui) - 4 * margin(ui) - 32, 420.0f);
  const ImVec2 extent = ImGui::CalcTextSize(ui.toast->text.c_str(), nullptr, false, wrap);
  const ImVec2 size{extent.x + 32, extent.y + 20};
  // Where no sheet covers it: below the upper bar, or above the lower edge.
  float y = ui.narrow() ? 2 * margin(ui) + std::max(barHeight(ui), gizmoSide(ui))
                        : canvasHeight(ui) - 2 * margin(ui) - barHeight(ui) - size.y;
  if (const auto offer = panelSpan("offer"); offer && ui.narrow()) y = offer->bottom + margin(ui);
  const ImVec2 low{std::round(canvasWidth(ui) / 2 - size.x / 2), std::round(y)};
  const auto faded = [&](ImU32 color) {
    const auto alpha = static_cast<double>(color >> IM_COL32_A_SHIFT) * (1 - fade);
    return (color & ~IM_COL32_A_MASK) | (static_cast<ImU32>(alpha) << IM_COL32_A_SHIFT);
  };
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, faded(Theme::kTooltip), 12);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + 16, low.y + 10},
               faded(Theme::kTooltipText), ui.toast->text.c_str(), nullptr, wrap);
}

}  // namespace marrow
