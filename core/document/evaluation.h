// Document → everything derived, incrementally: a part is recomputed only when its own inputs
// changed, and a setting recomputes only what hangs on it.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "document/document.h"
#include "document/placed_parts.h"
#include "part/part.h"
#include "rig/refine.h"
#include "rig/rig.h"

namespace marrow {

/// A part of the document with what was derived from it, in its own plane. Parts of the same stroke
/// (or imported mesh) and thickness have the same body, which is there but once.
struct EvaluatedPart {
  std::shared_ptr<const PartSource> source;
  std::shared_ptr<const Part> part;  // null when `error` says why
  Error error;
  std::shared_ptr<const Part> twin;  // in the mirror z = 0, where it is imported: a drawn one is
                                     // the same there
  uint64_t mesh_id = 0;              // changes when the mesh does; that of another mesh never
  uint64_t twin_mesh_id = 0;
  int points = 0;            // of its mesh, as aimed at (see pointsOfPart)
  uint64_t skeleton_id = 0;  // changes when joints or bones do; never reused

  /// The shape of a placed part, and the number of its mesh.
  const std::shared_ptr<const Part>& shapeOf(const PlacedPart& placed) const {
    return placed.twin && twin ? twin : part;
  }
  uint64_t meshOf(const PlacedPart& placed) const {
    return placed.twin && twin ? twin_mesh_id : mesh_id;
  }
};

/// Large characters are made of small parts. The mesh of the n-th part of a document aims at `full`
/// points for the first 64, at a quarter of that, about what a preview has, for as many again, and
/// at half as many whenever n doubles from there: a body of thousands of parts has a few times the
/// points of one of 64. Copies in the same place count as one, and those
/// elsewhere all have the points of the one in the middle of them. So a part that is added changes
/// no other, unless that is a copy of it.
int pointsOfPart(size_t index, int full);

class Evaluation {
 public:
  explicit Evaluation(PartOptions options = {}, Clock clock = nullptr);

  /// Brings everything below up to date with `document`; O(parts) plus the work for what changed. A
  /// part is built anew when its stroke changed; its thickness redoes the depth of its mesh; what
  /// places it in space touches the rig alone, and colours and the like not even that.
  void update(const Document& document);

  /// One per part of the document.
  const std::vector<EvaluatedPart>& parts() const { return parts_; }
  /// With their twins. `source` is an index of `parts()`.
  const std::vector<PlacedPart>& placed() const { return placed_; }
  /// The skeleton of all of them; its indices are of `placed()`.
  const Rig& rig() const { return rig_; }
  /// Changes when the rig does; never reused.
  uint64_t rigId() const { return rig_id_; }

  /// What `rig()` is made of, one per placed part. To know the rig with a part that is still being
  /// drawn, add that one (its twin too) and call makeRig. Valid until the next update.
  std::vector<RigPart> rigParts() const;

  /// How many bodies the last update had to compute, wholly or in part.
  size_t recomputed() const { return recomputed_; }
  /// How long the last update took: stages of the parts it computed, then connection, refinement.
  const Timings& timings() const { return timings_; }

 private:
  EvaluatedPart evaluate(const std::shared_ptr<const PartSource>& source, int points,
                         const EvaluatedPart* before);
  EvaluatedPart rebuild(const std::shared_ptr<const PartSource>& source, int points);
  const EvaluatedPart* findLike(const PartSource& source, int points);
  const EvaluatedPart* findKnown(const PartSource& source, int points, uint64_t hash,
                                 bool of_thickness) const;
  void remember(const EvaluatedPart& part);
  void addTwin(EvaluatedPart& evaluated);
  void updateRig(const Document& document, bool same_places);

  PartOptions options_;
  Clock clock_;
  std::vector<EvaluatedPart> parts_;
  std::unordered_multimap<uint64_t, EvaluatedPart> known_;  // while updating: by hashes
  std::vector<PlacedPart> placed_;
  Refinement refine_;
  std::vector<Connection> connections_;
  Rig rig_;
  Timings timings_;
  size_t recomputed_ = 0;
  uint64_t next_id_ = 1;
  uint64_t rig_id_ = 0;
};

}  // namespace marrow
