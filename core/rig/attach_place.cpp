#include "rig/attach_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kTie = 1e-9;

// Places that are tried on each bone besides those where bones are nearest to each other.
constexpr int kSteps = 8;
// What it costs to hang beside the overlap, and away from its middle, × the length of the
// connecting bone that is saved by it.
constexpr double kBeside = 2, kOffMiddle = 0.1;
// Of the ball around an end or a junction, what counts as there.
constexpr double kAtJoint = 1, kBesideAtJoint = 0.25;
constexpr int kInsideSteps = 16;

bool isWithin(double t) { return t > kTie && t < 1 - kTie; }

/// A place on a skeleton.
struct Spot {
  uint32_t bone = 0;
  double t = 0;
};

void hangBy(const PartProxy& child, uint32_t joint, Connection& connection) {
  connection.child_split = false;
  connection.child_joint = joint;
  connection.child_bone = 0;
  connection.child_along = 0;
  connection.child_position = child.points[joint];
}

void hangBy(const PartProxy& child, Spot spot, Connection& connection) {
  const auto& [a, b] = child.skeleton->bones[spot.bone];
  if (!isWithin(spot.t)) return hangBy(child, spot.t < 0.5 ? a : b, connection);
  connection.child_split = true;
  connection.child_joint = a;
  connection.child_bone = spot.bone;
  connection.child_along = spot.t;
  connection.child_position = child.on(spot.bone, spot.t);
}

class Placing {
 public:
  Placing(const AttachSide& child, const AttachSide& parent)
      : child_(child),
        parent_(parent),
        tie_(kTie * (child.proxy.size + parent.proxy.size)),
        overlap_(bodyOverlap(child.body, parent.body)) {}

  void run(Connection& connection) {
    findNearest();
    collectSpots(exactCost(takeBest()));
    Connection best = connection;
    double least_outside = kFar;
    choose(connection, best, least_outside);
    if (least_outside > 0) {
      // All there are, for the one that leaves the bodies least.
      collectSpots(kFar);
      choose(connection, best, least_outside);
    }
    connection = best;
    if (connection.child_split) moveToJoint(connection, least_outside);
  }

 private:
  /// Where each bone of the child is nearest to the parent, and where to the overlap's middle.
  void findNearest() {
    const auto &bones = child_.proxy.skeleton->bones, &others = parent_.proxy.skeleton->bones;
    away_.assign(bones.size(), kFar);
    for (uint32_t k = 0; k < bones.size(); ++k) {
      Spot nearest{k, 0};
      for (uint32_t other = 0; other < others.size(); ++other) {
        const auto [s, t] = nearestOnBones(child_.proxy, k, parent_.proxy, other);
        const double d = distance(child_.proxy.on(k, s), parent_.proxy.on(other, t));
        if (!(d < away_[k] - tie_)) continue;
        away_[k] = d;
        nearest.t = s;
      }
      addSpot(nearest);
      if (overlap_.points.empty()) continue;
      addSpot({k, nearestAlong(child_.proxy.on(k, 0), child_.proxy.on(k, 1), overlap_.middle)});
    }
    nearest_count_ = spots_.size();
  }

  /// The same, and steps on each bone that can hold a place as good as `enough`.
  void collectSpots(double enough) {
    spots_.resize(nearest_count_);
    costs_.resize(nearest_count_);
    whole_.resize(nearest_count_);
    for (size_t i = 0; i < nearest_count_; ++i) {
      costs_[i] = costOf(spots_[i]);
      whole_[i] = overlap_.points.empty();
    }
    for (uint32_t k = 0; k < away_.size(); ++k) {
      if (away_[k] > enough + tie_) continue;
      for (int i = 0; i <= kSteps; ++i) addSpot({k, static_cast<double>(i) / kSteps});
    }
  }

  /// The best of those whose bone stays inside; or whose bone leaves the bodies least.
  void choose(const Connection& connection, Connection& best, double& least_outside) {
    for (size_t tries = spots_.size(); tries > 0; --tries) {
      const size_t i = takeBest();
      Connection here = connection;
      hangBy(child_.proxy, spots_[i], here);
      placeOnParent(parent_.proxy, here.child_position, here);
      double outside = outsideOf(here);
      if (outside > 0) outside = tryOtherBones(here, outside);
      if (!(outside < least_outside)) continue;
      least_outside = outside;
      best = here;
      if (outside == 0) break;
    }
  }

  void addSpot(Spot spot) {
    spots_.push_back(spot);
    costs_.push_back(costOf(spot));
    whole_.push_back(overlap_.points.empty());
  }

  /// Without what it costs to be beside the overlap.
  double costOf(Spot spot) const {
    const Vec3 p = child_.proxy.on(spot.bone, spot.t);
    Connection there;
    const double cost = placeOnParent(parent_.proxy, p, there);
    return overlap_.points.empty() ? cost : cost + kOffMiddle * distance(p, overlap_.middle);
  }
  double exactCost(size_t spot) const {
    return costOf(spots_[spot]) +
           kBeside * besideOverlap(child_.proxy.on(spots_[spot].bone, spots_[spot].t));
  }

  /// Of those that were not yet taken, the first on a tie: rounding must not decide, or twins would
  /// hang by different places.
  size_t takeBest() {
    while (true) {
      size_t best = 0;
      for (size_t i = 1; i < costs_.size(); ++i) {
        if (costs_[i] < costs_[best] - tie_) best = i;
      }
      // How far beside the overlap a place is takes long, and most are too bad without it.
      if (whole_[best]) {
        costs_[best] = kFar;
        return best;
      }
      whole_[best] = true;
      costs_[best] = exactCost(best);
    }
  }

  double besideOverlap(Vec3 p) const {
    if (overlap_.points.empty()) return 0;
    if (parent_.body.contains(p) && child_.body.contains(p)) return 0;
    double nearest = kFar;
    for (const Vec3 point : overlap_.points) {
      const Vec3 d = p - point;
      nearest = std::min(nearest, dot(d, d));
    }
    return std::sqrt(nearest);
  }

  /// How much of the connecting bone is in neither body, world.
  double outsideOf(const Connection& connection) const {
    if (overlap_.points.empty()) return 0;
    const Vec3 from = connection.parent_position, to = connection.child_position;
    int outside = 0;
    for (int i = 0; i <= kInsideSteps; ++i) {
      const Vec3 p = lerp(from, to, static_cast<double>(i) / kInsideSteps);
      outside += !child_.body.contains(p) && !parent_.body.contains(p);
    }
    return distance(from, to) * outside / (kInsideSteps + 1);
  }

  /// Other bones of the parent than the nearest one, for what would leave the bodies; the nearest
  /// one of those that leave them least.
  double tryOtherBones(Connection& connection, double outside) const {
    const PartProxy& parent = parent_.proxy;
    double nearest = kFar;
    for (uint32_t k = 0; k < parent.skeleton->bones.size(); ++k) {
      const Vec3 p = connection.child_position;
      for (const Vec3 towards : {p, overlap_.middle}) {
        const double t = nearestAlong(parent.on(k, 0), parent.on(k, 1), towards);
        Connection there = connection;
        placeOnParent(parent, parent.on(k, t), there);
        const double leaves = outsideOf(there), d = distance(there.parent_position, p);
        const bool less = leaves < outside - tie_;
        if (!less && !(leaves < outside + tie_ && d < nearest - tie_ && nearest < kFar)) continue;
        connection = there;
        outside = leaves;
        nearest = d;
      }
    }
    return outside;
  }

  /// A bone that is shorter than its ball is thick is of no use.
  void moveToJoint(Connection& connection, double outside) const {
    const PartProxy& child = child_.proxy;
    const double beside = besideOverlap(connection.child_position);
    double nearest = kFar;
    Connection best = connection;
    for (uint32_t j = 0; j < child.points.size(); ++j) {
      if (!child.isEnd(j)) continue;
      const double d = distance(child.points[j], connection.child_position);
      if (!(d < kAtJoint * child.radii[j]) || !(d < nearest - tie_)) continue;
      if (besideOverlap(child.points[j]) > beside + kBesideAtJoint * child.radii[j]) continue;
      Connection there = connection;
      hangBy(child, j, there);
      placeOnParent(parent_.proxy, there.child_position, there);
      if (outsideOf(there) > outside + tie_) continue;
      nearest = d;
      best = there;
    }
    connection = best;
  }

  const AttachSide &child_, &parent_;
  const double tie_;
  const BodyOverlap overlap_;
  std::vector<double> away_;  // by bone of the child: from the nearest bone of the parent
  std::vector<Spot> spots_;
  size_t nearest_count_ = 0;   // spots of findNearest
  std::vector<double> costs_;  // infinite where taken
  std::vector<char> whole_;    // whether the cost is more than a lower bound
};

}  // namespace

void placeAtOverlap(const AttachSide& child, const AttachSide& parent, Connection& connection) {
  Placing(child, parent).run(connection);
}

double placeOnParent(const PartProxy& parent, Vec3 p, Connection& connection) {
  const auto& bones = parent.skeleton->bones;
  double nearest = kFar;
  for (uint32_t k = 0; k < bones.size(); ++k) {
    const Vec3 a = parent.points[bones[k][0]], b = parent.points[bones[k][1]];
    const double t = nearestAlong(a, b, p);
    const Vec3 foot = lerp(a, b, t);
    const double d = distance(foot, p);
    if (!(d < nearest - kTie * parent.size)) continue;
    nearest = d;
    const bool split = isWithin(t);
    connection.event = split ? AttachEvent::split : AttachEvent::connect;
    connection.parent_joint = split || t < 0.5 ? bones[k][0] : bones[k][1];
    connection.parent_bone = split ? k : 0;
    connection.along = split ? t : 0;
    connection.parent_position = split ? foot : parent.points[connection.parent_joint];
  }
  return nearest;
}

void placeOnChild(const PartProxy& child, Vec3 p, Connection& connection) {
  double nearest = kFar;
  for (uint32_t k = 0; k < child.skeleton->bones.size(); ++k) {
    const double t = nearestAlong(child.on(k, 0), child.on(k, 1), p);
    const double d = distance(child.on(k, t), p);
    if (!(d < nearest - kTie * child.size)) continue;
    nearest = d;
    hangBy(child, {k, t}, connection);
  }
  if (!connection.child_split) return;
  const Vec3 at = connection.child_position;
  nearest = kFar;
  for (uint32_t j = 0; j < child.points.size(); ++j) {
    const double d = distance(child.points[j], at);
    if (!child.isEnd(j) || !(d < kAtJoint * child.radii[j])) continue;
    if (!(d < nearest - kTie * child.size)) continue;
    nearest = d;
    hangBy(child, j, connection);
  }
}

}  // namespace marrow
