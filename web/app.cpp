#include "app.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "document/symmetry.h"
#include "io/document_json.h"
#include "pick.h"

namespace marrow {
namespace {

constexpr int kSettleFrames = 3;
// The live preview may take this share of the time while a stroke is under way.
constexpr double kPreviewShare = 0.6;
// So near to a bone a click means the bone.
constexpr double kBoneReach_px = 7, kBoneTouch_px = 16;
// A stroke shorter than this on the screen was no stroke.
constexpr double kShortestStroke_px = 20;
// A second click so soon belongs to the first one.
constexpr double kDoubleClick_ms = 700;
constexpr const char* kAlone =
    "This part touches nothing, so it has a skeleton of its own. Move it until it touches, or "
    "attach it in its panel.";
constexpr const char* kNoBoneToPaint = "Click the joint at the end of the bone to paint for.";
constexpr const char* kNoSkinToPaint = "The skin is being fitted: it can be painted in a moment.";
constexpr const char* kTooSmall =
    "That was too small to become a shape. Draw a closed shape, a little larger.";

bool isFileKey(Key key) { return key == Key::open || key == Key::save || key == Key::save_as; }

bool isButton(const InputEvent& event) {
  const auto* pointer = std::get_if<PointerEvent>(&event);
  return pointer &&
         (pointer->type == PointerEvent::Type::down || pointer->type == PointerEvent::Type::up ||
          pointer->type == PointerEvent::Type::cancel);
}

}  // namespace

App::App(Clock clock) : clock_(clock), evaluation_({}, clock), shelf_(clock) {}

void App::resize(ViewSize size, double dpr) {
  const bool was_narrow = ui_.narrow();
  ui_.size = size;
  ui_.dpr = dpr;
  if (ui_.narrow() && (!was_narrow || scene_.bodies.empty())) {
    ui_.open = PanelsOpen{false, false, false, false, false};
  } else if (was_narrow && !ui_.narrow()) {
    ui_.open = PanelsOpen{};
  }
  panels_.setDensity(dpr);
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
  updateStance();

  const bool shows_plane = ui_.tool == ToolKind::line && !shown_.parts.empty();
  scene_ = buildScene(evaluation_, rig(), live_, tools_.drawing(), hand_,
                      shows_plane ? symmetryPlane(shown_) : std::nullopt, stance_, figure_, ui_);
  scene_.pictures = shelf_.pictures.seen(shown_, ui_.camera);
  const PanelInput input{
      history_, shown_,  evaluation_, rig(),
      live_,    hand_,   meter_,      shelf_,
      stance_,  figure_, file_,       tools_.drawing().active() && tools_.drawing().isStroke()};
  requests_ = panels_.frame(input, ui_);
  requests_.frame_all |= std::exchange(frame_all_next_, false);
  makeRoom();

  FrameResult result;
  const uint64_t fingerprints[] = {fingerprint(scene_), panels_.fingerprint()};
  const uint64_t now = fingerprint(fingerprints, sizeof fingerprints, 1);
  result.draw = now != drawn_fingerprint_;
  drawn_fingerprint_ = now;
  frames_drawn_ += result.draw ? 1 : 0;
  if (frames_to_settle_ > 0) --frames_to_settle_;
  result.again = frames_to_settle_ > 0 || requests_.again || requests_.undo || requests_.redo ||
                 requests_.frame_all || requests_.view || requests_.commit_edit || requests_.key ||
                 requests_.orbit_px != Vec2{} || !requests_.commands.empty() ||
                 !requests_.files.empty() || !input_.empty() || ui_.glide.running() ||
                 requests_.wake_after_ms <= 0;
  result.wake_after_ms = requests_.wake_after_ms;
  updateShelf(result);
  updateFigure(result);
  if (hand_.mode() == Hand::Mode::stroke && live_points_ != tools_.drawing().points().size()) {
    result.wake_after_ms = std::min(result.wake_after_ms, next_preview_ms_ - now_ms);
  }
  return result;
}

void App::redraw() {
  drawn_fingerprint_ = 0;
  frames_to_settle_ = kSettleFrames;
}

void App::takeInput() {
  // The panels see where a pointer is and whether it is down once a frame: what comes after a
  // change waits for the next one, and letting go waits for the way there.
  bool panels_busy = false, panels_moved = false, panels_read = false, panels_key = false;
  while (!input_.empty()) {
    const InputEvent event = input_.front();
    const auto* pointer = std::get_if<PointerEvent>(&event);
    if (pointer && (panels_busy || (panels_moved && pointer->type == PointerEvent::Type::up)))
      break;
    const bool pressed = pointer && pointer->type == PointerEvent::Type::down;
    const auto* key = std::get_if<KeyEvent>(&event);
    // In one frame a field would take letters before keys, whichever came first.
    if (panels_key && std::holds_alternative<TextEvent>(event)) break;
    if (panels_read && (pressed || (key && isFileKey(key->key))))
      break;  // not before the last letter
    if (key && isFileKey(key->key) && panels_.wantsText()) {
      panels_.letGoOfText();  // files have to do with the name that is being typed
      break;
    }
    input_.pop_front();
    if (pointer) {
      const bool to_panels = handle(*pointer);
      panels_busy = to_panels && isButton(*pointer);
      panels_moved |= to_panels;
    } else if (key) {
      panels_key |= panels_.wantsText();
      handle(*key);
    } else if (const auto* wheel = std::get_if<WheelEvent>(&event)) {
      if (panels_.panelAt(wheel->position_px)) {
        panels_.wheel(*wheel);
      } else {
        tools_.wheel(*wheel, ui_);
      }
    } else if (const auto* text = std::get_if<TextEvent>(&event)) {
      if (!panels_.wantsText()) continue;
      panels_.text(*text);
      panels_read = true;
    }
  }
  tools_.settle(ui_, pivot());
}

bool App::handle(const PointerEvent& event) {
  pointer_px_ = event.position_px;
  if (followKey(event)) return false;
  if (event.type == PointerEvent::Type::down) shift_ = event.shift;
  const auto takes = [this](Vec2 pixel) { return takesHold(pixel); };
  const Surroundings around{[this](Vec2 pixel) { return panels_.panelAt(pixel); }, pivot(), takes};
  const bool was_stroke = tools_.drawing().active() && tools_.drawing().isStroke();
  const Tools::Outcome outcome = tools_.pointer(event, ui_, around);
  if (outcome.to_panels) panels_.pointer(event);
  // A press on the canvas takes the keyboard away from text, however short it is.
  if (!outcome.to_panels && event.type == PointerEvent::Type::down) panels_.letGoOfText();
  if (!was_stroke && tools_.drawing().active() && tools_.drawing().isStroke()) {
    meter_.preview.restart();
  }
  switch (outcome.gesture) {
    case Tools::Gesture::none:
      break;
    case Tools::Gesture::begin:
      closeEdit();
      forgetWhatIsGone();
      endPoseGlide();
      hand_.begin(tools_.drawing(), shift_, ui_, world());
      if (ui_.tool == ToolKind::pose && paints(ui_.posing) && hand_.mode() == Hand::Mode::idle) {
        say(figure_.figure() ? kNoBoneToPaint : kNoSkinToPaint);
      }
      break;
    case Tools::Gesture::move:
      hand_.move(tools_.drawing(), ui_, world());
      break;
    case Tools::Gesture::end:
      if (hand_.mode() == Hand::Mode::stroke) {
        finishStroke();
      } else {
        const auto command = hand_.end(tools_.drawing(), ui_, world());
        tools_.takePoints();
        closeEdit();
        if (command) apply(*command);
      }
      break;
    case Tools::Gesture::click:
      hand_.cancel(ui_);
      click(event.position_px, event.shift || shift_);
      break;
    case Tools::Gesture::cancel:
      hand_.cancel(ui_);
      break;
  }
  document_changed_ |= outcome.gesture != Tools::Gesture::none;
  return outcome.to_panels;
}

// While a transformation follows the pointer without a button, a click ends it: the first button
// keeps it, any other gives it up.
bool App::followKey(const PointerEvent& event) {
  if (swallow_up_ && event.type == PointerEvent::Type::up) {
    swallow_up_ = false;
    return true;
  }
  if (!hand_.followsKey()) return false;
  if (event.type == PointerEvent::Type::move) {
    hand_.follow(event.position_px, ui_);
  } else if (event.type == PointerEvent::Type::down) {
    swallow_up_ = true;
    if (event.button != Button::primary) {
      hand_.cancel(ui_);
      document_changed_ = true;
    } else if (const auto command = hand_.finishByKey(ui_)) {
      apply(*command);
    }
  }
  return true;
}

void App::finishStroke() {
  const StrokePlace place = hand_.place();
  const bool too_small = tools_.drawing().travelled_px() < kShortestStroke_px;
  hand_.cancel(ui_);
  std::vector<Vec2> points = tools_.takePoints();
  if (too_small) {
    say(kTooSmall);
    return;
  }
  StrokePlace::Place found = place.at(points);
  if (found.completed) points = std::move(found.stroke);
  apply(AddPart{std::move(points), found.frame, found.mirror});
}

void App::applyRequests() {
  const Requests requests = std::exchange(requests_, {});
  if (requests.reset) closeEdit();
  const Document* before = &document();
  const bool click_before = let_go_ms_ >= 0 && ui_.now_ms - let_go_ms_ < kDoubleClick_ms;
  if (requests.commit_edit && ui_.edit) {
    const Command command = ui_.edit->command;
    closeEdit();
    apply(command);
    if (&document() != before) let_go_ms_ = ui_.now_ms;
  }
  for (const Command& command : requests.commands) apply(command);
  if (requests.reset && click_before && &document() != before) joinLastSteps();
  for (const FileAction& action : requests.files) act(action);
  if (requests.key) handleCharacter(requests.key);
  if (requests.undo) undo();
  if (requests.redo) redo();
  if (requests.view) show(*requests.view);
  if (requests.frame_all) frameAll();
  if (requests.orbit_px != Vec2{}) {
    ui_.glide.stop();
    ui_.camera.orbit(requests.orbit_px, pivot());
  }
}

// The first click of a double click has moved the slider: one step for both.
void App::joinLastSteps() {
  Document last = document();
  const std::string name = history_.undoName();
  history_.undo();
  history_.undo();
  history_.push(std::move(last), name);
}

void App::apply(const Command& command) {
  const bool draws = std::holds_alternative<AddPart>(command.step);
  const bool adds = draws || std::holds_alternative<ImportPart>(command.step);
  auto next = marrow::apply(document(), command);
  if (!next) {
    if (draws) {
      say(kTooSmall);
    } else {
      say(next.message());
    }
    return;
  }
  if (adds) {
    // A stroke that no part can be made of would be a part that nobody can see or select.
    evaluation_.update(*next);
    const EvaluatedPart& added = evaluation_.parts().back();
    if (!added.part) {
      say(draws ? "No shape came out of this stroke. Please try once more."
                : "No skeleton came out of this shape. Please try it from another side.");
      document_changed_ = true;
      return;
    }
    ui_.selection.set(added.source->id);
    if (next->parts.size() > 1 && !hangsTogether(added.source->id)) say(kAlone);
    meter_.last_part = added.part->timings;
    meter_.last_evaluation_ms = added.part->timings.total_ms;
  }
  const std::string name = describe(document(), command);
  let_go_ms_ = -1;
  const Document before = document();
  history_.push(std::move(*next), name);
  followPoseNames(before);
  document_changed_ = true;
}

bool App::hangsTogether(const std::string& id) const {
  const auto& placed = evaluation_.placed();
  const auto& connections = evaluation_.rig().connections;
  return std::any_of(connections.begin(), connections.end(), [&](const Connection& connection) {
    return placed[connection.child].id == id || placed[connection.parent].id == id;
  });
}

bool App::undo() {
  if (!history_.canUndo() || tools_.drawing().active()) return false;
  hand_.cancel(ui_);
  closeEdit();
  let_go_ms_ = -1;
  const Document before = document();
  history_.undo();
  followPoseNames(before);
  document_changed_ = true;
  update();
  return true;
}

bool App::redo() {
  if (!history_.canRedo() || tools_.drawing().active()) return false;
  hand_.cancel(ui_);
  closeEdit();
  let_go_ms_ = -1;
  const Document before = document();
  history_.redo();
  followPoseNames(before);
  document_changed_ = true;
  update();
  return true;
}

Result<bool> App::load(const std::string& json) {
  auto document = readDocument(json);
  if (!document) return document.error();
  replace(std::move(*document), {}, "Open");
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
  const uint64_t rig_before = evaluation_.rigId();
  evaluation_.update(shown_);
  const double took_ms = clock_() - start_ms;
  figure_.see(shown_, evaluation_, ui_.now_ms);
  if (evaluation_.recomputed() == 0 && evaluation_.rigId() == rig_before) return;
  meter_.last_evaluation_ms = took_ms;
  if (evaluation_.recomputed() == 0 || ui_.edit) return;
  const EvaluatedPart& last = evaluation_.parts().back();
  if (last.part) meter_.last_part = last.part->timings;
}

void App::forgetWhatIsGone() {
  const auto& placed = evaluation_.placed();
  auto& ids = ui_.selection.ids;
  const auto isGone = [&](const std::string& id) { return !findPlaced(placed, id); };
  ids.erase(std::remove_if(ids.begin(), ids.end(), isGone), ids.end());
  if (ids.size() != 1) ui_.selection.branch.clear();
}

void App::updateLivePart() {
  const DrawTool& drawing = tools_.drawing();
  if (hand_.mode() != Hand::Mode::stroke || !drawing.active() || !drawing.isStroke()) {
    live_ = {};
    live_rig_.reset();
    live_error_ = {};
    live_points_ = 0;
    next_preview_ms_ = 0;
    return;
  }
  if (drawing.points().size() == live_points_ || ui_.now_ms < next_preview_ms_) return;
  live_points_ = drawing.points().size();
  const double start_ms = clock_();
  std::vector<Vec2> points = drawing.previewPoints();
  StrokePlace::Place place = hand_.place().at(points);
  if (place.completed) points = std::move(place.stroke);
  auto part = buildPart(points, previewOptions(), clock_);
  live_ = {};
  live_rig_.reset();
  live_error_ = part ? Error{} : part.error();
  live_.source.frame = place.frame;
  live_.source.mirror = place.mirror;
  live_.placed.push_back({"live", evaluation_.parts().size(), false, place.frame});
  if (place.mirror) {
    live_.placed.push_back({std::string("live") + kTwinSuffix, evaluation_.parts().size(), true,
                            mirrored(place.frame, *place.mirror)});
  }
  if (part) {
    live_.part = std::make_shared<const Part>(std::move(*part));
    live_.source.id = "live";
    live_.source.name = "new part";
    live_.source.color = partColor(static_cast<size_t>(document().last_part));
    // Ids of the evaluation count up from 1: these never meet them.
    live_.mesh_id = ~(meter_.previews + 1);
    std::vector<RigPart> parts = evaluation_.rigParts();
    for (const PlacedPart& placed : live_.placed) {
      parts.push_back({&placed, &live_.source, live_.part.get()});
    }
    live_rig_ = makeRig(parts, document().refine);
  }
  const double took_ms = clock_() - start_ms;
  meter_.preview.add(took_ms);
  ++meter_.previews;
  if (meter_.first_preview_ms < 0) meter_.first_preview_ms = took_ms;
  next_preview_ms_ = took_ms > 8 ? ui_.now_ms + took_ms / kPreviewShare : 0;
}

std::optional<size_t> App::boneUnder(Vec2 pixel) const {
  const double reach_px = ui_.touch() ? kBoneTouch_px : kBoneReach_px;
  return boneAt(pixel, evaluation_, ui_.camera, ui_.size, reach_px);
}

// Where the bones or the surface of another part lie under the pixel.
void App::attachAt(Vec2 pixel) {
  ui_.attaching = false;
  const std::string child = sourceId(ui_.selection.primary());
  const Rig& rig = evaluation_.rig();
  std::optional<size_t> on;
  Vec3 place;
  if (const auto joint = boneUnder(pixel)) {
    const Rig::Joint& end = rig.joints[*joint];
    const Vec3 start =
        end.parent < 0 ? end.position : rig.joints[static_cast<size_t>(end.parent)].position;
    const Vec2 a = ui_.camera.toScreen(start, ui_.size);
    const Vec2 way = ui_.camera.toScreen(end.position, ui_.size) - a;
    const double along = dot(way, way) > 0 ? dot(pixel - a, way) / dot(way, way) : 0;
    on = end.part;
    place = lerp(start, end.position, std::clamp(along, 0.0, 1.0));
  }
  const auto isChild = [&](size_t placed) {
    return sourceId(evaluation_.placed()[placed].id) == child;
  };
  if (!on || isChild(*on)) {
    if (const auto hit = surfaceAt(pixel, evaluation_, ui_.camera, ui_.size)) {
      on = hit->placed;
      place = hit->position;
    }
  }
  if (!on || isChild(*on)) {
    say("There is no other part. Press \xE2\x80\x9C"
        "Attach to\xE2\x80\x9D and try again.");
    return;
  }
  const PlacedPart& parent = evaluation_.placed()[*on];
  const Vec3 at = parent.frame.toLocal(place);
  apply(SetAttachment{child, Attachment{parent.id, {at.x, at.y}}});
}

void App::click(Vec2 pixel, bool shift) {
  if (ui_.attaching) {
    attachAt(pixel);
    return;
  }
  if (ui_.tool == ToolKind::pose) {
    chooseJoint(pixel);
    return;
  }
  if (ui_.start_button && ui_.start_button->has(pixel)) {
    ui_.openOnly(&PanelsOpen::gallery);
    return;
  }
  const bool had_selection = !ui_.selection.empty();
  std::string id, branch;
  if (ui_.show.bones) {
    if (const auto joint = boneUnder(pixel)) {
      id = evaluation_.placed()[evaluation_.rig().joints[*joint].part].id;
      branch = branchKey(evaluation_.rig().joints[*joint].branch);
    }
  }
  if (id.empty()) {
    if (const auto hit = surfaceAt(pixel, evaluation_, ui_.camera, ui_.size)) {
      const PlacedPart& placed = evaluation_.placed()[hit->placed];
      if (!evaluation_.parts()[placed.source].source->locked) id = placed.id;
    }
  }
  if (shift && !id.empty()) {
    ui_.selection.toggle(id);
  } else if (!shift) {
    ui_.selection.set(id);
    ui_.selection.branch = branch;
  }
  // Somebody who only clicks has not found out yet that one draws by dragging.
  if (id.empty() && !had_selection && ui_.tool == ToolKind::draw) {
    say("Hold and drag to draw a closed shape.");
  }
  if (!ui_.narrow()) ui_.open.part = true;
}

void App::say(std::string sentence) { ui_.toast = Toast{std::move(sentence), ui_.now_ms}; }

}  // namespace marrow
