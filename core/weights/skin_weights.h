// How much each bone moves each vertex.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/frame.h"
#include "base/timing.h"
#include "weights/biharmonic.h"
#include "weights/handles.h"
#include "weights/volume.h"

namespace marrow {

struct Influence {
  uint32_t bone = 0;
  double weight = 0;
};

/// Of a vertex: the largest weight first, of equal ones the lower bone; the unused have weight 0.
/// The weights sum to 1, to 1e-12.
constexpr size_t kMostInfluences = 8;
using Influences = std::array<Influence, kMostInfluences>;

/// Where only the largest weights stay: how much of one does, the largest of those that go being
/// given. From half as much again on all of it, as much as that nothing. So equal ones, such as
/// those of twins, stay or go together, and what a vertex follows changes by no jump along the
/// surface.
double shareKept(double weight, double largest_gone);

/// With at most so many influences a vertex: the smallest go, as much of the others as shareKept
/// says; what stays grows in proportion. Where all are alike the first ones stay.
Influences limited(const Influences& influences, size_t most);

struct WeightOptions {
  VolumeOptions volume;
  BiharmonicOptions biharmonic;
  /// A plane of symmetry: where the body is its own mirror image across it, weights are the mean of
  /// those of both sides. Bones that have no mirror image keep what they have.
  std::optional<Plane> symmetry;
};

/// For the time until the weights are there: a coarse volume and no bounds, cut off and brought to
/// sum 1.
WeightOptions quickWeightOptions();

/// Gets how much is done, 0 … 1; what it returns says whether to go on.
using WeightProgress = std::function<bool(double done)>;

class WeightSums;

/// The weights all through a body, so that any mesh in it gets the same ones: the whole character,
/// or its parts.
class WeightField {
 public:
  /// Of closed meshes, whose union the body is. Bones are straight and hold what is around them; a
  /// piece of the body that no bone runs through goes with the nearest place of one that has a
  /// bone. Without bones nothing has a weight. Errors: meshFailed where there is no body, or where
  /// `progress` said to stop.
  static Result<WeightField> make(const Mesh& body, const std::vector<Segment>& bones,
                                  const WeightOptions& options = {},
                                  const WeightProgress& progress = {}, Clock clock = nullptr);

  /// One per vertex of the mesh, whose vertices lie on or in the body. Vertices elsewhere go with
  /// the body's nearest place, those that are not finite with the first bone.
  std::vector<Influences> at(const Mesh& mesh) const;

  size_t boneCount() const { return bone_count_; }
  const Volume& volume() const { return volume_; }
  /// Of a vertex of the volume: all that are not 0, bones ascending; sum 1.
  const Influence* begin(uint32_t vertex) const { return influences_.data() + starts_[vertex]; }
  const Influence* end(uint32_t vertex) const { return influences_.data() + starts_[vertex + 1]; }
  /// Stages: volume, handles, factorisation, bones.
  const Timings& timings() const { return timings_; }

 private:
  WeightField() = default;
  void normalise(const std::vector<std::vector<double>>& by_bone);
  void fillLoosePieces(const std::vector<Segment>& bones);
  std::vector<uint32_t> nearestHandles() const;
  uint32_t nearestVertex(Vec3 point) const;
  void addMirrored(Vec3 point, Vec3 inward, std::vector<Influence>& weights,
                   WeightSums& sums) const;

  Volume volume_;
  std::optional<Plane> symmetry_;
  std::vector<uint32_t> images_;  // per bone: its mirror image; no bone's number where it has none
  Handles handles_;
  size_t bone_count_ = 0;
  std::vector<uint32_t> starts_;  // per vertex of the volume: its influences, bones ascending
  std::vector<Influence> influences_;
  Timings timings_;
};

}  // namespace marrow
