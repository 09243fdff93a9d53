// Document → everything derived, incrementally: a part is recomputed only when its own inputs
// changed, and a setting recomputes only what hangs on it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "document/document.h"
#include "part/part.h"

namespace marrow {

/// A part of the document with what was derived from it.
struct EvaluatedPart {
  std::shared_ptr<const PartSource> source;
  std::shared_ptr<const Part> part;  // null when `error` says why
  Error error;
  uint64_t mesh_id = 0;      // changes when the mesh does; never reused
  uint64_t skeleton_id = 0;  // changes when joints or bones do; never reused
};

class Evaluation {
 public:
  explicit Evaluation(PartOptions options = {}, Clock clock = nullptr);

  /// Brings `parts()` up to date with `document`; O(parts) plus the work for what changed.
  void update(const Document& document);
  const std::vector<EvaluatedPart>& parts() const { return parts_; }
  /// How many parts the last update had to compute, wholly or in part.
  size_t recomputed() const { return recomputed_; }

 private:
  EvaluatedPart evaluate(const std::shared_ptr<const PartSource>& source,
                         const EvaluatedPart* before);
  EvaluatedPart rebuild(const std::shared_ptr<const PartSource>& source);
  double epsilonS(const PartSource& source) const;

  PartOptions options_;
  Clock clock_;
  std::vector<EvaluatedPart> parts_;
  size_t recomputed_ = 0;
  uint64_t next_id_ = 1;
};

}  // namespace marrow
