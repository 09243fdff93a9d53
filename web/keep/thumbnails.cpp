#include "keep/thumbnails.h"

#include <algorithm>
#include <utility>

#include "base/box.h"
#include "document/placed_parts.h"
#include "io/document_json.h"

namespace marrow {
namespace {

constexpr double kYaw_rad = 0.42, kPitch_rad = 0.24;
constexpr double kMargin_px = 12;
// Ids of the app's own meshes count up from 1 and down from the largest number.
constexpr uint64_t kFirstMesh = uint64_t{1} << 40;

Float3 relative(Vec3 model, Vec3 target) {
  const Vec3 p = model - target;
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

Scene sceneOf(const Document& document, const std::vector<EvaluatedPart>& parts,
              TextureId texture) {
  Box3 box;
  Scene scene;
  for (const PlacedPart& placed : placedParts(document)) {
    const EvaluatedPart& evaluated = parts[placed.source];
    if (!evaluated.part || !evaluated.source->visible) continue;
    const Color color = evaluated.source->color;
    Scene::Body body;
    body.mesh_id = kFirstMesh * texture + evaluated.meshOf(placed);
    body.part = evaluated.shapeOf(placed);
    body.frame = placed.frame;
    body.color = {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
                  static_cast<float>(color.b) / 255, 1};
    for (const Vec3& position : body.part->mesh.positions) {
      box.include(placed.frame.toWorld(position));
    }
    scene.bodies.push_back(std::move(body));
  }
  scene.size = Thumbnail::kSize;
  if (scene.bodies.empty()) return scene;
  Camera camera;
  camera.yaw_rad = kYaw_rad;
  camera.pitch_rad = kPitch_rad;
  scene.camera = framing(camera, box.low, box.high, scene.size,
                         {kMargin_px, kMargin_px, kMargin_px, kMargin_px});
  scene.low = relative(box.low, scene.camera.target);
  scene.high = relative(box.high, scene.camera.target);
  scene.depth = static_cast<float>(2 * length(box.size()));
  scene.ink_camera = scene.camera;
  return scene;
}

}  // namespace

const Thumbnail* Thumbnails::find(const std::string& key) const {
  const auto found = std::find_if(thumbnails_.begin(), thumbnails_.end(),
                                  [&](const Thumbnail& one) { return one.key == key; });
  return found == thumbnails_.end() ? nullptr : &*found;
}

void Thumbnails::want(const std::string& key, const std::string& text) {
  if (find(key)) return;
  // The oldest ones give way, but none that is being made.
  while (thumbnails_.size() >= kMost && making_.empty()) thumbnails_.pop_front();
  Thumbnail& thumbnail = thumbnails_.emplace_back();
  thumbnail.key = key;
  thumbnail.texture = next_++;
  auto document = readDocument(text);
  if (!document) {
    thumbnail.broken = true;
    return;
  }
  making_.push_back({&thumbnail, std::move(*document), 0, std::make_unique<Evaluation>()});
}

bool Thumbnails::busy() const { return !making_.empty(); }

void Thumbnails::step(Making& making) {
  Document first = making.document;
  making.parts = std::min(making.parts + 1, first.parts.size());
  first.parts.resize(making.parts);
  making.evaluation->update(first);
}

bool Thumbnails::work(double budget_ms) {
  const double start_ms = clock_();
  while (!making_.empty()) {
    Making& making = making_.front();
    step(making);
    if (making.parts == making.document.parts.size()) {
      making.thumbnail->scene =
          sceneOf(making.document, making.evaluation->parts(), making.thumbnail->texture);
      making.thumbnail->ready = true;
      making_.pop_front();
      return true;  // its texture is drawn in this frame
    }
    if (clock_() - start_ms > budget_ms) break;
  }
  return false;
}

}  // namespace marrow
