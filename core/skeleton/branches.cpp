#include "skeleton/branches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/sets.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;
// A limb is thinner than the ball that it leaves: the less the nearer to this part of its radius,
constexpr double kAsThick = 0.85;
// and wholly a limb from this much thinner on.
constexpr double kThinner = 0.3;
// Its joint at the body lies on the line of its first stretch, so many of its radii long, prolonged
// into the body up to this part of the ball's radius from its middle.
constexpr double kStretch = 2.5;
constexpr double kMouth = 0.65;
// A body's joint lies nearer to the limbs at its end than the middle of its last ball does: of the
// way to the middle between their joints, this part.
constexpr double kTowardsLimbs = 0.8;
// Where the body goes on thinner beyond limbs, as a trunk does in a neck, it lies this part of the
// radius nearer to that,
constexpr double kTowardsNeck = 0.25;
// if that is thinner by this part of the radius, in the first stretch of so many radii.
constexpr double kNeck = 0.3;
constexpr double kNeckStretch = 2.5;
// Junctions nearer to each other than this part of the smaller ball's radius are one;
constexpr double kOne = 0.35;
// with a pair of limbs at each of them than this;
constexpr double kOneWithPairs = 0.12;
// with so many limbs together than this.
constexpr double kOneInCrowd = 0.8;
constexpr int kCrowd = 7;
// What was there a moment ago counts for so much more; it is what lies within this part of a
// radius.
constexpr double kMemory = 1.3;
constexpr double kNearBefore = 1.0;

using Branch = AxisBranches::Branch;

double lengthOf(const Branch& branch) {
  double sum = 0;
  for (size_t k = 0; k + 1 < branch.line.size(); ++k) {
    sum += distance(branch.line[k], branch.line[k + 1]);
  }
  return sum;
}

/// Its line alone.
void reverse(Branch& branch) {
  std::reverse(branch.line.begin(), branch.line.end());
  std::reverse(branch.radii.begin(), branch.radii.end());
}

AxisBranches divided(const Axis& axis) {
  const size_t count = axis.points.size();
  std::vector<std::vector<uint32_t>> neighbours(count);
  for (const auto& [a, b] : axis.edges) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  AxisBranches found;
  std::vector<uint32_t> end_of(count, kNone);
  for (uint32_t i = 0; i < count; ++i) {
    if (neighbours[i].size() == 2) continue;
    end_of[i] = static_cast<uint32_t>(found.ends.size());
    found.ends.push_back(
        {axis.points[i], axis.radii[i], static_cast<uint32_t>(neighbours[i].size())});
  }
  for (uint32_t start = 0; start < count; ++start) {
    if (neighbours[start].size() == 2) continue;
    for (const uint32_t next : neighbours[start]) {
      Branch branch;
      branch.from = end_of[start];
      uint32_t before = start, at = next;
      branch.line.push_back(axis.points[start]);
      branch.radii.push_back(axis.radii[start]);
      for (;;) {
        branch.line.push_back(axis.points[at]);
        branch.radii.push_back(axis.radii[at]);
        if (neighbours[at].size() != 2) break;
        const uint32_t onward = neighbours[at][neighbours[at][0] == before ? 1 : 0];
        before = at;
        at = onward;
      }
      if (at < start) continue;  // met from its other end
      branch.to = end_of[at];
      found.branches.push_back(std::move(branch));
    }
  }
  return found;
}

/// A branch seen from one of its ends.
class View {
 public:
  View(const Branch& branch, bool backwards) : branch_(branch), backwards_(backwards) {}
  size_t count() const { return branch_.line.size(); }
  Vec2 point(size_t k) const { return branch_.line[at(k)]; }
  double radius(size_t k) const { return branch_.radii[at(k)]; }

  struct Place {
    Vec2 point;
    size_t next;  // the first point behind it
    bool within;  // the branch is that long
  };
  Place placeAt(double along) const {
    for (size_t k = 1; k < count(); ++k) {
      const double step = distance(point(k - 1), point(k));
      if (along <= step && step > 0) return {lerp(point(k - 1), point(k), along / step), k, true};
      along -= step;
    }
    return {point(count() - 1), count(), false};
  }
  /// The mean radius from there on; 0 where there is nothing.
  double meanRadius(double from) const {
    double along = 0, sum = 0, length = 0;
    for (size_t k = 1; k < count(); ++k) {
      const double step = distance(point(k - 1), point(k));
      along += step;
      if (along <= from) continue;
      sum += step * (radius(k - 1) + radius(k)) / 2;
      length += step;
    }
    return length > 0 ? sum / length : 0;
  }
  double leastRadius(double to) const {
    double along = 0, least = radius(0);
    for (size_t k = 1; k < count() && along < to; ++k) {
      along += distance(point(k - 1), point(k));
      least = std::min(least, radius(k));
    }
    return least;
  }

 private:
  size_t at(size_t k) const { return backwards_ ? count() - 1 - k : k; }
  const Branch& branch_;
  bool backwards_;
};

/// Gives junctions and the beginnings of limbs the places that joints have there.
class Arranging {
 public:
  Arranging(const Region& region, AxisBranches& found, const SkeletonHints* hints)
      : region_(region), found_(found), hints_(hints) {}

  void run() {
    findMouths();
    becomeOne();
    // What was between two that are one is gone, and all others may have other mouths.
    findMouths();
    std::vector<Vec2> places;
    for (uint32_t e = 0; e < found_.ends.size(); ++e) {
      places.push_back(isJunction(e) ? placeOf(e) : found_.ends[e].point);
    }
    for (size_t b = 0; b < found_.branches.size(); ++b)
      redraw(found_.branches[b], mouths_[b], places);
    for (uint32_t e = 0; e < found_.ends.size(); ++e) found_.ends[e].point = places[e];
  }

 private:
  /// Where a branch becomes a limb of its own.
  struct Mouth {
    double limb = 0;   // how much of a limb it is, 0 … 1
    Vec2 place;        // the joint
    double along = 0;  // of the axis, from there on it is the limb's
    double thin = 0;   // the least radius of its first stretch
    Vec2 towards;      // where it leaves the ball
  };

  bool isJunction(uint32_t e) const { return found_.ends[e].branches > 2; }

  void findMouths() {
    mouths_.clear();
    for (const Branch& branch : found_.branches) {
      mouths_.push_back({mouthOf(branch, false), mouthOf(branch, true)});
    }
  }

  /// Junctions too near to each other for a bone become one, in their middle. Two that have a pair
  /// of limbs each, as hips and shoulders, are joints of their own even in a stout body; many limbs
  /// that leave a body side by side do so from one joint even where they are farther apart.
  void becomeOne() {
    const auto count = found_.ends.size();
    std::vector<double> limbs(count, 0);
    for (size_t b = 0; b < found_.branches.size(); ++b) {
      limbs[found_.branches[b].from] += mouths_[b][0].limb;
      limbs[found_.branches[b].to] += mouths_[b][1].limb;
    }
    Sets near(count), crowds(count);
    for (const Branch& branch : found_.branches) {
      if (!isJunction(branch.from) || !isJunction(branch.to)) continue;
      const double ball = std::min(found_.ends[branch.from].radius, found_.ends[branch.to].radius);
      const double apart = lengthOf(branch) / ball * memoryOf(branch, ball);
      const bool pairs = std::min(limbs[branch.from], limbs[branch.to]) > 1.5;
      if (apart < (pairs ? kOneWithPairs : kOne)) near.join(branch.from, branch.to);
      if (apart < kOneInCrowd) crowds.join(branch.from, branch.to);
    }
    std::vector<int> single(count, 0);
    for (const Branch& branch : found_.branches) {
      for (const uint32_t e : {branch.from, branch.to}) {
        const uint32_t other = e == branch.from ? branch.to : branch.from;
        if (isJunction(e) && !isJunction(other)) ++single[crowds.find(e)];
      }
    }
    std::vector<uint32_t> one(count);
    std::vector<Vec2> sums(count);
    std::vector<double> counts(count, 0);
    for (uint32_t e = 0; e < count; ++e) {
      one[e] = single[crowds.find(e)] >= kCrowd ? crowds.find(e) : near.find(e);
      sums[one[e]] = sums[one[e]] + found_.ends[e].point;
      counts[one[e]] += 1;
    }
    for (uint32_t e = 0; e < count; ++e) {
      if (counts[one[e]] < 2) continue;
      found_.ends[one[e]].radius = std::max(found_.ends[one[e]].radius, found_.ends[e].radius);
    }
    for (size_t b = 0; b < found_.branches.size();) {
      Branch& branch = found_.branches[b];
      if (one[branch.from] == one[branch.to]) {
        found_.branches.erase(found_.branches.begin() + static_cast<long>(b));
        continue;
      }
      for (const bool backwards : {false, true}) {
        uint32_t& e = backwards ? branch.to : branch.from;
        if (counts[one[e]] > 1) goTo(branch, backwards, sums[one[e]] / counts[one[e]]);
        e = one[e];
      }
      ++b;
    }
    for (uint32_t e = 0; e < count; ++e) {
      if (counts[e] > 1) found_.ends[e].point = sums[e] / counts[e];
      found_.ends[e].branches = 0;
    }
    for (const Branch& branch : found_.branches) {
      ++found_.ends[branch.from].branches;
      ++found_.ends[branch.to].branches;
    }
  }

  /// More than 1 where both ends were junctions before, less where one junction was for both.
  double memoryOf(const Branch& branch, double ball) const {
    if (!hints_) return 1;
    const Vec2 ends[2] = {found_.ends[branch.from].point, found_.ends[branch.to].point};
    size_t nearest[2] = {0, 0};
    for (int k = 0; k < 2; ++k) {
      double least = kNearBefore * ball;
      for (size_t i = 0; i < hints_->junctions.size(); ++i) {
        const double here = distance(hints_->junctions[i], ends[k]);
        if (!(here < least)) continue;
        least = here;
        nearest[k] = i + 1;
      }
    }
    if (nearest[0] == 0 || nearest[1] == 0) return 1;
    return nearest[0] == nearest[1] ? 1 / kMemory : kMemory;
  }

  /// Lets a branch begin (or end) elsewhere, by what it has at least as far away.
  void goTo(Branch& branch, bool backwards, Vec2 to) const {
    if (backwards) reverse(branch);
    const double by = distance(branch.line[0], to);
    size_t next = 1;
    while (next + 1 < branch.line.size() && distance(branch.line[next], branch.line[0]) < by)
      ++next;
    if (!segmentInside(region_, to, branch.line[next])) next = 0;
    branch.line.erase(branch.line.begin(), branch.line.begin() + static_cast<long>(next));
    branch.radii.erase(branch.radii.begin() + 1,
                       branch.radii.begin() + static_cast<long>(next ? next : 1));
    branch.line.insert(branch.line.begin(), to);
    if (branch.radii.size() < branch.line.size())
      branch.radii.insert(branch.radii.begin(), branch.radii[0]);
    if (backwards) reverse(branch);
  }

  Mouth mouthOf(const Branch& branch, bool backwards) const {
    Mouth mouth;
    const auto& end = found_.ends[backwards ? branch.to : branch.from];
    if (end.branches < 3) return mouth;
    const View view(branch, backwards);
    const double ball = end.radius, length = lengthOf(branch);
    const double body = view.meanRadius(ball);
    mouth.thin = view.leastRadius(kNeckStretch * ball);
    const auto exit = view.placeAt(ball);
    mouth.towards = exit.point;
    if (!(body > 0) || !exit.within) return mouth;
    mouth.limb = std::clamp((kAsThick - body / ball) / kThinner, 0.0, 1.0) *
                 std::clamp((length - ball) / body, 0.0, 1.0);
    const auto ahead = view.placeAt(std::min(length, ball + kStretch * body));
    const Vec2 back = exit.point - ahead.point;
    const double size = std::sqrt(dot(back, back));
    if (!(size > 0)) return Mouth{};
    // Where the limb's line comes that near to the middle of the ball, or passes it.
    const Vec2 away = exit.point - end.point, line = back / size;
    const double near = -dot(away, line), aside = cross(line, away);
    const double half = kMouth * kMouth * ball * ball - aside * aside;
    const double prolonged = std::max(0.0, near - std::sqrt(std::max(0.0, half)));
    mouth.place = exit.point + line * prolonged;
    mouth.along = ball;
    return mouth;
  }

  Vec2 placeOf(uint32_t e) const {
    const auto& end = found_.ends[e];
    double limbs = 0, bodies = 0;
    Vec2 sum;
    struct Body {
      double share, thin;
      Vec2 towards;
    };
    std::vector<Body> all;
    for (size_t b = 0; b < found_.branches.size(); ++b) {
      for (const bool backwards : {false, true}) {
        if ((backwards ? found_.branches[b].to : found_.branches[b].from) != e) continue;
        const Mouth& mouth = mouths_[b][backwards ? 1 : 0];
        limbs += mouth.limb;
        bodies += 1 - mouth.limb;
        sum = sum + mouth.place * mouth.limb;
        all.push_back({1 - mouth.limb, mouth.thin, mouth.towards});
      }
    }
    if (!(limbs > 1)) return end.point;
    const double pair = std::min(limbs - 1, 1.0);
    Vec2 place = end.point;
    const double last = pair * std::clamp(2 - bodies, 0.0, 1.0);
    place = lerp(place, sum / limbs, kTowardsLimbs * last);
    const double through =
        pair * std::clamp(bodies - 1, 0.0, 1.0) * std::clamp(3 - bodies, 0.0, 1.0);
    for (const Body& neck : all) {
      for (const Body& trunk : all) {
        const double thinner =
            std::clamp((trunk.thin - neck.thin) / (kNeck * end.radius), 0.0, 1.0);
        const double share = std::min(neck.share * trunk.share, 1.0) * through * thinner;
        const Vec2 way = neck.towards - end.point;
        const double size = length(way);
        if (size > 0) place = place + way * (kTowardsNeck * end.radius * share / size);
      }
    }
    return place;
  }

  void redraw(Branch& branch, const std::array<Mouth, 2>& mouths, const std::vector<Vec2>& places) {
    const double length = lengthOf(branch);
    std::array<Mouth, 2> used = mouths;
    // Where both ends want too much of it, it has no mouths.
    if (used[0].along + used[1].along > 0.9 * length) used[0].along = used[1].along = 0;
    for (const bool backwards : {false, true}) {
      const uint32_t e = backwards ? branch.to : branch.from;
      if (!isJunction(e)) continue;
      const Mouth& mouth = used[backwards ? 1 : 0];
      if (backwards) reverse(branch);
      const bool has_mouth = begin(branch, mouth, places[e], found_.ends[e].radius);
      if (backwards) reverse(branch);
      (backwards ? branch.mouth_to : branch.mouth_from) = has_mouth;
    }
  }

  /// Lets the branch begin at a place, and go by its mouth; says whether it does.
  bool begin(Branch& branch, const Mouth& mouth, Vec2 to, double ball) const {
    const View view(branch, false);
    std::vector<Vec2> line{to};
    std::vector<double> radii{branch.radii[0]};
    bool has_mouth = false;
    size_t next = 1;
    if (mouth.along > 0 && mouth.limb > 0) {
      const auto exit = view.placeAt(mouth.along);
      const auto own = view.placeAt(kMouth * ball);
      const Vec2 place = lerp(own.point, mouth.place, mouth.limb);
      if (segmentInside(region_, to, place) && segmentInside(region_, place, exit.point)) {
        line.push_back(place);
        radii.push_back(branch.radii[own.next]);
        if (distance(place, exit.point) > 0.05 * ball) {
          line.push_back(exit.point);
          radii.push_back(branch.radii[exit.next]);
        }
        next = exit.next;
        has_mouth = mouth.limb >= 0.5;
      }
    }
    if (line.size() == 1) {
      const double by = distance(branch.line[0], to);
      while (next + 1 < branch.line.size() && distance(branch.line[next], branch.line[0]) < by)
        ++next;
      if (!segmentInside(region_, to, branch.line[next])) {
        next = 1;
        line.push_back(branch.line[0]);
        radii.push_back(branch.radii[0]);
      }
    }
    line.insert(line.end(), branch.line.begin() + static_cast<long>(next), branch.line.end());
    radii.insert(radii.end(), branch.radii.begin() + static_cast<long>(next), branch.radii.end());
    branch.line = std::move(line);
    branch.radii = std::move(radii);
    return has_mouth;
  }

  const Region& region_;
  AxisBranches& found_;
  const SkeletonHints* hints_;
  std::vector<std::array<Mouth, 2>> mouths_;  // of each branch: at its beginning, at its end
};

// An end nearer to the line than this part of its radius lies on it.
constexpr double kOnLine = 0.05;

class Mirroring {
 public:
  Mirroring(const AxisBranches& from, const MirrorLine& line) : from_(from), line_(line) {}

  std::optional<AxisBranches> run() {
    sides_.reserve(from_.ends.size());
    for (const auto& end : from_.ends) {
      const double side = line_.side(end.point);
      sides_.push_back(std::fabs(side) <= kOnLine * end.radius ? 0 : side > 0 ? 1 : -1);
    }
    renamed_.assign(from_.ends.size(), kNone);
    for (const Branch& branch : from_.branches) {
      const int a = sides_[branch.from], b = sides_[branch.to];
      if (a < 0 || b < 0) {
        if (a > 0 || b > 0) across(branch);
        continue;
      }
      if (a == 0 && b == 0) {
        along(branch);
      } else {
        beside(branch);
      }
      if (failed_) return {};
    }
    if (found_.branches.empty() || found_.ends.size() != found_.branches.size() + 1) return {};
    countBranches();
    while (joinOne()) countBranches();
    dropUnused();
    return std::move(found_);
  }

 private:
  /// The new one, and its image behind it.
  uint32_t endOf(uint32_t e) {
    if (renamed_[e] != kNone) return renamed_[e];
    AxisBranches::End end = from_.ends[e];
    const uint32_t now = static_cast<uint32_t>(found_.ends.size());
    renamed_[e] = now;
    if (sides_[e] == 0) {
      end.point = line_.foot(end.point);
      end.image = now;
      found_.ends.push_back(end);
    } else {
      addPair(end);
    }
    return now;
  }
  uint32_t addPair(AxisBranches::End end) {
    const uint32_t now = static_cast<uint32_t>(found_.ends.size());
    end.image = now + 1;
    found_.ends.push_back(end);
    end.point = line_.mirrored(end.point);
    end.image = now;
    found_.ends.push_back(end);
    return now;
  }

  void along(const Branch& branch) {
    Branch next = branch;
    for (size_t k = 0; k < next.line.size(); ++k) {
      if (std::fabs(line_.side(next.line[k])) > next.radii[k]) failed_ = true;
      next.line[k] = line_.foot(next.line[k]);
    }
    next.from = endOf(branch.from);
    next.to = endOf(branch.to);
    next.image = static_cast<uint32_t>(found_.branches.size());
    found_.branches.push_back(std::move(next));
  }

  void beside(const Branch& branch) {
    Branch next = branch;
    next.from = endOf(branch.from);
    next.to = endOf(branch.to);
    next.line.front() = found_.ends[next.from].point;
    next.line.back() = found_.ends[next.to].point;
    const uint32_t now = static_cast<uint32_t>(found_.branches.size());
    next.image = now + 1;
    found_.branches.push_back(next);
    next.image = now;
    next.from = found_.ends[next.from].image;
    next.to = found_.ends[next.to].image;
    for (Vec2& p : next.line) p = line_.mirrored(p);
    found_.branches.push_back(std::move(next));
  }

  void countBranches() {
    for (auto& end : found_.ends) end.branches = 0;
    for (const Branch& branch : found_.branches) {
      if (branch.line.empty()) continue;  // has become a part of another
      ++found_.ends[branch.from].branches;
      ++found_.ends[branch.to].branches;
    }
  }

  /// Where an end has two branches, as where the one between them was on the other side alone,
  /// these are one; and so are their images.
  bool joinOne() {
    for (uint32_t e = 0; e < found_.ends.size(); ++e) {
      if (found_.ends[e].branches != 2) continue;
      std::vector<uint32_t> both;
      for (uint32_t b = 0; b < found_.branches.size(); ++b) {
        const Branch& branch = found_.branches[b];
        if (!branch.line.empty() && (branch.from == e || branch.to == e)) both.push_back(b);
      }
      const uint32_t image = found_.ends[e].image;
      if (both[0] == found_.branches[both[0]].image && image != e) std::swap(both[0], both[1]);
      const auto [one, other] = std::pair{both[0], both[1]};
      const uint32_t one_image = found_.branches[one].image,
                     other_image = found_.branches[other].image;
      join(one, other, e);
      if (image == e) {  // there and back, or along the line
        found_.branches[one].image = one;
      } else if (other_image == other) {  // across the line
        join(one, one_image, image);
        found_.branches[one].image = one;
      } else {
        join(one_image, other_image, image);
      }
      return true;
    }
    return false;
  }

  /// Puts the second branch behind the first, where both meet.
  void join(uint32_t first, uint32_t second, uint32_t e) {
    Branch &one = found_.branches[first], &other = found_.branches[second];
    if (one.from == e) turn(one);
    if (other.to == e) turn(other);
    one.line.insert(one.line.end(), other.line.begin() + 1, other.line.end());
    one.radii.insert(one.radii.end(), other.radii.begin() + 1, other.radii.end());
    one.to = other.to;
    one.mouth_to = other.mouth_to;
    other.line.clear();
  }
  static void turn(Branch& branch) {
    reverse(branch);
    std::swap(branch.from, branch.to);
    std::swap(branch.mouth_from, branch.mouth_to);
  }

  void dropUnused() {
    std::vector<uint32_t> ends(found_.ends.size()), branches(found_.branches.size());
    uint32_t kept = 0;
    for (uint32_t e = 0; e < ends.size(); ++e) {
      ends[e] = kept;
      if (found_.ends[e].branches > 0) found_.ends[kept++] = found_.ends[e];
    }
    found_.ends.resize(kept);
    for (auto& end : found_.ends) end.image = ends[end.image];
    kept = 0;
    for (uint32_t b = 0; b < branches.size(); ++b) {
      branches[b] = kept;
      if (found_.branches[b].line.empty()) continue;
      if (kept < b) found_.branches[kept] = std::move(found_.branches[b]);
      ++kept;
    }
    found_.branches.resize(kept);
    for (Branch& branch : found_.branches) {
      branch.from = ends[branch.from];
      branch.to = ends[branch.to];
      branch.image = branches[branch.image];
    }
  }

  /// From one side to the other: what lies on the one side from the line on, there and back.
  void across(const Branch& branch) {
    const bool forwards = sides_[branch.to] > 0;
    const size_t count = branch.line.size();
    const auto at = [&](size_t k) { return forwards ? count - 1 - k : k; };
    std::vector<Vec2> line;
    std::vector<double> radii;
    for (size_t k = 0; k < count; ++k) {
      const double side = line_.side(branch.line[at(k)]);
      if (side > 0) {
        line.push_back(branch.line[at(k)]);
        radii.push_back(branch.radii[at(k)]);
        continue;
      }
      const double before = line_.side(line.back()), t = before / (before - side);
      radii.push_back(radii.back() + (branch.radii[at(k)] - radii.back()) * t);
      line.push_back(line_.foot(lerp(line.back(), branch.line[at(k)], t)));
      break;
    }
    Branch next;
    next.to = endOf(forwards ? branch.to : branch.from);
    next.from = found_.ends[next.to].image;
    next.mouth_from = next.mouth_to = forwards ? branch.mouth_to : branch.mouth_from;
    const size_t half = line.size() - 1;
    for (size_t k = 0; k < half; ++k) {
      next.line.push_back(line_.mirrored(line[k]));
      next.radii.push_back(radii[k]);
    }
    for (size_t k = half + 1; k-- > 0;) {
      next.line.push_back(line[k]);
      next.radii.push_back(radii[k]);
    }
    next.image = static_cast<uint32_t>(found_.branches.size());
    found_.branches.push_back(std::move(next));
  }

  const AxisBranches& from_;
  const MirrorLine& line_;
  AxisBranches found_;
  std::vector<int> sides_;         // by end: 1 on the side that is kept, 0 on the line
  std::vector<uint32_t> renamed_;  // by end
  bool failed_ = false;
};

}  // namespace

std::optional<AxisBranches> mirroredBranches(const AxisBranches& branches, const MirrorLine& line) {
  return Mirroring(branches, line).run();
}

AxisBranches branchesOf(const Region& region, const Axis& axis, const SkeletonHints* hints) {
  AxisBranches found = divided(axis);
  Arranging(region, found, hints).run();
  // Those that have become a part of others are gone.
  std::vector<uint32_t> renamed(found.ends.size());
  uint32_t kept = 0;
  for (uint32_t e = 0; e < found.ends.size(); ++e) {
    renamed[e] = kept;
    if (found.ends[e].branches > 0) found.ends[kept++] = found.ends[e];
  }
  found.ends.resize(kept);
  for (Branch& branch : found.branches) {
    branch.from = renamed[branch.from];
    branch.to = renamed[branch.to];
  }
  return found;
}

}  // namespace marrow
