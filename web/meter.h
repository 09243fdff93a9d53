// What the last strokes cost.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/timing.h"

namespace marrow {

/// Times of the live preview, one per frame of the last stroke.
class PreviewMeter {
 public:
  void restart() { frames_ms_.clear(); }
  void add(double ms) { frames_ms_.push_back(ms); }
  size_t count() const { return frames_ms_.size(); }
  double last_ms() const { return frames_ms_.empty() ? 0 : frames_ms_.back(); }
  double first_ms() const { return frames_ms_.empty() ? 0 : frames_ms_.front(); }
  double max_ms() const {
    return frames_ms_.empty() ? 0 : *std::max_element(frames_ms_.begin(), frames_ms_.end());
  }
  double median_ms() const {
    if (frames_ms_.empty()) return 0;
    std::vector<double> sorted = frames_ms_;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  std::vector<double> frames_ms_;
};

struct Meter {
  PreviewMeter preview;
  double first_preview_ms = -1;  // of the very first stroke after the start; −1: none yet
  Timings last_part;             // of the part that was computed last, at full resolution
  double last_evaluation_ms = 0;
  uint64_t previews = 0;  // ever
};

}  // namespace marrow
