#include "app.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/document_json.h"
#include "pick.h"

namespace marrow {
namespace {

constexpr int kSettleFrames = 3;
// The live preview may take this share of the time while a stroke is under way.
constexpr double kPreviewShare = 0.6;
// Below this turn nobody notices that drawing went back to the front view.
constexpr double kNoticeable_rad = 0.15;
// A stroke shorter than this on the screen was no stroke.
constexpr double kShortestStroke_px = 20;
constexpr const char* kTooSmall =
    "That was too small to become a shape. Draw a closed shape, a little larger.";

bool isButton(const InputEvent& event) {
  const auto* pointer = std::get_if<PointerEvent>(&event);
  return pointer &&
         (pointer->type == PointerEvent::Type::down || pointer->type == PointerEvent::Type::up ||
          pointer->type == PointerEvent::Type::cancel);
}

}  // namespace

App::App(Clock clock) : clock_(clock), evaluation_({}, clock) {}

void App::resize(ViewSize size, double dpr) {
  const bool was_narrow = ui_.narrow();
  ui_.size = size;
  ui_.dpr = dpr;
  if (ui_.narrow() && (!was_narrow || scene_.bodies.empty())) {
    ui_.open = PanelsOpen{false, false, false, false};
  } else if (was_narrow && !ui_.narrow()) {
    ui_.open = PanelsOpen{};
  }
  panels_.setDensity(dpr);
  frames_to_settle_ = kSettleFrames;
  redraw();
}

App::FrameResult App::frame(double now_ms) {
  ui_.now_ms = now_ms;
  if (!input_.empty()) frames_to_settle_ = kSettleFrames;
  applyRequests();
  takeInput();
  if (ui_.glide.running()) ui_.camera = ui_.glide.at(now_ms);
  update();
  updateLivePart();

  scene_ = buildScene(evaluation_.parts(), live_, tools_.drawing(), ui_);
  const PanelInput input{history_, shown_, evaluation_.parts(), meter_,
                         tools_.drawing().active() && tools_.drawing().isStroke()};
  requests_ = panels_.frame(input, ui_);

  FrameResult result;
  const uint64_t fingerprints[] = {fingerprint(scene_), panels_.fingerprint()};
  const uint64_t now = fingerprint(fingerprints, sizeof fingerprints, 1);
  result.draw = now != drawn_fingerprint_;
  drawn_fingerprint_ = now;
  frames_drawn_ += result.draw ? 1 : 0;
  if (frames_to_settle_ > 0) --frames_to_settle_;
  result.again = frames_to_settle_ > 0 || requests_.again || requests_.undo || requests_.redo ||
                 requests_.frame_all || requests_.view || requests_.commit_edit ||
                 requests_.orbit_px != Vec2{} || !requests_.commands.empty() || !input_.empty() ||
                 ui_.glide.running() || requests_.wake_after_ms <= 0;
  result.wake_after_ms = requests_.wake_after_ms;
  if (input.drawing && live_points_ != tools_.drawing().points().size()) {
    result.wake_after_ms = std::min(result.wake_after_ms, next_preview_ms_ - now_ms);
  }
  return result;
}

void App::takeInput() {
  // The panels see where a pointer is and whether it is down once a frame: what comes after a
  // change waits for the next one, and letting go waits for the way there.
  bool panels_busy = false, panels_moved = false;
  while (!input_.empty()) {
    const InputEvent event = input_.front();
    const auto* pointer = std::get_if<PointerEvent>(&event);
    if (pointer && (panels_busy || (panels_moved && pointer->type == PointerEvent::Type::up)))
      break;
    input_.pop_front();
    if (pointer) {
      const bool to_panels = handle(*pointer);
      panels_busy = to_panels && isButton(*pointer);
      panels_moved |= to_panels;
    } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
      handle(*key);
    } else if (const auto* wheel = std::get_if<WheelEvent>(&event)) {
      if (panels_.panelAt(wheel->position_px)) {
        panels_.wheel(*wheel);
      } else {
        tools_.wheel(*wheel, ui_);
      }
    } else if (const auto* text = std::get_if<TextEvent>(&event)) {
      if (panels_.wantsText()) panels_.text(*text);
    }
  }
  tools_.settle(ui_, pivot());
}

bool App::handle(const PointerEvent& event) {
  const Surroundings around{[this](Vec2 pixel) { return panels_.panelAt(pixel); }, pivot()};
  const bool was_stroke = tools_.drawing().active() && tools_.drawing().isStroke();
  const Tools::Outcome outcome = tools_.pointer(event, ui_, around);
  if (outcome.to_panels) panels_.pointer(event);
  if (!was_stroke && tools_.drawing().active() && tools_.drawing().isStroke()) {
    meter_.preview.restart();
  }
  if (outcome.turns_to_front && !said_turned_ && ui_.camera.angleFromFront() > kNoticeable_rad) {
    said_turned_ = true;
    say("Strokes are drawn in the front view, so the view turned back.");
  }
  if (outcome.command && tools_.drawing().travelled_px() < kShortestStroke_px) {
    say(kTooSmall);
  } else if (outcome.command) {
    apply(*outcome.command);
  }
  if (outcome.click_px) select(*outcome.click_px);
  return outcome.to_panels;
}

void App::handle(const KeyEvent& event) {
  if (panels_.wantsText() && event.key != Key::undo && event.key != Key::redo) {
    panels_.key(event);
    return;
  }
  switch (event.key) {
    case Key::undo:
      undo();
      break;
    case Key::redo:
      redo();
      break;
    case Key::remove:
    case Key::delete_forward:
      if (!tools_.drawing().active() && document().find(ui_.selected)) {
        apply(DeletePart{ui_.selected});
      }
      break;
    case Key::escape:
      if (tools_.cancelStroke()) break;
      if (ui_.edit) {
        closeEdit();
      } else if (ui_.open.help || ui_.open.view || ui_.open.performance) {
        ui_.open = PanelsOpen{ui_.open.part, false, false, false};
      } else {
        ui_.selected.clear();
      }
      break;
    case Key::front:
      show(StandardView::front);
      break;
    case Key::right:
      show(StandardView::right);
      break;
    case Key::top:
      show(StandardView::top);
      break;
    case Key::home:
    case Key::frame_all:
      frameAll();
      break;
    case Key::help:
      ui_.open.help = !ui_.open.help;
      break;
    default:
      break;
  }
}

void App::applyRequests() {
  const Requests requests = std::exchange(requests_, {});
  if (requests.commit_edit && ui_.edit) {
    const Command command = ui_.edit->command;
    closeEdit();
    apply(command);
  }
  for (const Command& command : requests.commands) apply(command);
  if (requests.undo) undo();
  if (requests.redo) redo();
  if (requests.view) show(*requests.view);
  if (requests.frame_all) frameAll();
  if (requests.orbit_px != Vec2{}) {
    ui_.glide.stop();
    ui_.camera.orbit(requests.orbit_px, pivot());
  }
}

void App::apply(const Command& command) {
  const bool draws = std::holds_alternative<AddPart>(command.step);
  auto next = marrow::apply(document(), command);
  if (!next) {
    if (draws) {
      say(kTooSmall);
    } else {
      say(next.message());
    }
    return;
  }
  if (draws) {
    // A stroke that no part can be made of would be a part that nobody can see or select.
    evaluation_.update(*next);
    const EvaluatedPart& added = evaluation_.parts().back();
    if (!added.part) {
      say("No shape came out of this stroke. Please try once more.");
      document_changed_ = true;
      return;
    }
    ui_.selected = added.source->id;
    meter_.last_part = added.part->timings;
    meter_.last_evaluation_ms = added.part->timings.total_ms;
  }
  const std::string name = describe(document(), command);
  history_.push(std::move(*next), name);
  document_changed_ = true;
}

bool App::undo() {
  if (!history_.canUndo() || tools_.drawing().active()) return false;
  closeEdit();
  history_.undo();
  document_changed_ = true;
  update();
  return true;
}

bool App::redo() {
  if (!history_.canRedo() || tools_.drawing().active()) return false;
  closeEdit();
  history_.redo();
  document_changed_ = true;
  update();
  return true;
}

Result<bool> App::load(const std::string& json) {
  auto document = readDocument(json);
  if (!document) return document.error();
  closeEdit();
  tools_.cancelStroke();
  apply(ReplaceDocument{std::move(*document), "Open"});
  ui_.selected.clear();
  update();
  return true;
}

void App::closeEdit() {
  document_changed_ |= ui_.edit.has_value();
  ui_.edit.reset();
}

void App::update() {
  if (ui_.edit) {
    auto edited = marrow::apply(document(), ui_.edit->command);
    shown_ = edited ? std::move(*edited) : document();
  } else if (document_changed_) {
    shown_ = document();
  } else {
    return;
  }
  document_changed_ = false;
  const double start_ms = clock_();
  evaluation_.update(shown_);
  if (evaluation_.recomputed() == 0) return;
  meter_.last_evaluation_ms = clock_() - start_ms;
  if (ui_.edit) return;
  const EvaluatedPart& last = evaluation_.parts().back();
  if (last.part) meter_.last_part = last.part->timings;
}

void App::updateLivePart() {
  const DrawTool& drawing = tools_.drawing();
  if (!drawing.active() || !drawing.isStroke()) {
    live_.part.reset();
    live_error_ = {};
    live_points_ = 0;
    next_preview_ms_ = 0;
    return;
  }
  if (drawing.points().size() == live_points_ || ui_.glide.running() ||
      ui_.now_ms < next_preview_ms_) {
    return;
  }
  live_points_ = drawing.points().size();
  const double start_ms = clock_();
  auto part = buildPart(drawing.previewPoints(), previewOptions(), clock_);
  const double took_ms = clock_() - start_ms;
  meter_.preview.add(took_ms);
  ++meter_.previews;
  if (meter_.first_preview_ms < 0) meter_.first_preview_ms = took_ms;
  next_preview_ms_ = took_ms > 8 ? ui_.now_ms + took_ms / kPreviewShare : 0;
  if (!part) {
    live_.part.reset();
    live_error_ = part.error();
    return;
  }
  live_error_ = {};
  live_.part = std::make_shared<const Part>(std::move(*part));
  live_.color = partColor(static_cast<size_t>(document().last_part));
  // Ids of the evaluation count up from 1: these never meet them.
  live_.mesh_id = ~meter_.previews;
}

void App::select(Vec2 pixel) {
  const bool had_selection = document().find(ui_.selected).has_value();
  ui_.selected = partAt(pixel, evaluation_.parts(), ui_.camera, ui_.size);
  // Somebody who only clicks has not found out yet that one draws by dragging.
  if (ui_.selected.empty() && !had_selection) say("Hold and drag to draw a closed shape.");
  if (!ui_.narrow()) ui_.open.part = true;
}

void App::say(std::string sentence) { ui_.toast = Toast{std::move(sentence), ui_.now_ms}; }

void App::show(StandardView view) {
  if (tools_.drawing().active()) return;
  const Camera from = ui_.camera;
  ui_.glide.start(from, turnedTo(from, view, pivot()), pivot(), ui_.now_ms);
}

void App::frameAll() {
  if (tools_.drawing().active()) return;
  Camera to = ui_.camera;
  if (scene_.bodies.empty()) {
    to = Camera{};
    to.yaw_rad = ui_.camera.yaw_rad;
    to.pitch_rad = ui_.camera.pitch_rad;
  } else {
    const auto model = [&](Float3 p) { return scene_.camera.target + Vec3{p.x, p.y, p.z}; };
    const double margin_px = ui_.narrow() ? 64 : 100;
    to = framing(ui_.camera, model(scene_.low), model(scene_.high), ui_.size, margin_px);
  }
  ui_.glide.start(ui_.camera, to, pivot(), ui_.now_ms);
}

Vec3 App::pivot() const {
  if (scene_.bodies.empty()) return {};
  const Float3 low = scene_.low, high = scene_.high;
  return scene_.camera.target +
         Vec3{(low.x + high.x) / 2.0, (low.y + high.y) / 2.0, (low.z + high.z) / 2.0};
}

}  // namespace marrow
