#include "character/painting.h"

#include <algorithm>
#include <utility>

#include "character/joint_skin.h"

namespace marrow {

Painting::Painting(const Character& character, const Rig& rig)
    : character_(character),
      painter_(character.merged.mesh, rig),
      staying_(character.unpainted),
      shown_(character.unpainted) {
  if (character.meshes.empty() || staying_.empty()) return;
  const std::vector<uint32_t>& merged = character.meshes[0].merged_vertex;
  starts_.assign(staying_.size() + 1, 0);
  for (const uint32_t v : merged) ++starts_[v + 1];
  for (size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
  std::vector<uint32_t> filled(starts_.begin(), starts_.end() - 1);
  doubles_.resize(merged.size());
  for (uint32_t i = 0; i < merged.size(); ++i) doubles_[filled[merged[i]]++] = i;
  skin_.resize(merged.size());
  for (uint32_t v = 0; v < staying_.size(); ++v) show({v}, staying_);
}

void Painting::show(const std::vector<uint32_t>& vertices,
                    const std::vector<JointWeights>& weights) {
  for (const uint32_t v : vertices) {
    const VertexSkin skin = skinOf(weights[v]);
    for (uint32_t i = starts_[v]; i < starts_[v + 1]; ++i) skin_[doubles_[i]] = skin;
  }
}

void Painting::set(std::vector<PlacedWeightStroke> strokes) {
  if (skin_.empty()) return;
  with(nullptr);
  size_t first = strokes_.size();
  const bool more = strokes.size() >= strokes_.size() &&
                    std::equal(strokes_.begin(), strokes_.end(), strokes.begin());
  std::vector<char> changed(staying_.size(), 0);
  if (!more) {
    std::fill(changed.begin(), changed.end(), 1);
    staying_ = character_.unpainted;
    first = 0;
  }
  for (size_t i = first; i < strokes.size(); ++i) {
    for (const uint32_t v : painter_.paint(strokes[i], staying_)) changed[v] = 1;
  }
  strokes_ = std::move(strokes);
  for (uint32_t v = 0; v < changed.size(); ++v) {
    if (!changed[v]) continue;
    shown_[v] = staying_[v];
    show({v}, staying_);
  }
}

const std::vector<VertexSkin>& Painting::with(const PlacedWeightStroke* stroke) {
  if (skin_.empty()) return skin_;
  for (const uint32_t v : on_top_) shown_[v] = staying_[v];
  show(on_top_, staying_);
  on_top_.clear();
  if (!stroke) return skin_;
  on_top_ = painter_.paint(*stroke, shown_);
  show(on_top_, shown_);
  return skin_;
}

}  // namespace marrow
