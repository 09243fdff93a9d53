#include "bench/skeleton_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include "base/box.h"
#include "document/evaluation.h"
#include "sketch/arc_curve.h"
#include "sketch/polygon.h"

namespace marrow::bench {
namespace {

using strokes::NamedStroke;
using strokes::Stroke;

// The drawings are brought to this size, so that a unit is about a pixel.
constexpr double kSize = 600;

/// The default rig of one stroke.
struct Bones {
  std::vector<std::array<Vec2, 2>> segments;
  std::vector<Vec2> joints;
  std::vector<Vec2> tips;
  std::vector<int> topology;  // numbers of bones at terminals and junctions, ascending
  SkeletonHints hints;
};

Bones bonesOf(const Rig& rig) {
  Bones bones;
  std::vector<int> degrees(rig.joints.size());
  for (const auto& [a, b] : rig.bones) {
    const Vec3 p = rig.joints[a].position, q = rig.joints[b].position;
    bones.segments.push_back({Vec2{p.x, p.y}, Vec2{q.x, q.y}});
    ++degrees[a];
    ++degrees[b];
  }
  for (size_t i = 0; i < degrees.size(); ++i) {
    const Vec2 p{rig.joints[i].position.x, rig.joints[i].position.y};
    bones.joints.push_back(p);
    if (degrees[i] == 1) bones.tips.push_back(p);
    if (degrees[i] != 2) bones.topology.push_back(degrees[i]);
  }
  std::sort(bones.topology.begin(), bones.topology.end());
  return bones;
}

/// hints: of the frame before, in the live preview.
std::optional<Bones> bonesOf(const Stroke& stroke, const std::optional<SkeletonHints>& hints = {}) {
  Document document;
  auto part = std::make_shared<PartSource>();
  part->id = partId(takePartNumber(document));
  part->stroke = stroke;
  document.parts.push_back(part);
  PartOptions options = previewOptions();
  options.hints = hints;
  Evaluation evaluation(options);
  evaluation.update(document);
  if (!evaluation.parts()[0].part) return {};
  Bones bones = bonesOf(evaluation.rig());
  bones.hints = hintsOf(evaluation.parts()[0].part->skeleton);
  return bones;
}

std::vector<Vec2> pointsOn(const Bones& bones) {
  constexpr double kStep = kSize / 200;
  std::vector<Vec2> points;
  for (const auto& [a, b] : bones.segments) {
    const int count = 1 + static_cast<int>(distance(a, b) / kStep);
    for (int i = 0; i <= count; ++i) points.push_back(lerp(a, b, static_cast<double>(i) / count));
  }
  return points;
}

double farthest(const std::vector<Vec2>& points, const Bones& from) {
  double most = 0;
  for (const Vec2 p : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : from.segments)
      nearest = std::min(nearest, distanceToSegment(a, b, p));
    most = std::max(most, nearest);
  }
  return most;
}

double hausdorff(const Bones& one, const Bones& other) {
  return std::max(farthest(pointsOn(one), other), farthest(pointsOn(other), one));
}

Stroke normalised(Stroke stroke) {
  const Box2 box = boxOf(stroke);
  const double scale = kSize / box.longerSide();
  for (Vec2& p : stroke) p = (p - box.middle()) * scale;
  return stroke;
}

/// Samples `step` apart along the closed stroke from `start` on.
Stroke resampled(const Stroke& stroke, double step, double start = 0) {
  Stroke distinct;
  for (const Vec2 p : stroke) {
    if (distinct.empty() || p != distinct.back()) distinct.push_back(p);
  }
  while (distinct.size() > 1 && distinct.back() == distinct.front()) distinct.pop_back();
  const ArcCurve curve(distinct);
  const int count = std::max(8, static_cast<int>(curve.length() / step));
  Stroke samples;
  for (int i = 0; i < count; ++i) samples.push_back(curve.at(start + curve.length() * i / count));
  return samples;
}

double normal(Random& random) {
  double sum = 0;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum - 6;
}

/// Noise of 1 unit rms along a closed curve of samples 4 units apart, smooth over 25 units.
Stroke withTremor(const Stroke& samples, Random& random, double step = 4, double smooth = 25) {
  const int n = static_cast<int>(samples.size());
  std::vector<Vec2> white, noise(samples.size());
  for (int i = 0; i < n; ++i) {
    const double x = normal(random);
    white.push_back({x, normal(random)});
  }
  const int reach = std::min(n / 2, static_cast<int>(3 * smooth / step));
  Vec2 squares;
  for (int i = 0; i < n; ++i) {
    for (int k = -reach; k <= reach; ++k) {
      const double away = k * step / smooth;
      const auto other = static_cast<size_t>(((i + k) % n + n) % n);
      noise[static_cast<size_t>(i)] =
          noise[static_cast<size_t>(i)] + white[other] * std::exp(-0.5 * away * away);
    }
    const Vec2 v = noise[static_cast<size_t>(i)];
    squares = squares + Vec2{v.x * v.x, v.y * v.y};
  }
  Stroke trembled = samples;
  for (size_t i = 0; i < trembled.size(); ++i) {
    trembled[i] = trembled[i] + Vec2{noise[i].x / std::sqrt(squares.x / n),
                                     noise[i].y / std::sqrt(squares.y / n)};
  }
  return trembled;
}

struct Share {
  int hits = 0, all = 0;
  void add(bool hit) {
    ++all;
    hits += hit ? 1 : 0;
  }
  double percent() const { return all ? 100. * hits / all : 0; }
  std::string of() const { return std::to_string(hits) + " of " + std::to_string(all); }
};

QualityRow atMost(std::string what, const Share& share, double wanted) {
  return {std::move(what), share.percent(), wanted, false, "%", share.of()};
}

struct Mirror {
  Vec2 through, along;  // along: unit
  Vec2 operator()(Vec2 p) const {
    const Vec2 d = p - through;
    return through + along * (2 * dot(d, along)) - d;
  }
  double side(Vec2 p) const { return cross(along, p - through); }
};

Bones mirrored(const Bones& bones, const Mirror& mirror) {
  Bones other = bones;
  for (auto& [a, b] : other.segments) {
    a = mirror(a);
    b = mirror(b);
  }
  return other;
}

/// The part of a stroke on one side of the upright line through its middle, made whole by its
/// mirror image; nothing where it makes no simple shape.
std::optional<Stroke> madeSymmetric(const Stroke& stroke) {
  const Stroke samples = resampled(stroke, 2);
  const Vec2 middle = areaCentroid(samples);
  const size_t n = samples.size();
  size_t best_start = 0, best_count = 0;
  for (size_t i = 0; i < n; ++i) {
    if (!(samples[i].x > middle.x) || samples[(i + n - 1) % n].x > middle.x) continue;
    size_t count = 0;
    while (count < n && samples[(i + count) % n].x > middle.x) ++count;
    if (count > best_count) {
      best_count = count;
      best_start = i;
    }
  }
  if (best_count < 20 || best_count == n) return {};
  Stroke half;
  for (size_t k = 0; k < best_count; ++k)
    half.push_back(samples[(best_start + k) % n] - Vec2{middle.x, 0});
  Stroke whole = half;
  for (size_t k = best_count; k-- > 0;) whole.push_back({-half[k].x, half[k].y});
  if (!isSimple(whole)) return {};
  return normalised(whole);
}

/// Inside or not, on a grid.
class Raster {
 public:
  explicit Raster(const Stroke& stroke) {
    const Box2 box = boxOf(stroke);
    low_ = box.middle() - Vec2{kSize, kSize};
    inside_.assign(kSide * kSide, 0);
    for (int y = 0; y < kSide; ++y) {
      std::vector<double> crossings;
      const double at = low_.y + (y + 0.5) * kCell;
      for (size_t i = 0; i < stroke.size(); ++i) {
        const Vec2 a = stroke[i], b = stroke[(i + 1) % stroke.size()];
        if ((a.y <= at) != (b.y <= at))
          crossings.push_back(a.x + (b.x - a.x) * (at - a.y) / (b.y - a.y));
      }
      std::sort(crossings.begin(), crossings.end());
      for (int x = 0; x < kSide; ++x) {
        const double here = low_.x + (x + 0.5) * kCell;
        const auto before =
            std::lower_bound(crossings.begin(), crossings.end(), here) - crossings.begin();
        inside_[static_cast<size_t>(y * kSide + x)] = before % 2 != 0;
      }
    }
  }
  /// Shared area ÷ joint area with the mirror image.
  double overlap(const Mirror& mirror) const {
    int both = 0, any = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const bool here = inside_[static_cast<size_t>(y * kSide + x)] != 0;
        const bool there = at(mirror(low_ + Vec2{x + 0.5, y + 0.5} * kCell));
        both += here && there;
        any += here || there;
      }
    }
    return static_cast<double>(both) / std::max(any, 1);
  }

 private:
  bool at(Vec2 p) const {
    const int x = static_cast<int>(std::floor((p.x - low_.x) / kCell)),
              y = static_cast<int>(std::floor((p.y - low_.y) / kCell));
    return x >= 0 && y >= 0 && x < kSide && y < kSide &&
           inside_[static_cast<size_t>(y * kSide + x)];
  }
  static constexpr int kSide = 200;
  static constexpr double kCell = 2 * kSize / kSide;
  Vec2 low_;
  std::vector<char> inside_;
};

struct BestMirror {
  Mirror mirror;
  double overlap = 0;
};
BestMirror bestMirror(const Stroke& stroke) {
  const Raster raster(stroke);
  const Vec2 middle = areaCentroid(stroke);
  BestMirror best;
  const auto tryOne = [&](double angle, double offset) {
    const Vec2 along{std::cos(angle), std::sin(angle)};
    const Mirror mirror{middle + perpendicular(along) * offset, along};
    const double overlap = raster.overlap(mirror);
    if (overlap > best.overlap) best = {mirror, overlap};
    return overlap;
  };
  double best_angle = 0, most = 0;
  for (int i = 0; i < 60; ++i) {
    const double here = tryOne(strokes::kTau / 2 * i / 60, 0);
    if (here > most) {
      most = here;
      best_angle = strokes::kTau / 2 * i / 60;
    }
  }
  for (int i = -4; i <= 4; ++i) {
    for (int k = -2; k <= 2; ++k) {
      tryOne(best_angle + strokes::kTau / 2 * i / 300, k * kSize / 150);
    }
  }
  return best;
}

double outlineChange(const Stroke& one, const Stroke& other) {
  const auto oneWay = [](const Stroke& from, const Stroke& to) {
    double most = 0;
    for (const Vec2 p : from) {
      double nearest = std::numeric_limits<double>::infinity();
      for (size_t i = 0; i < to.size(); ++i) {
        nearest = std::min(nearest, distanceToSegment(to[i], to[(i + 1) % to.size()], p));
      }
      most = std::max(most, nearest);
    }
    return most;
  };
  return std::max(oneWay(one, other), oneWay(other, one));
}

}  // namespace

std::vector<QualityRow> skeletonQuality(const std::vector<NamedStroke>& drawings, bool verbose) {
  Share unsymmetric, uneven, nearly, topology, moved, sampled_topology, sampled_moved, jumps,
      bumped;
  const auto say = [&](const char* what, const std::string& name, double value) {
    if (verbose) std::fprintf(stderr, "%s %s %.1f\n", what, name.c_str(), value);
  };
  for (const auto& [name, drawn] : drawings) {
    const Stroke stroke = normalised(drawn);
    const auto still = bonesOf(stroke);
    if (!still) continue;
    Random random(11);

    if (const auto symmetric = madeSymmetric(stroke)) {
      for (int turn = 0; turn < 2; ++turn) {
        const double angle = turn * random.between(0, strokes::kTau);
        const Mirror mirror{{0, 0}, {-std::sin(angle), std::cos(angle)}};
        const Vec2 x{std::cos(angle), std::sin(angle)};
        Stroke turned;
        for (const Vec2 p : *symmetric) turned.push_back(x * p.x + perpendicular(x) * p.y);
        const auto bones = bonesOf(turned);
        if (!bones) continue;
        const double off = hausdorff(*bones, mirrored(*bones, mirror)) / kSize;
        unsymmetric.add(off > 0.02);
        int left = 0, right = 0;
        for (const Vec2 tip : bones->tips) {
          left += mirror.side(tip) > 0.02 * kSize ? 1 : 0;
          right += mirror.side(tip) < -0.02 * kSize ? 1 : 0;
        }
        uneven.add(left != right);
        if (off > 0.02) say("unsymmetric", name, 100 * off);
      }
    }
    const BestMirror best = bestMirror(stroke);
    if (best.overlap > 0.85) {
      const double off = hausdorff(*still, mirrored(*still, best.mirror)) / kSize;
      nearly.add(off > 0.02);
      if (off > 0.02) say("nearly", name, 100 * off);
    }

    const Stroke samples = resampled(stroke, 4);
    int changes = 0, moves = 0;
    for (int trial = 0; trial < 20; ++trial) {
      const auto bones = bonesOf(withTremor(samples, random));
      const bool other = !bones || bones->topology != still->topology;
      const bool far = !bones || hausdorff(*bones, *still) > 0.05 * kSize;
      topology.add(other);
      moved.add(far);
      changes += other;
      moves += far;
    }
    if (changes) say("tremor-topology", name, changes);
    if (moves) say("tremor-moved", name, moves);

    changes = moves = 0;
    for (int trial = 0; trial < 10; ++trial) {
      const auto bones = bonesOf(resampled(stroke, random.between(3, 5), random.between(0, kSize)));
      const bool other = !bones || bones->topology != still->topology;
      const bool far = !bones || hausdorff(*bones, *still) > 0.05 * kSize;
      sampled_topology.add(other);
      sampled_moved.add(far);
      changes += other;
      moves += far;
    }
    if (changes) say("sampled-topology", name, changes);
    if (moves) say("sampled-moved", name, moves);

    // As it is drawn, frame by frame.
    constexpr int kFrames = 120;
    std::optional<Bones> before;
    Stroke last;
    for (int frame = kFrames / 4; frame <= kFrames; ++frame) {
      const Stroke prefix(
          samples.begin(),
          samples.begin() +
              static_cast<long>(samples.size() * static_cast<size_t>(frame) / kFrames));
      const auto bones = bonesOf(prefix, before ? std::optional(before->hints) : std::nullopt);
      if (before && bones && outlineChange(prefix, last) < 0.01 * kSize) {
        const bool jump = hausdorff(*bones, *before) > 0.05 * kSize;
        jumps.add(jump);
        if (jump) say("jump", name, frame);
      }
      before = bones;
      last = prefix;
    }

    for (int trial = 0; trial < 10; ++trial) {
      const size_t n = samples.size(), at = static_cast<size_t>(random.below(static_cast<int>(n)));
      const double height = (random.below(2) ? 1 : -1) * 0.01 * kSize;
      Stroke bump = samples;
      for (size_t i = 0; i < n; ++i) {
        const double gap = std::min((i + n - at) % n, (at + n - i) % n) * 4 / (0.015 * kSize);
        const Vec2 along = samples[(i + 1) % n] - samples[(i + n - 1) % n];
        if (gap > 4 || !(length(along) > 0)) continue;
        bump[i] =
            bump[i] + perpendicular(along) / length(along) * (height * std::exp(-0.5 * gap * gap));
      }
      const auto bones = bonesOf(bump), plain = bonesOf(samples);
      if (!bones || !plain) continue;
      int far_moves = 0;
      for (const Vec2 joint : plain->joints) {
        if (distance(joint, samples[at]) < 0.2 * kSize) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec2 other : bones->joints) nearest = std::min(nearest, distance(joint, other));
        bumped.add(nearest > 0.01 * kSize);
        far_moves += nearest > 0.01 * kSize ? 1 : 0;
      }
      if (far_moves)
        say("bump", name + (bones->topology != plain->topology ? " other-topology" : ""),
            far_moves);
    }
  }
  return {
      atMost("symmetric outlines whose skeleton is off its mirror image by over 2 %", unsymmetric,
             0.5),
      atMost("symmetric outlines with other numbers of tips left and right", uneven, 0),
      atMost("nearly symmetric drawings off by over 2 %", nearly, 10),
      atMost("a tremor of 1 px: another topology", topology, 5),
      atMost("a tremor of 1 px: bones move over 5 %", moved, 5),
      atMost("sampled elsewhere: another topology", sampled_topology, 1),
      atMost("sampled elsewhere: bones move over 5 %", sampled_moved, 1),
      atMost("while drawing, outline within 1 %: bones move over 5 %", jumps, 1),
      atMost("a bump of 1 %: joints over 20 % away that move over 1 %", bumped, 1),
  };
}

}  // namespace marrow::bench
