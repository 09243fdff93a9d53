#include "keep/pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow {
namespace {

// Seen in full up to the first angle, not at all from the second one on.
constexpr double kFull = 0.9998, kGone = 0.97;  // cosines: 1° and 14°
constexpr double kShareOfCanvas = 0.8;
constexpr size_t kMost = 12;  // pictures of steps that were undone

}  // namespace

std::vector<const Picture*> Pictures::update(const Document& document) {
  std::vector<const Picture*> fresh;
  for (const auto& reference : document.references) {
    if (find(*reference)) continue;
    Picture picture;
    picture.texture = next_++;
    picture.image = reference->image;
    const auto added = pictures_.emplace(picture.texture, std::move(picture)).first;
    fresh.push_back(&added->second);
  }
  for (auto it = pictures_.begin(); it != pictures_.end() && pictures_.size() > kMost;) {
    const bool used =
        std::any_of(document.references.begin(), document.references.end(),
                    [&](const auto& reference) { return reference->image == it->second.image; });
    it = used ? std::next(it) : pictures_.erase(it);
  }
  return fresh;
}

void Pictures::decoded(TextureId texture, Pixels pixels) {
  const auto found = pictures_.find(texture);
  if (found == pictures_.end()) return;
  found->second.pixels = std::make_shared<const Pixels>(std::move(pixels));
}

void Pictures::broken(TextureId texture) {
  const auto found = pictures_.find(texture);
  if (found != pictures_.end()) found->second.broken = true;
}

const Picture* Pictures::find(const Reference& reference) const {
  for (const auto& [texture, picture] : pictures_) {
    if (picture.image == reference.image) return &picture;
  }
  return nullptr;
}

std::vector<Scene::Picture> Pictures::seen(const Document& document, const Camera& camera) const {
  const auto toFloat = [](Vec3 v) {
    return Float3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  std::vector<Scene::Picture> seen;
  for (const auto& reference : document.references) {
    const Picture* picture = find(*reference);
    const double share = presence(reference->view, camera) * reference->opacity;
    if (!picture || !picture->pixels || share <= 0) continue;
    const auto [right, up, back] = axesOf(reference->view);
    const Vec3 center = right * reference->position.x + up * reference->position.y;
    const double half = reference->scale / 2;
    seen.push_back({toFloat(center - camera.target),
                    toFloat(right * (half * picture->pixels->natural_width)),
                    toFloat(up * (half * picture->pixels->natural_height)), picture->texture,
                    static_cast<float>(share)});
  }
  return seen;
}

Reference::View nearestView(const Camera& camera) {
  const Vec3 back = camera.axes()[2];
  const double front = std::abs(back.z), right = std::abs(back.x), top = std::abs(back.y);
  if (front >= right && front >= top) return Reference::View::front;
  return right >= top ? Reference::View::right : Reference::View::top;
}

const char* toString(Reference::View view) {
  switch (view) {
    case Reference::View::front:
      return "front";
    case Reference::View::right:
      return "right";
    case Reference::View::top:
      return "top";
  }
  return "";
}

std::array<Vec3, 3> axesOf(Reference::View view) {
  switch (view) {
    case Reference::View::right:
      return {Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}};
    case Reference::View::top:
      return {Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}};
    case Reference::View::front:
      break;
  }
  return {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
}

double presence(Reference::View view, const Camera& camera) {
  const auto seen = camera.axes(), own = axesOf(view);
  const double turned = std::min(dot(seen[2], own[2]), dot(seen[1], own[1]));
  const double t = std::clamp((turned - kGone) / (kFull - kGone), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

const Reference* referenceIn(const Document& document, Reference::View view) {
  for (const auto& reference : document.references) {
    if (reference->view == view) return reference.get();
  }
  return nullptr;
}

Reference fitted(Reference reference, int width, int height, const Camera& camera, ViewSize size) {
  const auto axes = axesOf(reference.view);
  reference.position = {dot(axes[0], camera.target), dot(axes[1], camera.target)};
  reference.scale = kShareOfCanvas / camera.zoom *
                    std::min(size.width / std::max(width, 1), size.height / std::max(height, 1));
  return reference;
}

}  // namespace marrow
