// Poses: what of them is shown, and the figure that takes them.
#include <algorithm>

#include "app.h"
#include "document/symmetry.h"

namespace marrow {
namespace {

constexpr double kGlide_ms = 240;
constexpr double kBrushStep = 1.2;  // by key

}  // namespace

void App::workMade(uint64_t number, const std::string& bytes) {
  file_.made(number, bytes);
  const bool was_there = figure_.figure() != nullptr;
  figure_.made(number, bytes);
  const auto& figure = figure_.figure();
  if (figure && !was_there && !figure->left_out.empty()) say(figure->left_out.front());
  redraw();
}

void App::workProgress(uint64_t number, double done) {
  file_.progress(number, done);
  figure_.progress(number, done);
  if (ui_.tool == ToolKind::pose || ui_.open.exporting) redraw();
}

void App::workEnded(uint64_t number, const std::string& why) {
  figure_.ended(number, why);
  file_.ended(number, why);
  if (auto file = file_.take()) {
    Job job;
    job.kind = Job::Kind::hand_over;
    job.name = std::move(file->name);
    job.text = std::move(file->bytes);
    shelf_.keeping.ask(std::move(job));
  } else if (number >= FileMaker::kFirstNumber && !file_.failure().empty() && !ui_.open.exporting) {
    say(file_.failure());
  }
  redraw();
}

void App::updateFigure(FrameResult& result) {
  const bool busy = tools_.drawing().active() && ui_.tool != ToolKind::pose;
  const bool posing = ui_.tool == ToolKind::pose;
  const bool awaited = posing || ui_.open.exporting;
  auto order = file_.update(figure_.done() >= 0);
  if (!order && !file_.working()) {
    order = figure_.update(shown_, busy || (ui_.edit && !awaited), awaited, ui_.now_ms);
    result.wake_after_ms = std::min(result.wake_after_ms, figure_.due_ms() - ui_.now_ms);
  }
  if (order) {
    Job job;
    job.kind = Job::Kind::work;
    job.number = order->number;
    job.text = order->request;
    shelf_.keeping.ask(std::move(job));
    result.again = true;
  }
  result.again |= posing && ui_.now_ms - glide_since_ms_ < kGlide_ms;
}

void App::makeFile(const std::string& name) {
  closeEdit();
  update();
  const Exporting& exporting = ui_.exporting;
  FileOptions options = exporting.file;
  options.name = shelf_.keeping.name().empty() ? Keeping::kNoName : shelf_.keeping.name();
  options.metres_per_unit = metresPerUnit(shownBox(evaluation_), exporting.height_m);
  options.skinning = ui_.posing.skinning;
  file_.ask(document(), options, name);
}

/// The pose to be shown once nothing glides any more.
Pose App::wantedPose() const {
  if (hand_.mode() == Hand::Mode::pose) return hand_.posing().pose();
  const auto joints = [&](const std::string& name) {
    const NamedPose* pose = shown_.findPose(name);
    return pose ? pose->joints : Pose{};
  };
  const Pose base = joints(ui_.posing.pose);
  if (!(ui_.posing.amount > 0)) return base;
  return mixed(base, joints(ui_.posing.mix), ui_.posing.amount);
}

void App::updateStance() {
  if (ui_.tool == ToolKind::pose && evaluation_.rig().bones.empty()) {
    useTool(ToolKind::draw);  // there is nothing left to pose
  }
  if (ui_.tool != ToolKind::pose) {
    stance_ = {};
    stance_rig_ = 0;
    shown_pose_.clear();
    wanted_pose_.clear();
    return;
  }
  const Pose wanted = wantedPose();
  const bool by_hand = hand_.mode() == Hand::Mode::pose || ui_.posing.amount != last_amount_;
  last_amount_ = ui_.posing.amount;
  if (wanted != wanted_pose_) {
    if (by_hand) {
      glide_since_ms_ = -1e9;
    } else {
      glide_from_ = shown_pose_;
      glide_since_ms_ = ui_.now_ms;
    }
    wanted_pose_ = wanted;
  }
  const double t = (ui_.now_ms - glide_since_ms_) / kGlide_ms;
  const Pose now = t < 1 ? mixed(glide_from_, wanted_pose_, t * t * (3 - 2 * t)) : wanted_pose_;

  const bool same_rig = stance_rig_ == evaluation_.rigId();
  if (!same_rig) {
    stance_.rest = stance_.posed = evaluation_.rig();
    stance_rig_ = evaluation_.rigId();
  }
  stance_.wanted = wanted_pose_;
  stance_.hidden.assign(stance_.rest.joints.size(), 0);
  for (size_t i = 0; i < stance_.hidden.size(); ++i) {
    const uint32_t part = stance_.rest.joints[i].part;
    if (part >= evaluation_.placed().size()) continue;
    const size_t source = evaluation_.placed()[part].source;
    stance_.hidden[i] = evaluation_.parts()[source].source->visible ? 0 : 1;
  }
  stance_.pins.clear();
  for (const std::string& id : ui_.posing.pins) {
    if (const auto joint = jointOf(stance_.rest, id)) stance_.pins.push_back(*joint);
  }
  if (same_rig && now == shown_pose_) return;
  shown_pose_ = stance_.pose = now;
  const std::vector<Rigid> motions = posed(stance_.rest, now);
  for (size_t i = 0; i < motions.size(); ++i) {
    stance_.posed.joints[i].position = motions[i](stance_.rest.joints[i].position);
  }
}

bool App::takesHold(Vec2 pixel) const {
  if (ui_.tool != ToolKind::pose) return true;
  if (jointToGrab(pixel, stance_, ui_.camera, ui_.size, ui_.touch())) return true;
  if (!paints(ui_.posing) || !figure_.figure()) return false;
  const auto motions =
      motionsOf(*figure_.figure(), stance_.rest, posed(stance_.rest, stance_.pose));
  const SeenFigure seen(figure_.figure(), motions, ui_.posing.skinning, ui_.camera, ui_.size);
  return seen.at(pixel).has_value();
}

void App::chooseJoint(Vec2 pixel) {
  const auto joint = jointToGrab(pixel, stance_, ui_.camera, ui_.size, ui_.touch());
  if (joint) ui_.posing.joint = stance_.rest.joints[*joint].id;
}

// A hand begins with a pose that is meant, not with one on the way.
void App::endPoseGlide() {
  if (ui_.tool != ToolKind::pose) return;
  glide_since_ms_ = -1e9;
  updateStance();
}

// Poses are chosen by name: a name that was changed, or changed back, is followed.
void App::followPoseNames(const Document& before) {
  const auto follow = [&](std::string& name) {
    if (document().findPose(name)) return;
    for (size_t i = 0; i < std::min(before.poses.size(), document().poses.size()); ++i) {
      const NamedPose &was = *before.poses[i], &is = *document().poses[i];
      if (was.name == name && was.joints == is.joints && !before.findPose(is.name)) name = is.name;
    }
  };
  follow(ui_.posing.pose);
  follow(ui_.posing.mix);
  follow(ui_.exporting.file.pose);
}

bool App::posingKey(char character) {
  Posing& posing = ui_.posing;
  switch (character) {
    case 'n':
    case 'N':
      if (posing.joint.empty()) {
        say("Choose a joint first: click it.");
      } else if (posing.pins.erase(posing.joint) == 0) {
        posing.pins.insert(posing.joint);
      }
      return true;
    case 't':
    case 'T':
      posing.turns = !posing.turns;
      return true;
    case 'w':
    case 'W':
      posing.weights = posing.weights == Posing::Weights::hidden ? Posing::Weights::all
                       : posing.weights == Posing::Weights::all  ? Posing::Weights::joint
                                                                 : Posing::Weights::hidden;
      return true;
    case 'g':
    case 'G':
    case 'r':
    case 'R':
      hand_.cancel(ui_);
      document_changed_ = true;
      update();
      endPoseGlide();
      transformByKey(character == 'g' || character == 'G' ? TransformKind::move
                                                          : TransformKind::rotate);
      return true;
    case '[':
    case ']':
      posing.brush_px =
          std::clamp(posing.brush_px * (character == '[' ? 1 / kBrushStep : kBrushStep),
                     Posing::kLeastBrush_px, Posing::kLargestBrush_px);
      return true;
    case 's':
    case 'S':
    case 'x':
    case 'X':
    case 'D':
    case 'h':
      return true;  // parts are not changed while poses are made
    default:
      return false;
  }
}

}  // namespace marrow
