// What is drawn on the canvas around the hand: handles, the box, the line of symmetry, outlines to
// change, and where a part will hang.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "document/symmetry.h"
#include "panels/layout.h"
#include "panels/panel.h"
#include "tools/gizmo.h"

namespace marrow {
namespace {

constexpr ImU32 kAxisColors[] = {IM_COL32(196, 84, 40, 255), IM_COL32(46, 132, 96, 255),
                                 IM_COL32(37, 99, 174, 255)};
constexpr ImU32 kHandle = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kEdge = IM_COL32(41, 46, 60, 255);
constexpr ImU32 kRing = IM_COL32(41, 46, 60, 120);
constexpr ImU32 kHot = IM_COL32(244, 160, 30, 255);
constexpr ImU32 kMirror = IM_COL32(170, 60, 120, 200);
constexpr ImU32 kAttach = IM_COL32(20, 120, 84, 255);

ImVec2 toIm(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

class Marks {
 public:
  Marks(const PanelInput& input, const UiState& ui)
      : input_(input), ui_(ui), list_(*ImGui::GetBackgroundDrawList()) {}

  void symmetryLine() {
    const auto plane = symmetryPlane(input_.shown);
    if (!plane || !ui_.symmetry) return;
    // Before the first stroke, too: a half outline begins on it.
    const bool asked = ui_.tool == ToolKind::line || input_.hand.mode() == Hand::Mode::stroke ||
                       input_.shown.parts.empty();
    const auto [right, up, back] = ui_.camera.axes();
    const Vec2 normal{dot(right, plane->normal), -dot(up, plane->normal)};
    if (!asked || length(normal) < 0.985) return;  // not seen as a line
    const Vec3 on = ui_.camera.target - plane->normal * distance(*plane, ui_.camera.target);
    const Vec2 middle = ui_.camera.toScreen(on, ui_.size);
    const Vec2 along = perpendicular(normal / length(normal));
    const double reach = ui_.size.width + ui_.size.height;
    dashed(middle - along * reach, middle + along * reach, kMirror, 1.5f);
  }

  void box() {
    if (input_.hand.mode() != Hand::Mode::box) return;
    const ImVec2 a = toIm(input_.hand.from_px()), b = toIm(input_.hand.to_px());
    const ImVec2 low{std::min(a.x, b.x), std::min(a.y, b.y)};
    const ImVec2 high{std::max(a.x, b.x), std::max(a.y, b.y)};
    if (high.x - low.x < 4 && high.y - low.y < 4) return;
    list_.AddRectFilled(low, high, IM_COL32(37, 99, 174, 26));
    list_.AddRect(low, high, IM_COL32(37, 99, 174, 200), 0, 0, 1.2f);
  }

  void line() {
    if (input_.hand.mode() != Hand::Mode::line) return;
    const Vec2 a = input_.hand.from_px(), b = input_.hand.to_px();
    list_.AddLine(toIm(a), toIm(b), kMirror, 3);
    if (const auto plane = planeOverLine(a, b, ui_.camera, ui_.size)) {
      const auto [right, up, back] = ui_.camera.axes();
      const Vec2 normal{dot(right, plane->normal), -dot(up, plane->normal)};
      const Vec2 along = perpendicular(normal);
      const Vec2 middle = (a + b) / 2;
      const double reach = ui_.size.width + ui_.size.height;
      dashed(middle - along * reach, middle + along * reach, kMirror, 1.5f);
    }
  }

  void outline() {
    if (ui_.tool != ToolKind::redraw && ui_.tool != ToolKind::reshape) return;
    const PlacedPart* placed = find(ui_.selection.primary());
    if (!placed) return;
    const EvaluatedPart& evaluated = input_.evaluation.parts()[placed->source];
    if (!evaluated.part || !evaluated.source->visible || evaluated.source->mesh) return;
    list_.PathClear();
    for (const Vec2 p : evaluated.part->outline.dense) {
      list_.PathLineTo(toIm(onScreen(placed->frame.toWorld(p))));
    }
    list_.PathStroke(kEdge, ImDrawFlags_Closed, 1.6f);
    const bool still = input_.hand.mode() != Hand::Mode::contour;
    if (evaluated.source->locked || !still || ui_.tool == ToolKind::redraw) return;
    const float radius = ui_.touch() ? 6.5f : 4.5f;
    for (const Vec3 handle : contourHandles(*evaluated.part, placed->frame, ui_.camera)) {
      const ImVec2 at = toIm(onScreen(handle));
      list_.AddCircleFilled(at, radius, kHandle, 20);
      list_.AddCircle(at, radius, kEdge, 20, 1.4f);
    }
  }

  void gizmo() {
    if (ui_.tool != ToolKind::select && input_.hand.mode() != Hand::Mode::transform) return;
    if (input_.hand.mode() == Hand::Mode::transform) {
      transformation();
      return;
    }
    if (input_.hand.mode() != Hand::Mode::idle) return;
    if (changeable(ui_.selection, input_.evaluation).empty()) return;
    const auto pivot = selectionPivot(ui_.selection, input_.evaluation);
    const Gizmo gizmo = layOutGizmo(*pivot, ui_.camera, ui_.size, ui_.touch());
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const auto hot = handleAt(gizmo, {pointer.x, pointer.y}, ui_.touch());
    const auto color = [&](GizmoHandle handle, ImU32 plain) {
      return hot && *hot == handle ? kHot : plain;
    };
    const ImVec2 middle = toIm(gizmo.middle);
    list_.AddCircle(middle, static_cast<float>(gizmo.ring),
                    color({TransformKind::rotate, TransformAxis::none}, kRing), 96, 2);
    for (size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<TransformAxis>(k + 1);
      if (!gizmo.arcs[k].empty()) {
        list_.PathClear();
        for (const Vec2 p : gizmo.arcs[k]) list_.PathLineTo(toIm(p));
        list_.PathStroke(color({TransformKind::rotate, axis}, kAxisColors[k]), 0, 2.4f);
      }
      if (gizmo.arrows[k]) {
        arrow(gizmo.middle, *gizmo.arrows[k], color({TransformKind::move, axis}, kAxisColors[k]));
      }
    }
    knob(middle, 7, color({TransformKind::move, TransformAxis::none}, kHandle));
    const ImVec2 at = toIm(gizmo.scale);
    list_.AddRectFilled({at.x - 6, at.y - 6}, {at.x + 6, at.y + 6},
                        color({TransformKind::scale, TransformAxis::none}, kHandle), 2);
    list_.AddRect({at.x - 6, at.y - 6}, {at.x + 6, at.y + 6}, kEdge, 2, 0, 1.4f);
  }

  // Pins, and how far away what was asked for lies.
  void posing() {
    if (ui_.tool != ToolKind::pose) return;
    const Rig& rig = input_.stance.posed;
    for (const uint32_t pin : input_.stance.pins) {
      if (pin >= rig.joints.size()) continue;
      const ImVec2 at = toIm(onScreen(rig.joints[pin].position));
      list_.AddCircle(at, 11, kHandle, 32, 4);
      list_.AddCircle(at, 11, kAttach, 32, 2.4f);
      list_.AddCircleFilled(at, 4, kAttach, 20);
    }
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (paints(ui_.posing) && ImGui::IsMousePosValid(&pointer) &&
        !ImGui::GetIO().WantCaptureMouse) {
      const auto radius = static_cast<float>(ui_.posing.brush_px);
      list_.AddCircle(pointer, radius + 1, IM_COL32(255, 255, 255, 200), 48, 3);
      list_.AddCircle(pointer, radius + 1, kEdge, 48, 1.4f);
    }
    const PoseTool& tool = input_.hand.posing();
    if (const auto target = tool.outOfReach()) {
      const Vec2 to = onScreen(*target);
      const Vec2 from = onScreen(rig.joints[tool.joint()].position);
      if (distance(from, to) > 6) dashed(from, to, kRing, 2);
      list_.AddCircle(toIm(to), 6, kRing, 24, 2);
    }
    if (tool.byKey()) {
      const std::string text =
          tool.label() + "     X Y Z \xC2\xB7 number \xC2\xB7 click \xC2\xB7 Esc";
      const float width = ImGui::CalcTextSize(text.c_str()).x;
      label(text, {canvasWidth(ui_) / 2 - width / 2, margin(ui_) + 4}, kEdge);
    }
  }

  void attachments() {
    const auto& placed = input_.evaluation.placed();
    const bool moves = input_.hand.mode() == Hand::Mode::transform;
    for (const Connection& connection : input_.rig.connections) {
      const bool live = connection.child >= placed.size();
      const auto chosen = [&](uint32_t part) {
        return part < placed.size() && ui_.selection.has(placed[part].id);
      };
      if (!live && !(moves && chosen(connection.child) != chosen(connection.parent))) continue;
      const ImVec2 at = toIm(onScreen(connection.parent_position));
      const ImVec2 from = toIm(onScreen(connection.child_position));
      list_.AddLine(from, at, kAttach, 2.5f);
      list_.AddCircleFilled(at, 7, kHandle, 24);
      list_.AddCircle(at, 7, kAttach, 24, 3);
      // One label will do for a part and its twin.
      if (placedAt(connection.child).twin) continue;
      label(connection.event == AttachEvent::split ? "joins inside a bone" : "joins at a joint",
            {at.x + 14, at.y - 30}, kAttach);
    }
  }

 private:
  Vec2 onScreen(Vec3 world) const { return ui_.camera.toScreen(world, ui_.size); }

  const PlacedPart* find(const std::string& id) const {
    return findPlaced(input_.evaluation.placed(), id);
  }
  const PlacedPart& placedAt(uint32_t index) const {
    const auto& placed = input_.evaluation.placed();
    return index < placed.size() ? placed[index] : input_.live.placed[index - placed.size()];
  }

  void dashed(Vec2 a, Vec2 b, ImU32 color, float width) {
    constexpr double kDash = 9, kGap = 7;
    const Vec2 along = (b - a) / distance(a, b);
    const double end = distance(a, b);
    for (double at = 0; at < end; at += kDash + kGap) {
      const Vec2 from = a + along * at, to = a + along * std::min(at + kDash, end);
      const bool seen = std::max(from.x, to.x) > 0 && std::min(from.x, to.x) < ui_.size.width &&
                        std::max(from.y, to.y) > 0 && std::min(from.y, to.y) < ui_.size.height;
      if (seen) list_.AddLine(toIm(from), toIm(to), color, width);
    }
  }

  void arrow(Vec2 from, Vec2 tip, ImU32 color) {
    const Vec2 along = (tip - from) / distance(from, tip);
    const Vec2 side = perpendicular(along);
    list_.AddLine(toIm(from), toIm(tip - along * 8), color, 2.6f);
    list_.AddTriangleFilled(toIm(tip + along * 5), toIm(tip - along * 10 + side * 7),
                            toIm(tip - along * 10 - side * 7), color);
  }

  void knob(ImVec2 at, float radius, ImU32 color) {
    list_.AddCircleFilled(at, radius, color, 24);
    list_.AddCircle(at, radius, kEdge, 24, 1.4f);
  }

  void label(const std::string& text, ImVec2 at, ImU32 color) {
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const ImVec2 padding{9, 5};
    at.x = std::clamp(at.x, 4.0f, std::max(4.0f, canvasWidth(ui_) - extent.x - 2 * padding.x - 4));
    at.y = std::clamp(at.y, 4.0f, canvasHeight(ui_) - extent.y - 2 * padding.y - 4);
    list_.AddRectFilled(at, {at.x + extent.x + 2 * padding.x, at.y + extent.y + 2 * padding.y},
                        color, 8);
    list_.AddText({at.x + padding.x, at.y + padding.y}, Theme::kTooltipText, text.c_str());
  }

  // What the hand does now: the axis it keeps to, and how far it has come.
  void transformation() {
    const TransformTool& tool = input_.hand.transform();
    const Vec2 pivot = onScreen(tool.pivot());
    if (tool.axis() != TransformAxis::none) {
      const auto [right, up, back] = ui_.camera.axes();
      const Vec3 axis = axisDirection(tool.axis(), ui_.camera);
      const Vec2 along{dot(right, axis), -dot(up, axis)};
      const ImU32 color = kAxisColors[static_cast<size_t>(tool.axis()) - 1];
      if (length(along) > 0.1) {
        const double reach = ui_.size.width + ui_.size.height;
        list_.AddLine(toIm(pivot - along * reach), toIm(pivot + along * reach), color, 1.5f);
      }
    }
    list_.AddCircleFilled(toIm(pivot), 4, kEdge, 16);
    std::string text = tool.label();
    if (tool.byKey() && !ui_.touch())
      text += "     X Y Z \xC2\xB7 number \xC2\xB7 click \xC2\xB7 Esc";
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    label(text, {canvasWidth(ui_) / 2 - width / 2, margin(ui_) + 4}, kEdge);
  }

  const PanelInput& input_;
  const UiState& ui_;
  ImDrawList& list_;
};

}  // namespace

void drawCanvasMarks(const PanelInput& input, UiState& ui, Requests&) {
  Marks marks(input, ui);
  marks.symmetryLine();
  marks.line();
  marks.outline();
  marks.attachments();
  marks.gizmo();
  marks.posing();
  marks.box();
}

}  // namespace marrow
