#include "skeleton/branches.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace marrow {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;
// Junctions are one where all ways between them are shorter than this part of their smaller radius.
static const double kOne = std::getenv("ONE") ? std::atof(std::getenv("ONE")) : 0.02;
// A limb is thinner than the ball that it leaves: the less the nearer to this part of its radius,
constexpr double kAsThick = 0.95;
// and wholly a limb from this much thinner on.
constexpr double kThinner = 0.3;
// Its mouth lies between these parts of the ball's radius from the ball's middle,
constexpr double kMouthFrom = 0.45;
constexpr double kMouthTo = 0.9;
// as soon as the limb is nearly as thin as it is on the whole.
constexpr double kNearlyThin = 1.25;
// The way from the middle of a body's last ball to between its limbs that their joint takes.
static const double kTowardsLimbs = std::getenv("TOWARDS") ? std::atof(std::getenv("TOWARDS")) : 0;

using Branch = AxisBranches::Branch;

double lengthOf(const Branch& branch) {
  double sum = 0;
  for (size_t k = 0; k + 1 < branch.line.size(); ++k) {
    sum += distance(branch.line[k], branch.line[k + 1]);
  }
  return sum;
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

class Arranging {
 public:
  Arranging(const Region& region, AxisBranches& found) : region_(region), found_(found) {}

  void run() {
    unite();
    for (uint32_t e = 0; e < found_.ends.size(); ++e) {
      if (found_.ends[e].branches < 3) continue;
      const Vec2 from = found_.ends[e].point, to = towardsLimbs(e);
      for (const double part : {1.0, 0.5, 0.25}) {
        if (!canMove(e, lerp(from, to, part))) continue;
        move(e, e, lerp(from, to, part));
        break;
      }
    }
  }

 private:
  void unite() {
    struct Junction {
      Vec2 point;
      double radius;
      std::vector<double> ways;  // to all
    };
    const size_t count = found_.ends.size();
    std::vector<std::vector<double>> ways(count);
    for (uint32_t e = 0; e < count; ++e) {
      if (found_.ends[e].branches > 2) ways[e] = waysFrom(e);
    }
    std::vector<std::vector<uint32_t>> members(count);
    for (uint32_t e = 0; e < count; ++e) members[e] = {e};
    const std::vector<AxisBranches::End> were = found_.ends;
    static const int kMode = std::getenv("MODE") ? std::atoi(std::getenv("MODE")) : 2;
    std::vector<uint32_t> group(count, kNone);
    if (kMode == 1) {  // largest ball first
      std::vector<uint32_t> order;
      for (uint32_t e = 0; e < count; ++e) if (were[e].branches > 2) order.push_back(e);
      std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return were[a].radius > were[b].radius; });
      for (const uint32_t e : order) {
        if (group[e] != kNone) continue;
        group[e] = e;
        for (const uint32_t o : order) if (group[o] == kNone && ways[e][o] < kOne * std::min(were[e].radius, were[o].radius)) group[o] = e;
      }
    }
    for (;;) {
      double least = kMode == 1 ? 1e9 : kOne;
      size_t best = found_.branches.size();
      for (size_t b = 0; b < found_.branches.size(); ++b) {
        const Branch& branch = found_.branches[b];
        if (found_.ends[branch.from].branches < 3 || found_.ends[branch.to].branches < 3) continue;
        double ratio = kMode == 2 ? 1e9 : 0;
        for (const uint32_t i : members[branch.from]) {
          for (const uint32_t j : members[branch.to]) {
            const double r = ways[i][j] / std::min(were[i].radius, were[j].radius);
            if (kMode == 2) ratio = std::min(ratio, r); else ratio = std::max(ratio, r);
          }
        }
        if (kMode == 1 && group[members[branch.from][0]] != group[members[branch.to][0]]) continue;
        if (!(ratio < least)) continue;
        Vec2 sum;
        double all = 0;
        for (const uint32_t e : {branch.from, branch.to}) {
          for (const uint32_t i : members[e]) {
            sum = sum + were[i].point;
            ++all;
          }
        }
        if (!canUnite(b, sum / all)) continue;
        least = ratio;
        best = b;
        middle_ = sum / all;
      }
      if (best == found_.branches.size()) return;
      const uint32_t from = found_.branches[best].from, to = found_.branches[best].to;
      members[from].insert(members[from].end(), members[to].begin(), members[to].end());
      contract(best, middle_);
    }
  }

  /// Along the axis, to all ends.
  std::vector<double> waysFrom(uint32_t start) const {
    std::vector<double> ways(found_.ends.size(), -1);
    ways[start] = 0;
    std::vector<uint32_t> todo{start};
    while (!todo.empty()) {
      const uint32_t e = todo.back();
      todo.pop_back();
      for (const Branch& branch : found_.branches) {
        if (branch.from != e && branch.to != e) continue;
        const uint32_t other = branch.from == e ? branch.to : branch.from;
        if (ways[other] >= 0) continue;
        ways[other] = ways[e] + lengthOf(branch);
        todo.push_back(other);
      }
    }
    return ways;
  }

  /// The end of a body between two limbs or more: their joint lies nearer to them than the middle
  /// of the body's last ball does.
  Vec2 towardsLimbs(uint32_t e) const {
    const auto& end = found_.ends[e];
    double limbs = 0, bodies = 0;
    Vec2 sum;
    for (const Branch& branch : found_.branches) {
      if (branch.from != e && branch.to != e) continue;
      const auto [weight, mouth] = mouthOf({branch, branch.to == e}, end.radius);
      limbs += weight;
      bodies += 1 - weight;
      sum = sum + mouth * weight;
    }
    const double often = std::clamp(limbs - 1, 0.0, 1.0) * std::clamp(2 - bodies, 0.0, 1.0);
    return often > 0 ? lerp(end.point, sum / limbs, kTowardsLimbs * often) : end.point;
  }

  /// A branch seen from one of its ends.
  struct View {
    const Branch& branch;
    bool backwards;
    size_t count() const { return branch.line.size(); }
    size_t at(size_t k) const { return backwards ? count() - 1 - k : k; }
    Vec2 point(size_t k) const { return branch.line[at(k)]; }
    double radius(size_t k) const { return branch.radii[at(k)]; }
  };

  /// How much of a limb a branch is, 0 … 1, and where it leaves the ball that it begins in.
  static std::pair<double, Vec2> mouthOf(const View& view, double ball) {
    double along = 0, sum = 0, length = 0;
    for (size_t k = 1; k < view.count(); ++k) {
      const double step = distance(view.point(k - 1), view.point(k));
      along += step;
      if (along <= ball) continue;
      sum += step * (view.radius(k - 1) + view.radius(k)) / 2;
      length += step;
    }
    if (!(length > 0)) return {0, view.point(0)};
    const double body = sum / length;
    const double weight = std::clamp((kAsThick - body / ball) / kThinner, 0.0, 1.0) *
                          std::clamp((along - kMouthTo * ball) / body, 0.0, 1.0);
    along = 0;
    for (size_t k = 1; k < view.count(); ++k) {
      const double step = distance(view.point(k - 1), view.point(k));
      if (along + step >= kMouthTo * ball) {
        return {weight, lerp(view.point(k - 1), view.point(k), (kMouthTo * ball - along) / step)};
      }
      along += step;
      if (along < kMouthFrom * ball || view.radius(k) > kNearlyThin * body) continue;
      return {weight, view.point(k)};
    }
    return {0, view.point(0)};
  }

  /// The first point of a line, from its end in a junction on, that stays where the junction moves:
  /// one as far away from where it was as it moves, at least.
  size_t firstKept(const View& view, Vec2 to) const {
    const double by = distance(view.point(0), to);
    size_t k = 1;
    while (k + 1 < view.count() && distance(view.point(k), view.point(0)) < by) ++k;
    return k;
  }

  bool canMove(uint32_t e, Vec2 to) const {
    for (const Branch& branch : found_.branches) {
      for (const bool backwards : {false, true}) {
        if ((backwards ? branch.to : branch.from) != e) continue;
        const View view{branch, backwards};
        if (!segmentInside(region_, to, view.point(firstKept(view, to)))) return false;
      }
    }
    return true;
  }

  /// All branches at `e` go to `other` at the point.
  void move(uint32_t e, uint32_t other, Vec2 to) {
    for (Branch& branch : found_.branches) {
      for (const bool backwards : {false, true}) {
        uint32_t& own = backwards ? branch.to : branch.from;
        if (own != e) continue;
        own = other;
        const auto cut = static_cast<long>(firstKept({branch, backwards}, to));
        if (backwards) {
          branch.line.erase(branch.line.end() - cut, branch.line.end() - 1);
          branch.radii.erase(branch.radii.end() - cut, branch.radii.end() - 1);
          branch.line.back() = to;
        } else {
          branch.line.erase(branch.line.begin() + 1, branch.line.begin() + cut);
          branch.radii.erase(branch.radii.begin() + 1, branch.radii.begin() + cut);
          branch.line.front() = to;
        }
      }
    }
    found_.ends[other].point = to;
  }

  bool canUnite(size_t b, Vec2 middle) const {
    const Branch& branch = found_.branches[b];
    for (const uint32_t e : {branch.from, branch.to}) {
        for (size_t other = 0; other < found_.branches.size(); ++other) {
        if (other == b) continue;
        for (const bool backwards : {false, true}) {
          const Branch& one = found_.branches[other];
          if ((backwards ? one.to : one.from) != e) continue;
          const View view{one, backwards};
          if (!segmentInside(region_, middle, view.point(firstKept(view, middle)))) return false;
        }
      }
    }
    return true;
  }

  void contract(size_t b, Vec2 middle) {
    const Branch branch = std::move(found_.branches[b]);
    found_.branches.erase(found_.branches.begin() + static_cast<long>(b));
    auto &stays = found_.ends[branch.from], &goes = found_.ends[branch.to];
    stays.branches += goes.branches - 2;
    stays.radius = std::max(stays.radius, goes.radius);
    goes.branches = 0;
    move(branch.from, branch.from, middle);
    move(branch.to, branch.from, middle);
  }

  const Region& region_;
  AxisBranches& found_;
  Vec2 middle_;
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

  /// Where an end has two branches, as where the one between them was on the other side alone, these
  /// are one; and so are their images.
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
      const uint32_t one_image = found_.branches[one].image, other_image = found_.branches[other].image;
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
    if (one.from == e) reverse(one);
    if (other.to == e) reverse(other);
    one.line.insert(one.line.end(), other.line.begin() + 1, other.line.end());
    one.radii.insert(one.radii.end(), other.radii.begin() + 1, other.radii.end());
    one.to = other.to;
    other.line.clear();
  }
  static void reverse(Branch& branch) {
    std::reverse(branch.line.begin(), branch.line.end());
    std::reverse(branch.radii.begin(), branch.radii.end());
    std::swap(branch.from, branch.to);
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

AxisBranches branchesOf(const Region& region, const Axis& axis) {
  AxisBranches found = divided(axis);
  Arranging(region, found).run();
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
