// What the keys do.
#include <utility>

#include "app.h"
#include "document/depth.h"

namespace marrow {
namespace {

// How far a copy lies from its original, on the screen.
constexpr double kCopyAway_px = 24;
constexpr const char* kDrawFirst = "Draw a part first.";

}  // namespace

void App::handle(const KeyEvent& event) {
  if (handleFileKey(event.key)) return;
  if (panels_.wantsText() && event.key != Key::undo && event.key != Key::redo) {
    panels_.key(event);
    return;
  }
  // Undo and redo bring back what was selected; anything else would miss it.
  if (event.key != Key::undo && event.key != Key::redo) forgetWhatIsGone();
  if (event.character != 0) {
    handleCharacter(event.character);
    return;
  }
  switch (event.key) {
    case Key::undo:
      undo();
      break;
    case Key::redo:
      redo();
      break;
    case Key::delete_forward:
    case Key::backspace:
      if (hand_.key('\b', ui_) || ui_.tool == ToolKind::pose) break;
      if (!tools_.drawing().active() && !ui_.selection.empty()) {
        apply(DeleteParts{ui_.selection.ids});
      }
      break;
    case Key::enter:
      if (!hand_.followsKey()) break;
      if (const auto command = hand_.finishByKey(ui_)) apply(*command);
      break;
    case Key::escape:
      escape();
      break;
    case Key::select_all:
      if (ui_.tool == ToolKind::pose) break;
      ui_.selection.clear();
      for (const PlacedPart& placed : evaluation_.placed()) {
        const PartSource& source = *evaluation_.parts()[placed.source].source;
        if (source.visible && !source.locked) ui_.selection.ids.push_back(placed.id);
      }
      break;
    case Key::home:
      frameAll();
      break;
    default:
      break;
  }
}

bool App::escape() {
  const bool part_sheet = ui_.open.part && !ui_.selection.empty();
  if (tools_.cancelGesture() || hand_.mode() != Hand::Mode::idle) {
    hand_.cancel(ui_);
    document_changed_ = true;
  } else if (ui_.edit) {
    closeEdit();
  } else if (ui_.attaching) {
    ui_.attaching = false;
  } else if (ui_.open.anySheet()) {
    ui_.open.closeSheets();
  } else if (ui_.narrow() && (part_sheet || ui_.open.parts || ui_.open.skeleton)) {
    ui_.open.part = ui_.open.parts = ui_.open.skeleton = false;
  } else if (ui_.tool == ToolKind::pose && !ui_.posing.joint.empty()) {
    ui_.posing.joint.clear();
  } else if (!ui_.selection.empty()) {
    ui_.selection.clear();
  } else if (ui_.open.parts || ui_.open.skeleton) {
    ui_.open.parts = ui_.open.skeleton = false;
  } else {
    ui_.tool = ToolKind::draw;
  }
  return true;
}

bool App::handleCharacter(char character) {
  if (hand_.key(character, ui_)) return true;
  if (tools_.drawing().active()) return false;
  if (ui_.tool == ToolKind::pose && posingKey(character)) return true;
  switch (character) {
    case 'g':
    case 'G':
      transformByKey(TransformKind::move);
      break;
    case 'r':
    case 'R':
      transformByKey(TransformKind::rotate);
      break;
    case 's':
    case 'S':
      transformByKey(TransformKind::scale);
      break;
    case 'x':
    case 'X':
      if (!ui_.selection.empty()) apply(DeleteParts{ui_.selection.ids});
      break;
    case 'D':
      if (!ui_.selection.empty()) {
        const auto [right, up, back] = ui_.camera.axes();
        apply(DuplicateParts{ui_.selection.ids, (right - up) * (kCopyAway_px / ui_.camera.zoom)});
      }
      break;
    case 'h':
      toggleVisible(false);
      break;
    case 'H':
      toggleVisible(true);
      break;
    case '[':
      layer(false);
      break;
    case ']':
      layer(true);
      break;
    case 'm':
    case 'M':
      ui_.symmetry = !ui_.symmetry;
      break;
    case 'b':
    case 'B':
      useTool(ToolKind::draw);
      break;
    case 'v':
    case 'V':
      useTool(ToolKind::select);
      break;
    case 'c':
      useTool(ui_.tool == ToolKind::redraw ? ToolKind::reshape : ToolKind::redraw);
      break;
    case 'C':
      useTool(ToolKind::reshape);
      break;
    case 'p':
    case 'P':
      useTool(ui_.tool == ToolKind::pose ? ToolKind::draw : ToolKind::pose);
      break;
    case 'l':
    case 'L':
      useTool(ToolKind::line);
      break;
    case '1':
      show(StandardView::front);
      break;
    case '3':
      show(StandardView::right);
      break;
    case '7':
      show(StandardView::top);
      break;
    case 'f':
    case 'F':
      frameAll();
      break;
    case '?':
      ui_.open.help = !ui_.open.help;
      break;
    default:
      return false;
  }
  return true;
}

void App::transformByKey(TransformKind kind) {
  closeEdit();
  if (!hand_.beginByKey(kind, pointer_px_, ui_, world())) {
    say(document().parts.empty()     ? kDrawFirst
        : ui_.tool == ToolKind::pose ? "Choose a joint first: click it."
                                     : "Select a part first: click it.");
  }
}

void App::useTool(ToolKind tool) {
  hand_.cancel(ui_);
  if (tool == ToolKind::pose && evaluation_.rig().bones.empty()) {
    say(document().parts.empty() ? kDrawFirst : "There are no bones to pose yet.");
    return;
  }
  ui_.tool = tool;
  if (tool == ToolKind::pose) ui_.attaching = false;
  const bool outline = tool == ToolKind::redraw || tool == ToolKind::reshape;
  if (outline && ui_.selection.empty()) {
    say(document().parts.empty() ? kDrawFirst : "Click the part whose outline you want to change.");
  }
}

void App::toggleVisible(bool show_all) {
  std::vector<std::string> ids;
  for (const EvaluatedPart& part : evaluation_.parts()) {
    if (show_all && !part.source->visible) ids.push_back(part.source->id);
  }
  if (!show_all) ids = ui_.selection.ids;
  if (!ids.empty()) apply(SetVisible{ids, show_all});
}

void App::layer(bool nearer) {
  if (ui_.selection.empty()) return;
  TransformParts move{ui_.selection.ids, {}, "Move"};
  const auto way = layerMove(evaluation_, ui_.selection.ids, ui_.camera.axes()[2], nearer);
  if (way) {
    move.map.move = *way;
    apply(move);
  } else {
    say(nearer ? "No part that it covers lies further in front."
               : "No part that it covers lies further back.");
  }
}

}  // namespace marrow
