#include "panels/panel_layer.h"

#include <algorithm>
#include <cfloat>

#include "imgui_internal.h"
#include "panels/layout.h"
#include "panels/theme.h"
#include "panels/widgets.h"
#include "render/scene.h"

namespace marrow {
namespace {

constexpr int kLetterA = 100;  // any index that no other key has

ImGuiKey imguiKey(Key key) {
  switch (key) {
    case Key::backspace:
      return ImGuiKey_Backspace;
    case Key::enter:
      return ImGuiKey_Enter;
    case Key::left_arrow:
      return ImGuiKey_LeftArrow;
    case Key::right_arrow:
      return ImGuiKey_RightArrow;
    case Key::home:
      return ImGuiKey_Home;
    case Key::end:
      return ImGuiKey_End;
    case Key::delete_forward:
      return ImGuiKey_Delete;
    case Key::escape:
      return ImGuiKey_Escape;
    default:
      return ImGuiKey_COUNT;
  }
}

struct Side {
  const char* name;
  bool PanelsOpen::*open;
};
constexpr Side kLeft[] = {{"file", &PanelsOpen::file},       {"gallery", &PanelsOpen::gallery},
                          {"picture", &PanelsOpen::picture}, {"export", &PanelsOpen::exporting},
                          {"help panel", &PanelsOpen::help}, {"parts", &PanelsOpen::parts}};

}  // namespace

PanelLayer::PanelLayer() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.MousePos = {-FLT_MAX, -FLT_MAX};
  io.MouseDoubleClickTime = 0.5f;  // frames can be slow, and each press needs one of its own
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
  io.KeyMap[ImGuiKey_A] = kLetterA;
  applyTheme();
}

PanelLayer::~PanelLayer() { ImGui::DestroyContext(); }

void PanelLayer::setDensity(double dpr) {
  if (dpr == dpr_) return;
  dpr_ = dpr;
  buildFonts(dpr);
  ++fonts_version_;
}

bool PanelLayer::panelAt(Vec2 pixel) const {
  const ImVec2 at{static_cast<float>(pixel.x), static_cast<float>(pixel.y)};
  for (const ImGuiWindow* window : GImGui->Windows) {
    const bool shown = window->WasActive && !window->Hidden && window->LastFrameActive >= 0;
    if (!shown || (window->Flags & ImGuiWindowFlags_NoMouseInputs)) continue;
    if (window->OuterRectClipped.Contains(at)) return true;
  }
  return false;
}

void PanelLayer::pointer(const PointerEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  const bool mouse = event.kind == PointerKind::mouse;
  if (event.type == PointerEvent::Type::leave) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    return;
  }
  io.MousePos = {static_cast<float>(event.position_px.x), static_cast<float>(event.position_px.y)};
  switch (event.type) {
    case PointerEvent::Type::down:
      io.MouseDown[0] = event.button == Button::primary;
      io.KeyShift = event.shift;
      touch_lifted_ = false;
      // Without this the distance from the last touch would count as a drag.
      if (!mouse) io.MousePosPrev = io.MousePos;
      break;
    case PointerEvent::Type::cancel:
      ImGui::ClearActiveID();
      [[fallthrough]];
    case PointerEvent::Type::up:
      io.MouseDown[0] = false;
      touch_lifted_ = event.kind == PointerKind::touch;
      break;
    default:
      break;
  }
}

void PanelLayer::wheel(const WheelEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  io.MouseWheel += static_cast<float>(event.zoom * 6 + event.pan_px.y / 60);
}

void PanelLayer::key(const KeyEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.key == Key::select_all) {
    io.KeyCtrl = true;
    io.KeyMods = ImGuiKeyModFlags_Ctrl;
    io.KeysDown[kLetterA] = true;
    keys_down_ = true;
  } else if (const ImGuiKey key = imguiKey(event.key); key != ImGuiKey_COUNT) {
    io.KeysDown[key] = true;
    keys_down_ = true;
  }
}

void PanelLayer::text(const TextEvent& event) {
  ImGui::GetIO().AddInputCharacter(static_cast<unsigned int>(event.character));
}

void PanelLayer::letGoOfText() {
  if (ImGui::GetIO().WantTextInput) ImGui::ClearActiveID();
}

bool PanelLayer::wantsText() const {
  return ImGui::GetIO().WantTextInput && ImGui::GetActiveID() != 0;
}

// There is room for one panel at the left: the one that was opened last. What the last stroke took
// stands at the right, but may reach as far as there.
bool PanelLayer::keepOneAtLeft(PanelsOpen& open) {
  const auto opens = [&](bool PanelsOpen::*which) { return open.*which && !(last_open_.*which); };
  const auto opened =
      std::find_if(std::begin(kLeft), std::end(kLeft), [&](Side side) { return opens(side.open); });
  if (opened != std::end(kLeft)) {
    for (const Side& other : kLeft) open.*other.open = other.open == opened->open;
    left_is_newer_ = true;
  }
  if (opens(&PanelsOpen::performance)) left_is_newer_ = false;
  const auto times = panelSpan("performance panel");
  const auto meets = [&](Side side) {
    const auto left = panelSpan(side.name);
    return open.performance && open.*side.open && times && left && left->right > times->left &&
           left->bottom > times->top;
  };
  const auto met = std::find_if(std::begin(kLeft), std::end(kLeft), meets);
  frames_met_ = met == std::end(kLeft) ? 0 : frames_met_ + 1;
  // In its first frame a panel does not know yet how much room it needs.
  if (frames_met_ >= 2) open.*(left_is_newer_ ? &PanelsOpen::performance : met->open) = false;
  return frames_met_ > 0;
}

// What the panels take of the canvas's sides. by_model_sheets: by those alone that change or show
// the model and are not there all the time. Sheets lie at the bottom, or at the right of a low
// canvas, beside whose tools there is not much room either.
Insets PanelLayer::covered(const UiState& ui, bool by_model_sheets) const {
  Insets covered;
  const auto cover = [&](const char* name, double Insets::*side) {
    const ImGuiWindow* window = ImGui::FindWindowByName(name);
    if (!window || !window->Active || window->Hidden) return;
    const ImVec2 low = window->Pos, high{low.x + window->Size.x, low.y + window->Size.y};
    const double taken = side == &Insets::left    ? high.x
                         : side == &Insets::right ? canvasWidth(ui) - low.x
                                                  : canvasHeight(ui) - low.y;
    covered.*side = std::max(covered.*side, taken);
  };
  const auto sheet_side = lowCanvas(ui) ? &Insets::right : &Insets::bottom;
  for (const char* name : {"part", "parts", "refine", "pose", "export", "view sheet"}) {
    if (ui.narrow()) cover(name, sheet_side);
  }
  if (!ui.narrow()) {
    cover("pose", &Insets::right);
    cover("export", &Insets::left);
  }
  if (by_model_sheets) return covered;
  for (const char* name : {"part", "refine"}) {
    if (!ui.narrow()) cover(name, &Insets::right);
  }
  for (const Side& side : kLeft) cover(side.name, ui.narrow() ? sheet_side : &Insets::left);
  if (lowCanvas(ui)) cover("tools", &Insets::left);
  return covered;
}

Requests PanelLayer::frame(const PanelInput& input, UiState& ui) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(ui.size.width), static_cast<float>(ui.size.height)};
  io.DisplayFramebufferScale = {static_cast<float>(ui.dpr), static_cast<float>(ui.dpr)};
  io.DeltaTime = static_cast<float>(std::clamp((ui.now_ms - last_frame_ms_) / 1000, 1e-4, 0.5));
  last_frame_ms_ = ui.now_ms;
  const bool lifted = touch_lifted_;
  const bool keys_down = keys_down_;

  ImGui::NewFrame();
  forgetPlaces();
  Requests requests;
  drawCanvasMarks(input, ui, requests);
  drawHint(input, ui, requests);
  drawToolbar(input, ui, requests);
  drawToolPanel(input, ui, requests);
  drawViewControls(input, ui, requests);
  drawPartsPanel(input, ui, requests);
  drawHelpPanel(input, ui, requests);
  drawPerformancePanel(input, ui, requests);
  drawPartPanel(input, ui, requests);
  drawPosePanel(input, ui, requests);
  drawFilePanel(input, ui, requests);
  drawExportPanel(input, ui, requests);
  drawGalleryPanel(input, ui, requests);
  drawReferencePanel(input, ui, requests);
  drawOffer(input, ui, requests);
  drawRefinePanel(input, ui, requests);
  drawToast(input, ui, requests);
  requests.again |= keepOneAtLeft(ui.open);
  last_open_ = ui.open;
  ImGui::Render();

  if (lifted) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    touch_lifted_ = false;
    requests.again = true;
  }
  if (keys_down) {
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    io.KeyCtrl = false;
    keys_down_ = false;
    requests.again = true;
  }
  if (tooltipIsDue()) requests.wake_after_ms = std::min(requests.wake_after_ms, 100.0);
  return requests;
}

uint64_t PanelLayer::fingerprint() const {
  const ImDrawData* data = ImGui::GetDrawData();
  uint64_t hash = static_cast<uint64_t>(fonts_version_);
  if (!data) return hash;
  const auto mix = [&](const void* bytes, size_t count) {
    hash = marrow::fingerprint(bytes, count, hash);
  };
  for (int i = 0; i < data->CmdListsCount; ++i) {
    const ImDrawList& list = *data->CmdLists[i];
    mix(list.VtxBuffer.Data, static_cast<size_t>(list.VtxBuffer.size_in_bytes()));
    mix(list.IdxBuffer.Data, static_cast<size_t>(list.IdxBuffer.size_in_bytes()));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      mix(&command.ClipRect, sizeof command.ClipRect);
      mix(&command.ElemCount, sizeof command.ElemCount);
      mix(&command.TextureId, sizeof command.TextureId);
    }
  }
  return hash;
}

}  // namespace marrow
