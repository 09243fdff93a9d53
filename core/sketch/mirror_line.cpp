#include "sketch/mirror_line.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace marrow {
namespace {

constexpr size_t kCoarse = 72;   // samples for the first look
constexpr size_t kFine = 96;     // on each side, to bring both together
constexpr size_t kBand = 10;     // of these, how far the sides may be out of step
constexpr double kAlike = 0.97;  // of the correlation of a curve with itself; 1 for a symmetric one
constexpr double kUpright = 0.003;  // what an upright line counts for in it, and in the end
constexpr double kAsGood = 0.02;    // behind the best in it
constexpr size_t kCandidates = 3;
constexpr double kAside = 0.04;  // of the curve: how far from there it may meet the line

Vec2 times(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

/// The samples at `count` even places, interpolated; from `start` (in samples) on.
Vec2 at(const std::vector<Vec2>& samples, double place) {
  const double n = static_cast<double>(samples.size());
  place -= std::floor(place / n) * n;
  const size_t i = std::min(static_cast<size_t>(place), samples.size() - 1);
  return lerp(samples[i], samples[i + 1 < samples.size() ? i + 1 : 0],
              place - static_cast<double>(i));
}

/// Half the angle of a unit vector, as a unit vector; upwards.
Vec2 halved(Vec2 twice) {
  const double size = length(twice);
  if (!(size > 0)) return {0, 1};
  twice = twice / size;
  Vec2 half{std::sqrt(std::max(0.0, (1 + twice.x) / 2)),
            std::sqrt(std::max(0.0, (1 - twice.x) / 2))};
  if (twice.y < 0) half.x = -half.x;
  return half;
}

struct Candidate {
  double shift;
  double fit;
};

std::vector<Candidate> candidates(const std::vector<Vec2>& samples) {
  const size_t m = std::min(kCoarse, samples.size());
  const double step = static_cast<double>(samples.size()) / static_cast<double>(m);
  std::vector<Vec2> z(2 * m);
  Vec2 sum;
  for (size_t i = 0; i < m; ++i) {
    z[i] = at(samples, static_cast<double>(i) * step);
    sum = sum + z[i];
  }
  double all = 0;
  for (size_t i = 0; i < m; ++i) {
    z[i] = z[i] - sum / static_cast<double>(m);
    z[i + m] = z[i];
    all += dot(z[i], z[i]);
  }
  std::vector<double> fits(m), plain(m);
  for (size_t k = 0; k < m; ++k) {
    Vec2 found;
    for (size_t i = 0; i < m; ++i) found = found + times(z[i], z[k + m - i]);
    const double fit = all > 0 ? length(found) / all : 0;
    // The line's direction has half the angle; an upright one has −1 in x here.
    const double upright = fit > 0 ? (1 - found.x / length(found)) / 2 : 0;
    plain[k] = fit;
    fits[k] = fit + kUpright * upright;
  }
  std::vector<Candidate> best;
  for (size_t k = 0; k < m; ++k) {
    if (plain[k] < kAlike) continue;
    if (fits[k] < fits[(k + 1) % m] || fits[k] < fits[(k + m - 1) % m]) continue;
    // Between the samples, by a parabola.
    const double before = plain[(k + m - 1) % m], after = plain[(k + 1) % m];
    const double bend = before - 2 * plain[k] + after;
    const double beside = bend < 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0;
    best.push_back({static_cast<double>(k) + beside, fits[k]});
  }
  std::stable_sort(best.begin(), best.end(),
                   [](const Candidate& a, const Candidate& b) { return a.fit > b.fit; });
  while (best.size() > kCandidates || (!best.empty() && best.back().fit < best[0].fit - kAsGood)) {
    best.pop_back();
  }
  return best;
}

/// Which samples of the two sides belong together, from the first two to the last two.
std::vector<std::pair<size_t, size_t>> broughtTogether(const std::vector<Vec2>& one,
                                                       const std::vector<Vec2>& other) {
  const size_t n = one.size(), width = 2 * kBand + 1;
  constexpr double kFar = 1e300;
  std::vector<double> costs(n * width, kFar);
  std::vector<uint8_t> from(n * width, 0);
  const auto index = [&](size_t i, size_t j) { return i * width + (j + kBand - i); };
  const auto inBand = [&](size_t i, size_t j) { return j + kBand >= i && j <= i + kBand; };
  for (size_t i = 0; i < n; ++i) {
    const size_t first = i > kBand ? i - kBand : 0, last = std::min(n - 1, i + kBand);
    for (size_t j = first; j <= last; ++j) {
      const Vec2 apart = one[i] - other[j];
      double least = i == 0 && j == 0 ? 0 : kFar;
      uint8_t step = 0;
      const auto look = [&](bool there, size_t a, size_t b, uint8_t how) {
        if (!there || !inBand(a, b)) return;
        const double cost = costs[index(a, b)];
        if (cost < least) {
          least = cost;
          step = how;
        }
      };
      look(i > 0 && j > 0, i - 1, j - 1, 0);
      look(i > 0, i - 1, j, 1);
      look(j > 0, i, j - 1, 2);
      // A step of both counts for two of one.
      costs[index(i, j)] = least + dot(apart, apart) * (step == 0 ? 2 : 1);
      from[index(i, j)] = step;
    }
  }
  std::vector<std::pair<size_t, size_t>> pairs;
  for (size_t i = n - 1, j = n - 1;;) {
    pairs.push_back({i, j});
    if (i == 0 && j == 0) break;
    const uint8_t step = from[index(i, j)];
    if (step != 2) --i;
    if (step != 1) --j;
  }
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

MirrorLine lineBetween(const std::vector<Vec2>& one, const std::vector<Vec2>& other,
                       const std::vector<std::pair<size_t, size_t>>& pairs) {
  Vec2 middle;
  for (const auto& [i, j] : pairs) middle = middle + one[i] + other[j];
  middle = middle / (2 * static_cast<double>(pairs.size()));
  Vec2 twice;
  for (const auto& [i, j] : pairs) twice = twice + times(one[i] - middle, other[j] - middle);
  return {middle, halved(twice)};
}

/// Where the curve meets the line, nearest to a place on it; the place itself where it does not
/// meet it near there.
double meetingNear(const std::vector<Vec2>& samples, const MirrorLine& line, double place) {
  const size_t n = samples.size();
  const size_t reach = static_cast<size_t>(kAside * static_cast<double>(n)) + 1;
  double best = place, least = static_cast<double>(n);
  for (size_t k = 0; k <= 2 * reach; ++k) {
    const double start = std::floor(place) + static_cast<double>(k) - static_cast<double>(reach);
    const double here = line.side(at(samples, start)), next = line.side(at(samples, start + 1));
    if ((here > 0) == (next > 0)) continue;
    const double found = start + here / (here - next);
    if (!(std::fabs(found - place) < least)) continue;
    least = std::fabs(found - place);
    best = found;
  }
  return best;
}

MirrorFit fitOf(const std::vector<Vec2>& samples, double shift) {
  const double n = static_cast<double>(samples.size());
  const size_t sides = std::min(kFine, samples.size() / 2);
  // Where the sides begin and end; per: samples of each side a step.
  double begin = shift / 2, end = shift / 2 + n / 2;
  double per_one = 0, per_other = 0;
  std::vector<Vec2> one(sides + 1), other(sides + 1);
  std::vector<std::pair<size_t, size_t>> pairs;
  const auto walk = [&] {
    per_one = (end - begin) / static_cast<double>(sides);
    per_other = (begin + n - end) / static_cast<double>(sides);
    for (size_t j = 0; j <= sides; ++j) {
      one[j] = at(samples, begin + per_one * static_cast<double>(j));
      other[j] = at(samples, begin - per_other * static_cast<double>(j));
    }
  };
  walk();
  for (size_t j = 0; j <= sides; ++j) pairs.push_back({j, j});
  // The two sides as they lie, then brought together, give the line; and once more the pairs.
  MirrorFit fit;
  for (int round = 0; round < 2; ++round) {
    fit.line = lineBetween(one, other, pairs);
    begin = meetingNear(samples, fit.line, begin);
    end = meetingNear(samples, fit.line, end);
    walk();
    std::vector<Vec2> images;
    for (const Vec2 p : other) images.push_back(fit.line.mirrored(p));
    pairs = broughtTogether(one, images);
  }
  // The area between the one side and the other's image, strip by strip.
  double between = 0, whole = 0;
  Vec2 a, b;
  for (const auto& [i, j] : pairs) {
    const Vec2 c = one[i], d = fit.line.mirrored(other[j]);
    if (i > 0 || j > 0) between += std::fabs(cross(c - b, a - d)) / 2;
    a = c;
    b = d;
  }
  for (size_t i = 0; i < samples.size(); ++i) {
    whole += cross(samples[i], samples[i + 1 < samples.size() ? i + 1 : 0]) / 2;
  }
  // What only one of the two has is twice that; what they share is the rest.
  const double share = between / whole;
  fit.overlap = (1 - share) / (1 + share);

  // Between both, as fine as the samples are.
  const size_t fine = static_cast<size_t>(n / 2 / static_cast<double>(sides) + 0.5);
  for (size_t k = 0; k < pairs.size(); ++k) {
    const size_t next = std::min(k + 1, pairs.size() - 1);
    for (size_t part = 0; part < (next > k ? fine : 1); ++part) {
      const double t = static_cast<double>(part) / static_cast<double>(fine);
      const auto between_pairs = [&](size_t from, size_t to) {
        return static_cast<double>(from) +
               (static_cast<double>(to) - static_cast<double>(from)) * t;
      };
      const Vec2 c =
          at(samples, begin + per_one * between_pairs(pairs[k].first, pairs[next].first));
      const Vec2 d =
          at(samples, begin - per_other * between_pairs(pairs[k].second, pairs[next].second));
      fit.half.push_back((c + fit.line.mirrored(d)) / 2);
    }
  }
  return fit;
}

}  // namespace

std::vector<Vec2> mirroredWhole(const MirrorFit& fit) {
  const auto& half = fit.half;
  if (half.size() < 4) return {};
  const double side = fit.line.side(half[half.size() / 2]) < 0 ? -1 : 1;
  std::vector<Vec2> whole{fit.line.foot(half.front())};
  for (size_t i = 1; i + 1 < half.size(); ++i) {
    if (fit.line.side(half[i]) * side > 0) whole.push_back(half[i]);
  }
  const size_t own = whole.size();
  whole.push_back(fit.line.foot(half.back()));
  for (size_t i = own; i-- > 1;) whole.push_back(fit.line.mirrored(whole[i]));
  return whole;
}

std::optional<MirrorFit> findMirrorLine(const std::vector<Vec2>& samples) {
  if (samples.size() < 12) return {};
  const double per =
      static_cast<double>(samples.size()) / static_cast<double>(std::min(kCoarse, samples.size()));
  std::optional<MirrorFit> best;
  double most = 0;
  for (const Candidate& candidate : candidates(samples)) {
    MirrorFit fit = fitOf(samples, candidate.shift * per);
    const double upright = kUpright * fit.line.along.y * fit.line.along.y;
    if (best && !(fit.overlap + upright > most)) continue;
    most = fit.overlap + upright;
    best = std::move(fit);
  }
  return best;
}

}  // namespace marrow
