// Runs the pipeline on strokes of its own in small slices, so that the user's first one is fast:
// WebAssembly is slow until its code has been used a while.
#pragma once

#include <cstddef>
#include <vector>

#include "part/part.h"

namespace marrow {

class WarmUp {
 public:
  static constexpr double kEnough_ms = 900;  // of work, whatever it was

  WarmUp();
  bool done() const { return done_; }
  /// Works for about `budget_ms`; one step may take longer while the code is cold.
  void slice(double budget_ms, Clock clock);
  size_t runs() const { return runs_; }
  double spent_ms() const { return spent_ms_; }
  double longest_step_ms() const { return longest_ms_; }

 private:
  void step();

  std::vector<std::vector<Vec2>> strokes_;
  size_t stroke_ = 0, stage_ = 0, runs_ = 0;
  Outline outline_;
  StraightSkeleton straight_skeleton_;
  Axis axis_;
  PartSkeleton skeleton_;
  Triangulation flat_;
  double spent_ms_ = 0, longest_ms_ = 0;
  bool done_ = false;
};

}  // namespace marrow
