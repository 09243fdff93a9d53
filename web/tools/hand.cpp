#include "tools/hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pick.h"

namespace marrow {
namespace {

constexpr double kShortestLine_px = 20;
constexpr double kNearlyStraight = 0.12;  // tangent of the angle to level or upright

}  // namespace

std::vector<std::string> changeable(const Selection& selection, const Evaluation& evaluation) {
  std::vector<std::string> ids;
  for (const std::string& id : selection.ids) {
    const PlacedPart* placed = findPlaced(evaluation.placed(), id);
    if (!placed) continue;
    const PartSource& source = *evaluation.parts()[placed->source].source;
    if (!source.locked && source.visible) ids.push_back(id);
  }
  return ids;
}

std::optional<Vec3> selectionPivot(const Selection& selection, const Evaluation& evaluation) {
  Vec3 sum;
  int count = 0;
  for (const std::string& id : selection.ids) {
    const PlacedPart* placed = findPlaced(evaluation.placed(), id);
    if (!placed) continue;
    sum = sum + middleOf(evaluation.parts()[placed->source], placed->frame);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::optional<Plane> planeOverLine(Vec2 a_px, Vec2 b_px, const Camera& camera, ViewSize size) {
  Vec2 along{b_px.x - a_px.x, a_px.y - b_px.y};
  if (length(along) < kShortestLine_px) return std::nullopt;
  if (std::abs(along.x) < kNearlyStraight * std::abs(along.y)) along.x = 0;
  if (std::abs(along.y) < kNearlyStraight * std::abs(along.x)) along.y = 0;
  along = along / length(along);
  const auto [right, up, back] = camera.axes();
  Vec3 normal = right * along.y - up * along.x;
  const double largest = std::max({normal.x, normal.y, normal.z});
  if (largest < -std::min({normal.x, normal.y, normal.z})) normal = -normal;
  const Vec3 through = camera.underPixel((a_px + b_px) / 2, size);
  return Plane{normal, -dot(normal, through)};
}

void Hand::begin(const DrawTool& gesture, bool shift, UiState& ui, const World& world) {
  cancel(ui);
  shift_ = shift;
  pressed_.clear();
  from_px_ = to_px_ = gesture.first_px();
  switch (ui.tool) {
    case ToolKind::draw: {
      mode_ = Mode::stroke;
      const auto pivot = selectionPivot(ui.selection, world.evaluation);
      const bool through_selected = (ui.through_selected || shift) && pivot;
      place_.begin(from_px_, gesture.camera(), world.document, world.evaluation, ui,
                   through_selected ? *pivot : world.ground, through_selected);
      break;
    }
    case ToolKind::select: {
      const auto ids = changeable(ui.selection, world.evaluation);
      const auto pivot = selectionPivot(ui.selection, world.evaluation);
      if (pivot && !ids.empty()) {
        const Gizmo gizmo = layOutGizmo(*pivot, ui.camera, ui.size, ui.touch());
        if (const auto handle = handleAt(gizmo, from_px_, ui.touch())) {
          transform_.begin(handle->kind, handle->axis, ids, *pivot, from_px_, ui.camera, ui.size,
                           false);
          mode_ = Mode::transform;
          break;
        }
      }
      mode_ = Mode::box;
      if (const auto hit = surfaceAt(from_px_, world.evaluation, ui.camera, ui.size)) {
        const PlacedPart& placed = world.evaluation.placed()[hit->placed];
        if (!world.evaluation.parts()[placed.source].source->locked) pressed_ = placed.id;
      }
      break;
    }
    case ToolKind::redraw:
    case ToolKind::reshape: {
      const PlacedPart* placed = findPlaced(world.evaluation.placed(), ui.selection.primary());
      if (!placed) break;
      const EvaluatedPart& evaluated = world.evaluation.parts()[placed->source];
      if (evaluated.source->locked || !evaluated.source->visible) break;
      if (contour_.begin(from_px_, *placed, evaluated, ui.camera, ui.size,
                         ui.tool == ToolKind::reshape, ui.touch())) {
        mode_ = Mode::contour;
      }
      break;
    }
    case ToolKind::line:
      mode_ = Mode::line;
      break;
    case ToolKind::pose: {
      const Stance& stance = world.stance;
      if (paints(ui.posing)) {
        if (beginBrush(ui, world)) mode_ = Mode::brush;
        break;
      }
      const auto joint = jointToGrab(from_px_, stance, ui.camera, ui.size, ui.touch());
      if (!joint) break;
      const auto way = ui.posing.turns ? PoseTool::Way::turn : PoseTool::Way::pull;
      beginPose(ui, world);
      pose_.begin(stance, *joint, way, from_px_, ui.camera, ui.size);
      ui.posing.joint = stance.rest.joints[*joint].id;
      mode_ = Mode::pose;
      break;
    }
  }
}

void Hand::move(const DrawTool& gesture, UiState& ui, const World& world) {
  to_px_ = gesture.last_px();
  if (!gesture.isStroke()) return;
  if (mode_ == Mode::box && !pressed_.empty() && !shift_) {
    if (!ui.selection.has(pressed_)) ui.selection.set(pressed_);
    const auto pivot = selectionPivot(ui.selection, world.evaluation);
    transform_.begin(TransformKind::move, TransformAxis::none,
                     changeable(ui.selection, world.evaluation), pivot.value_or(Vec3{}), from_px_,
                     ui.camera, ui.size, false);
    mode_ = Mode::transform;
  }
  if (mode_ == Mode::transform) {
    transform_.move(to_px_);
    showTransform(ui);
  } else if (mode_ == Mode::pose) {
    pose_.move(to_px_);
    showPose(ui);
  } else if (mode_ == Mode::brush) {
    brush_.move(to_px_);
    if (auto command = brush_.command()) ui.edit = PendingEdit{std::move(*command)};
  } else if (mode_ == Mode::contour) {
    contour_.move(to_px_);
    ui.edit.reset();
    if (auto command = contour_.command()) ui.edit = PendingEdit{std::move(*command)};
  }
}

std::optional<Command> Hand::end(const DrawTool& gesture, UiState& ui, const World& world) {
  move(gesture, ui, world);
  const Mode mode = std::exchange(mode_, Mode::idle);
  switch (mode) {
    case Mode::transform:
      transform_.end();
      if (transform_.changed()) return transform_.command();
      break;
    case Mode::contour:
      contour_.end();
      if (auto command = contour_.command()) return *command;
      break;
    case Mode::pose:
      pose_.end();
      if (pose_.changed()) return poseCommand(ui);
      break;
    case Mode::brush:
      brush_.end();
      if (auto command = brush_.command()) return *command;
      break;
    case Mode::box: {
      if (!shift_) ui.selection.clear();
      for (std::string& id : partsInBox(from_px_, to_px_, world.evaluation, ui.camera, ui.size)) {
        if (!ui.selection.has(id)) ui.selection.ids.push_back(std::move(id));
      }
      break;
    }
    case Mode::line:
      if (const auto plane = planeOverLine(from_px_, to_px_, ui.camera, ui.size)) {
        ui.symmetry = true;
        ui.tool = ToolKind::draw;
        return SetSymmetry{plane};
      }
      break;
    case Mode::stroke:
    case Mode::idle:
      break;
  }
  return std::nullopt;
}

void Hand::cancel(UiState& ui) {
  const bool edits = mode_ == Mode::transform || mode_ == Mode::contour || mode_ == Mode::pose ||
                     mode_ == Mode::brush;
  if (edits) ui.edit.reset();
  if (mode_ == Mode::pose && pose_.changed() && !fresh_pose_.empty()) {
    ui.posing.pose = pose_before_;
    ui.posing.amount = amount_before_;
  }
  brush_.end();
  transform_.end();
  pose_.end();
  contour_.end();
  mode_ = Mode::idle;
}

// What a hand changes is a pose of its own: never the rest, and not what two are mixed from.
void Hand::beginPose(const UiState& ui, const World& world) {
  const bool changes = world.document.findPose(ui.posing.pose) && !(ui.posing.amount > 0);
  fresh_pose_ = changes ? std::string() : freshPoseName(world.document);
  pose_before_ = ui.posing.pose;
  amount_before_ = ui.posing.amount;
}

bool Hand::beginBrush(const UiState& ui, const World& world) {
  const Stance& stance = world.stance;
  const auto& joints = stance.rest.joints;
  const bool smooths = ui.posing.brush == WeightStroke::Kind::smooth;
  const auto chosen = jointOf(stance.rest, ui.posing.joint);
  if (!world.figure || (!chosen && !smooths)) return false;
  BrushTool::Brush brush;
  brush.kind = *ui.posing.brush;
  if (!smooths) brush.joint = joints[boneOf(stance.rest, *chosen)].id;
  brush.radius = ui.posing.brush_px / ui.camera.zoom;
  brush.strength = ui.posing.brush_strength;
  const auto motions = motionsOf(*world.figure, stance.rest, posed(stance.rest, stance.pose));
  return brush_.begin({world.figure, motions, ui.posing.skinning, ui.camera, ui.size}, brush,
                      from_px_, world.document, stance.rest);
}

bool Hand::beginByKey(TransformKind kind, Vec2 pointer_px, UiState& ui, const World& world) {
  if (ui.tool == ToolKind::pose) {
    const auto chosen = jointOf(world.stance.rest, ui.posing.joint);
    if (!chosen || kind == TransformKind::scale) return false;
    beginPose(ui, world);
    pose_.beginByKey(world.stance, *chosen, kind, pointer_px, ui.camera, ui.size);
    mode_ = Mode::pose;
    return true;
  }
  const auto ids = changeable(ui.selection, world.evaluation);
  const auto pivot = selectionPivot(ui.selection, world.evaluation);
  if (ids.empty() || !pivot) return false;
  transform_.begin(kind, TransformAxis::none, ids, *pivot, pointer_px, ui.camera, ui.size, true);
  mode_ = Mode::transform;
  return true;
}

void Hand::follow(Vec2 pointer_px, UiState& ui) {
  if (mode_ == Mode::pose) {
    pose_.move(pointer_px);
    showPose(ui);
    return;
  }
  transform_.move(pointer_px);
  showTransform(ui);
}

bool Hand::key(char character, UiState& ui) {
  if (mode_ == Mode::pose && pose_.key(character)) {
    showPose(ui);
    return true;
  }
  if (mode_ != Mode::transform || !transform_.key(character)) return false;
  showTransform(ui);
  return true;
}

std::optional<Command> Hand::finishByKey(UiState& ui) {
  const Mode mode = std::exchange(mode_, Mode::idle);
  ui.edit.reset();
  if (mode == Mode::pose) {
    pose_.end();
    if (!pose_.changed()) return std::nullopt;
    return poseCommand(ui);
  }
  transform_.end();
  if (!transform_.changed()) return std::nullopt;
  return transform_.command();
}

Command Hand::poseCommand(const UiState& ui) const {
  return SetPose{ui.posing.pose, withoutResting(pose_.pose())};
}

void Hand::showPose(UiState& ui) {
  if (!pose_.changed()) return;
  if (!fresh_pose_.empty()) {
    ui.posing.pose = fresh_pose_;
    ui.posing.amount = 0;
  }
  ui.edit = PendingEdit{poseCommand(ui)};
}

void Hand::showTransform(UiState& ui) {
  if (transform_.changed()) ui.edit = PendingEdit{transform_.command()};
}

}  // namespace marrow
