// How long each stage took. The core has no clock of its own: whoever calls brings one.
#pragma once

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace marrow {

/// Milliseconds from any fixed moment; null means "do not measure".
using Clock = double (*)();

struct Timings {
  std::vector<std::pair<const char*, double>> stages_ms;  // in the order they ran
  double total_ms = 0;

  /// Another's stages, each to the one of the same name.
  void add(const Timings& other) {
    for (const auto& [stage, ms] : other.stages_ms) addStage(stage, ms);
    total_ms += other.total_ms;
  }
  void addStage(const char* stage, double ms) {
    const auto same = std::find_if(stages_ms.begin(), stages_ms.end(), [&](const auto& known) {
      return std::strcmp(known.first, stage) == 0;
    });
    if (same != stages_ms.end()) {
      same->second += ms;
    } else {
      stages_ms.emplace_back(stage, ms);
    }
  }
};

/// Adds the time between its laps to `timings`.
class Stopwatch {
 public:
  Stopwatch(Clock clock, Timings& timings)
      : clock_(clock), timings_(timings), start_ms_(clock ? clock() : 0), lap_ms_(start_ms_) {}

  /// Ends the stage that began at the last lap; a stage that runs again adds to its time.
  void lap(const char* stage) {
    const double now_ms = clock_ ? clock_() : 0;
    timings_.addStage(stage, now_ms - lap_ms_);
    timings_.total_ms = now_ms - start_ms_;
    lap_ms_ = now_ms;
  }

 private:
  Clock clock_;
  Timings& timings_;
  double start_ms_, lap_ms_;
};

}  // namespace marrow
