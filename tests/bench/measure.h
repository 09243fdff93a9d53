// Times of repeated calls.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace marrow::bench {

/// Milliseconds from any fixed moment.
inline double now() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

/// How long and how often a thing is repeated.
struct Effort {
  double budget_ms;  // stops after it, but not before `least` runs
  int least = 3;
};

struct Times {
  double min_ms = 0, median_ms = 0;
  int runs = 0;
};

inline Times summary(std::vector<double> times_ms) {
  if (times_ms.empty()) return {};
  std::sort(times_ms.begin(), times_ms.end());
  return {times_ms.front(), times_ms[times_ms.size() / 2], static_cast<int>(times_ms.size())};
}

/// Times `call` after one call that does not count. Short ones are timed several at once, so that
/// the clock's own cost does not show.
template <typename Call>
Times measure(Call&& call, Effort effort) {
  constexpr double kLap_ms = 0.1;
  double start_ms = now();
  call();
  const double first_ms = now() - start_ms;
  const int batch = first_ms >= kLap_ms ? 1 : static_cast<int>(kLap_ms / (first_ms + 1e-4)) + 1;

  std::vector<double> times_ms;
  const double end_ms = now() + effort.budget_ms;
  while (static_cast<int>(times_ms.size()) < effort.least || now() < end_ms) {
    start_ms = now();
    for (int i = 0; i < batch; ++i) call();
    times_ms.push_back((now() - start_ms) / batch);
  }
  return summary(std::move(times_ms));
}

}  // namespace marrow::bench
