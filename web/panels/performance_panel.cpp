// What the last stroke cost, stage by stage.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <string>

#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {
namespace {

// "straightSkeleton" → "straight skeleton"
std::string words(const char* stage) {
  std::string text;
  for (const char* c = stage; *c; ++c) {
    if (*c >= 'A' && *c <= 'Z') {
      text += ' ';
      text += static_cast<char>(*c - 'A' + 'a');
    } else {
      text += *c;
    }
  }
  return text;
}

void row(const char* name, double ms, double longest_ms) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ms", ms);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFontSize() + 6;
  if (longest_ms > 0) {
    const auto share = static_cast<float>(std::clamp(ms / longest_ms, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width * share, at.y + height},
                                              Theme::kAccentSoft, 4);
  }
  ImGui::GetWindowDrawList()->AddText({at.x + 6, at.y + 3}, Theme::kText, name);
  const float text_width = ImGui::CalcTextSize(text).x;
  ImGui::GetWindowDrawList()->AddText({at.x + width - text_width - 6, at.y + 3}, Theme::kText,
                                      text);
  ImGui::Dummy({width, height});
}

}  // namespace

void drawPerformancePanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.performance || input.drawing) return;
  PanelBox box = sheetBox(ui);
  if (!ui.narrow()) {
    box.position.x = canvasWidth(ui) - margin(ui);
    box.anchor = {1, 1};
    box.width = 268;
    // Below what is in the column, or beside it where the column is too short for both.
    const auto own = panelSpan("performance panel");
    const float top = box.position.y - (own ? own->bottom - own->top : box.max_height);
    for (const char* name : {"part", "refine"}) {
      const auto other = panelSpan(name);
      if (!other || other->bottom + margin(ui) <= top) continue;
      box.position.x -= columnBox(ui).width + margin(ui);
      break;
    }
  }
  beginPanel("performance panel", box);
  if (titleRow("Last stroke", ui)) {
    ui.open.performance = false;
    requests.again = true;
  }
  const Meter& meter = input.meter;
  if (meter.last_part.stages_ms.empty()) {
    softText("Draw something to see how long each step takes.");
  } else {
    double longest_ms = 0;
    for (const auto& stage : meter.last_part.stages_ms) {
      longest_ms = std::max(longest_ms, stage.second);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 1));
    for (const auto& [stage, ms] : meter.last_part.stages_ms) {
      row(words(stage).c_str(), ms, longest_ms);
    }
    row("all of it", meter.last_part.total_ms, 0);
    if (meter.preview.count() > 0) {
      ImGui::Separator();
      row("live, typical frame", meter.preview.median_ms(), 0);
      row("live, slowest frame", meter.preview.max_ms(), 0);
    }
    ImGui::PopStyleVar();
  }
  endPanel();
}

}  // namespace marrow
