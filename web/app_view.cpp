// How the model is looked at: standard views, all of it, and beside the panels.
#include <algorithm>

#include "app.h"
#include "panels/layout.h"

namespace marrow {
namespace {

constexpr double kBeside_px = 16;      // between the model and a panel
constexpr double kLeastRoom_px = 120;  // for the model between panels

}  // namespace

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
    const auto [low, high] = modelBox();
    const Camera whole = framing(ui_.camera, low, high, ui_.size, frameInsets({}));
    to = framing(ui_.camera, low, high, ui_.size, frameInsets(panels_.covered(ui_, false)));
    if (room_) *room_ = {whole, to, room_->covered};
  }
  ui_.glide.start(ui_.camera, to, pivot(), ui_.now_ms);
}

// Panels count where they leave enough between them.
Insets App::frameInsets(const Insets& covered) const {
  const double margin_px = ui_.narrow() ? 64 : 100;
  const auto both = [&](double& a, double& b, double side) {
    const double wanted_a = std::max(a + kBeside_px, margin_px);
    const double wanted_b = std::max(b + kBeside_px, margin_px);
    const bool fits = side - wanted_a - wanted_b >= kLeastRoom_px;
    a = fits ? wanted_a : margin_px;
    b = fits ? wanted_b : margin_px;
  };
  Insets insets = covered;
  both(insets.left, insets.right, ui_.size.width);
  both(insets.top, insets.bottom, ui_.size.height);
  return insets;
}

// A sheet would cover the model that it changes: the model moves beside it, and back
// again, unless the user looks elsewhere meanwhile.
void App::makeRoom() {
  if (tools_.drawing().active() || hand_.mode() != Hand::Mode::idle || ui_.edit) return;
  const Insets covered = panels_.covered(ui_, true);
  const Camera now = ui_.glide.running() ? ui_.glide.destination() : ui_.camera;
  const bool untouched = room_ && now == room_->beside;
  const auto glide = [&](const Camera& to) {
    if (!(to == now)) ui_.glide.start(ui_.camera, to, pivot(), ui_.now_ms);
  };
  if (covered == Insets{} || scene_.bodies.empty()) {
    if (untouched) glide(room_->before);
    room_.reset();
    return;
  }
  if (room_ && (!untouched || covered == room_->covered)) return;
  const Camera before = room_ ? room_->before : now;
  // The bars of a narrow canvas reach from side to side.
  const double bar_px = ui_.narrow() ? barHeight(ui_) + 2 * margin(ui_) : 0;
  const Insets all = panels_.covered(ui_, false);
  const Insets insets{std::max(all.left, covered.left) + margin(ui_), bar_px,
                      covered.right + margin(ui_), std::max(covered.bottom + margin(ui_), bar_px)};
  const auto [low, high] = modelBox();
  room_ = Room{before, makingRoom(before, low, high, ui_.size, insets), covered};
  glide(room_->beside);
}

std::pair<Vec3, Vec3> App::modelBox() const {
  const auto model = [&](Float3 p) { return scene_.camera.target + Vec3{p.x, p.y, p.z}; };
  return {model(scene_.low), model(scene_.high)};
}

Vec3 App::ground() const {
  if (scene_.bodies.empty()) return {};
  const Vec3 middle = pivot();
  return {middle.x, scene_.camera.target.y + scene_.low.y, middle.z};
}

Vec3 App::pivot() const {
  if (scene_.bodies.empty()) return {};
  const Float3 low = scene_.low, high = scene_.high;
  return scene_.camera.target +
         Vec3{(low.x + high.x) / 2.0, (low.y + high.y) / 2.0, (low.z + high.z) / 2.0};
}

}  // namespace marrow
