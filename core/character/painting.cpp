#include "character/painting.h"

#include <algorithm>
#include <utility>

#include "character/joint_skin.h"

namespace marrow {
namespace {

constexpr size_t kMostCovered = 4;  // × the vertices: what is kept of what was painted over

}  // namespace

Painting::Painting(const Character& character, const Rig& rig)
    : character_(character), painter_(character.merged.mesh, rig) {
  if (character.meshes.empty() || character.unpainted.empty()) return;
  const std::vector<uint32_t>& merged = character.meshes[0].merged_vertex;
  starts_.assign(character.unpainted.size() + 1, 0);
  for (const uint32_t v : merged) ++starts_[v + 1];
  for (size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
  std::vector<uint32_t> filled(starts_.begin(), starts_.end() - 1);
  doubles_.resize(merged.size());
  for (uint32_t i = 0; i < merged.size(); ++i) doubles_[filled[merged[i]]++] = i;
  skin_.resize(merged.size());
  beginAgain();
}

void Painting::beginAgain() {
  strokes_.clear();
  covered_.clear();
  covered_count_ = 0;
  weights_ = last_ = character_.unpainted;
  for (uint32_t v = 0; v < weights_.size(); ++v) show(v);
}

void Painting::show(uint32_t vertex) {
  const VertexSkin skin = skinOf(weights_[vertex]);
  for (uint32_t i = starts_[vertex]; i < starts_[vertex + 1]; ++i) skin_[doubles_[i]] = skin;
}

bool Painting::set(const std::vector<PlacedWeightStroke>& strokes, const WeightProgress& progress) {
  if (skin_.empty()) return true;
  const size_t most = std::min(strokes.size(), strokes_.size());
  const auto end = strokes_.begin() + static_cast<std::ptrdiff_t>(most);
  const auto differ = std::mismatch(strokes_.begin(), end, strokes.begin()).first;
  goBack(static_cast<size_t>(differ - strokes_.begin()));
  const size_t first = strokes_.size();
  for (size_t i = first; i < strokes.size(); ++i) {
    const double done =
        static_cast<double>(i - first) / static_cast<double>(strokes.size() - first);
    if (i > first && progress && !progress(done)) return false;
    paint(strokes[i]);
  }
  return true;
}

void Painting::goBack(size_t strokes) {
  if (strokes_.size() - strokes > covered_.size()) return beginAgain();
  for (; strokes_.size() > strokes; strokes_.pop_back()) {
    for (Covered& one : covered_.back()) {
      last_[one.vertex] = one.weights;
      weights_[one.vertex] = std::move(one.weights);
      show(one.vertex);
    }
    covered_count_ -= covered_.back().size();
    covered_.pop_back();
  }
}

void Painting::paint(const PlacedWeightStroke& stroke) {
  std::vector<Covered>& covered = covered_.emplace_back();
  for (const uint32_t v : painter_.paint(stroke, weights_)) {
    covered.push_back({v, std::move(last_[v])});
    last_[v] = weights_[v];
    show(v);
  }
  strokes_.push_back(stroke);
  covered_count_ += covered.size();
  while (covered_.size() > 1 && covered_count_ > kMostCovered * weights_.size()) {
    covered_count_ -= covered_.front().size();
    covered_.pop_front();
  }
}

}  // namespace marrow
