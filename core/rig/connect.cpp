#include "rig/connect.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.h"
#include "rig/body_overlap.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;
constexpr double kFar = std::numeric_limits<double>::infinity();
// What differs by less than this part of its scale is equal: rounding must not decide who holds a
// part, or the twins of a symmetric creature would part company.
constexpr double kTie = 1e-9;
// By this share of the smaller radius.
constexpr double kPlainlyAway = 1;
// Bones whose directions differ by a smaller sine are parallel: measured at their ends alone.
constexpr double kParallel = 1e-5;

/// The box around a part's body in space.
Box3 bodyBox(const RigPart& part) {
  Box3 box;
  const Relief& relief = part.part->relief;
  const double high = relief.highest() * part.source->thickness;
  const double low = relief.lowest() * part.source->thickness;
  for (int corner = 0; corner < 8; ++corner) {
    box.include(part.placed->frame.toWorld(Vec3{corner & 1 ? relief.high().x : relief.low().x,
                                                corner & 2 ? relief.high().y : relief.low().y,
                                                corner & 4 ? high : low}));
  }
  return box;
}

/// A part's balls and cones in space.
struct Proxy {
  bool exists = false;
  bool holds = false;  // has bones that something can hang on
  std::vector<Vec3> points;
  std::vector<double> radii;
  const PartSkeleton* skeleton = nullptr;
  Box3 box, body;   // around them, and around the part's body
  double size = 0;  // of the box

  bool isEnd(size_t joint) const { return skeleton->joints[joint].kind != JointKind::sleeve; }
};

Proxy proxyOf(const RigPart& part) {
  Proxy proxy;
  if (!part.part || part.part->skeleton.bones.empty()) return proxy;
  proxy.exists = true;
  proxy.holds = part.source->skeleton;
  proxy.skeleton = &part.part->skeleton;
  proxy.body = bodyBox(part);
  const Frame& frame = part.placed->frame;
  const double scale = frame.scale();
  const auto& joints = proxy.skeleton->joints;
  proxy.points.reserve(joints.size());
  proxy.radii.reserve(joints.size());
  for (const auto& joint : joints) {
    const Vec3 p = frame.toWorld(joint.place());
    const double r = joint.radius * scale;
    proxy.points.push_back(p);
    proxy.radii.push_back(r);
    proxy.box.include(p - Vec3{r, r, r});
    proxy.box.include(p + Vec3{r, r, r});
  }
  // A little larger, so that no decision is ever the box's.
  proxy.size = length(proxy.box.size());
  const double margin = 1e-6 * proxy.size;
  proxy.box.low = proxy.box.low - Vec3{margin, margin, margin};
  proxy.box.high = proxy.box.high + Vec3{margin, margin, margin};
  return proxy;
}

/// Where on a → b the point nearest to p is, 0 … 1.
double nearestAlong(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  const double whole = dot(along, along);
  return whole > 0 ? std::clamp(dot(p - a, along) / whole, 0.0, 1.0) : 0;
}

/// How deep a point is in the cones, relative to the radius there: 1 on a bone, 0 at the surface.
double penetration(const Proxy& proxy, Vec3 p) {
  double best = -kFar;
  for (const auto& [a, b] : proxy.skeleton->bones) {
    const double t = nearestAlong(proxy.points[a], proxy.points[b], p);
    const double r = proxy.radii[a] + (proxy.radii[b] - proxy.radii[a]) * t;
    if (!(r > 0)) continue;
    best = std::max(best, 1 - distance(lerp(proxy.points[a], proxy.points[b], t), p) / r);
  }
  return best;
}

struct Cone {
  Vec3 a, b;
  double radius_a, radius_b;
};

Cone coneOf(const Proxy& proxy, const std::array<uint32_t, 2>& bone) {
  return {proxy.points[bone[0]], proxy.points[bone[1]], proxy.radii[bone[0]], proxy.radii[bone[1]]};
}

/// By how much the balls at s and t of two bones overlap, relative to the smaller one.
double overlapAt(const Cone& one, double s, const Cone& other, double t) {
  const double r = one.radius_a + (one.radius_b - one.radius_a) * s;
  const double q = other.radius_a + (other.radius_b - other.radius_a) * t;
  if (!(std::min(r, q) > 0)) return -kFar;
  const double d = distance(lerp(one.a, one.b, s), lerp(other.a, other.b, t));
  return (r + q - d) / std::min(r, q);
}

double overlap(const Cone& one, const Cone& other) {
  // Two segments are nearest to each other at an end of one of them or where both are crossed.
  double best = std::max({overlapAt(one, 0, other, nearestAlong(other.a, other.b, one.a)),
                          overlapAt(one, 1, other, nearestAlong(other.a, other.b, one.b)),
                          overlapAt(one, nearestAlong(one.a, one.b, other.a), other, 0),
                          overlapAt(one, nearestAlong(one.a, one.b, other.b), other, 1)});
  const Vec3 u = one.b - one.a, v = other.b - other.a, w = one.a - other.a;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double sine = uu * vv - uv * uv;
  if (sine > kParallel * kParallel * uu * vv) {
    const double s = (uv * vw - vv * uw) / sine, t = (uu * vw - uv * uw) / sine;
    if (s > 0 && s < 1 && t > 0 && t < 1) best = std::max(best, overlapAt(one, s, other, t));
  }
  return best;
}

bool farApart(const Cone& one, const Cone& other) {
  const Vec3 d = (one.a + one.b - other.a - other.b) * 0.5;
  const double reach = 0.5 * (distance(one.a, one.b) + distance(other.a, other.b)) +
                       std::max(one.radius_a, one.radius_b) +
                       std::max(other.radius_a, other.radius_b);
  return dot(d, d) > reach * reach;
}

double overlap(const Proxy& child, const Proxy& parent) {
  double best = -kFar;
  for (const auto& bone : child.skeleton->bones) {
    const Cone one = coneOf(child, bone);
    for (const auto& other_bone : parent.skeleton->bones) {
      const Cone other = coneOf(parent, other_bone);
      if (!farApart(one, other)) best = std::max(best, overlap(one, other));
    }
  }
  return best;
}

class Connecting {
 public:
  Connecting(const std::vector<RigPart>& parts, const ConnectOptions& options)
      : parts_(parts), options_(options) {
    const size_t count = parts.size();
    proxies_.reserve(count);
    for (const RigPart& part : parts) proxies_.push_back(proxyOf(part));
    parent_.assign(count, kNone);
    free_.resize(count);
    image_.assign(count, kNone);
    for (uint32_t i = 0; i < count; ++i) {
      free_[i] = proxies_[i].exists;
      if (i == 0 || parts[i].source != parts[i - 1].source) continue;
      if (parts[i].placed->twin == parts[i - 1].placed->twin) continue;
      image_[i] = i - 1;
      image_[i - 1] = i;
    }
  }

  std::vector<Connection> run() {
    const uint32_t count = static_cast<uint32_t>(parts_.size());
    for (uint32_t i = 0; i < count; ++i) {
      if (proxies_[i].exists && parts_[i].source->attachment) attachAsTold(i);
    }
    for (uint32_t i = 0; i < count; ++i) {
      if (free_[i]) attach(i, 0, i);
    }
    for (uint32_t i = 0; i < count; ++i) {
      if (free_[i] && image_[i] != kNone && !free_[image_[i]]) attachLikeImage(i);
    }
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t image = image_[i];
      if (free_[i] && image < i && free_[image] && canHold(image, i)) attachTo(i, {image});
    }
    for (uint32_t i = 0; i < count; ++i) {
      if (free_[i]) attach(i, i + 1, count);
    }
    std::sort(result_.begin(), result_.end(),
              [](const Connection& a, const Connection& b) { return a.child < b.child; });
    return std::move(result_);
  }

 private:
  uint32_t treeOf(uint32_t part) const {
    while (parent_[part] != kNone) part = parent_[part];
    return part;
  }
  bool canHold(uint32_t parent, uint32_t child) const {
    return proxies_[parent].holds && treeOf(parent) != child;
  }

  bool isTakenOff(uint32_t part) const {
    const auto& told = parts_[part].source->attachment;
    return told && told->part.empty();
  }

  void attachAsTold(uint32_t child) {
    if (isTakenOff(child)) {
      free_[child] = false;
      return;
    }
    const Attachment& told = *parts_[child].source->attachment;
    uint32_t parent = kNone;
    for (uint32_t i = 0; i < parts_.size() && parent == kNone; ++i) {
      if (parts_[i].placed->id == told.part) parent = i;
    }
    if (parent == kNone || !proxies_[parent].holds) return;
    const bool twin = parts_[child].placed->twin;
    const bool swap = twin && image_[parent] != kNone;
    if (swap) parent = image_[parent];
    if (!canHold(parent, child)) return;
    Vec3 at = parts_[parent].placed->frame.toWorld(told.at);
    if (twin && !swap && parts_[child].source->mirror) {
      at = mirrored(at, *parts_[child].source->mirror);
    }
    Connection connection;
    connection.child = child;
    connection.parent = parent;
    connection.test = AttachTest::user;
    placeOn(at, connection);
    double nearest = kFar;
    const Proxy& proxy = proxies_[child];
    for (uint32_t j = 0; j < proxy.points.size(); ++j) {
      if (!proxy.isEnd(j)) continue;
      const double d = distance(proxy.points[j], connection.parent_position);
      if (d < nearest - kTie * proxy.size) {
        nearest = d;
        connection.child_joint = j;
        connection.child_position = proxy.points[j];
      }
    }
    add(connection);
  }

  /// Tests a part against those from `first` to before `end`, the mirror image of each pair that
  /// its own image prefers first, so that what is a tie for both goes to either side.
  void attach(uint32_t child, uint32_t first, uint32_t end) {
    candidates_.clear();
    const bool swap = parts_[child].placed->twin;
    for (uint32_t i = first; i < end; ++i) {
      uint32_t other = i;
      if (swap && image_[i] != kNone && image_[i] >= first && image_[i] < end) other = image_[i];
      if (other == child || other == image_[child]) continue;
      const Proxy &one = proxies_[child], &two = proxies_[other];
      if (!one.box.meets(two.box) && !one.body.meets(two.body)) continue;
      // Who holds whom takes as long to find as chains are long: asked of neighbours alone.
      if (!canHold(other, child)) continue;
      // What the user took off is not to be taken back from the other side.
      if (other > child && isTakenOff(treeOf(other))) continue;
      candidates_.push_back(other);
    }
    attachTo(child, candidates_);
  }

  void attachTo(uint32_t child, const std::vector<uint32_t>& candidates) {
    const Proxy& proxy = proxies_[child];
    Connection connection;
    connection.child = child;
    double best = kTie;
    connection.parent = kNone;
    for (const uint32_t candidate : candidates) {
      const Proxy& other = proxies_[candidate];
      for (size_t j = 0; j < proxy.points.size(); ++j) {
        if (!proxy.isEnd(j) || !other.box.has(proxy.points[j])) continue;
        const double depth = penetration(other, proxy.points[j]);
        if (!(depth > best)) continue;
        if (connection.parent != candidate && !(depth > best + kTie)) continue;
        best = depth;
        connection.parent = candidate;
      }
    }
    if (connection.parent == kNone) {
      connection.test = AttachTest::overlap;
      best = options_.overlap;
      for (const uint32_t candidate : candidates) {
        const double depth = overlap(proxy, proxies_[candidate]);
        if (!(depth > best + kTie)) continue;
        best = depth;
        connection.parent = candidate;
      }
    }
    if (connection.parent == kNone) {
      best = 0;
      for (const uint32_t candidate : candidates) {
        if (!proxy.body.meets(proxies_[candidate].body)) continue;
        const double share = bodyOverlap(parts_[child], parts_[candidate]);
        if (!(share > best + kTie)) continue;
        best = share;
        connection.parent = candidate;
      }
    }
    if (connection.parent == kNone) return;
    placeNearest(connection);
    add(connection);
  }

  /// Where a part lies just on the verge, rounding must not tell it from its twin.
  void attachLikeImage(uint32_t child) {
    const auto found = std::find_if(
        result_.begin(), result_.end(),
        [&](const Connection& connection) { return connection.child == image_[child]; });
    if (found == result_.end() || found->test == AttachTest::user) return;
    const uint32_t mirrored_parent = image_[found->parent];
    Connection connection;
    connection.child = child;
    connection.parent = mirrored_parent == kNone ? found->parent : mirrored_parent;
    connection.test = found->test;
    if (!canHold(connection.parent, child)) return;
    if (!(overlap(proxies_[child], proxies_[connection.parent]) > -kPlainlyAway)) return;
    placeNearest(connection);
    add(connection);
  }

  void add(const Connection& connection) {
    // What has no bones of its own holds nothing, so it stays out of the trees.
    if (proxies_[connection.child].holds) parent_[connection.child] = connection.parent;
    free_[connection.child] = false;
    result_.push_back(connection);
  }

  /// Over all ends of the child. [Equation 3, with |v_i v_k| sin θ]
  void placeNearest(Connection& connection) const {
    const Proxy &child = proxies_[connection.child], &parent = proxies_[connection.parent];
    double nearest = kFar;
    Connection best = connection;
    for (uint32_t j = 0; j < child.points.size(); ++j) {
      if (!child.isEnd(j)) continue;
      const double d = placeOn(child.points[j], connection);
      if (!(d < nearest - kTie * parent.size)) continue;
      nearest = d;
      best = connection;
      best.child_joint = j;
      best.child_position = child.points[j];
    }
    connection = best;
  }

  /// Fills in the place on the parent's skeleton nearest to p; gives its distance.
  double placeOn(Vec3 p, Connection& connection) const {
    const Proxy& parent = proxies_[connection.parent];
    const auto& bones = parent.skeleton->bones;
    double nearest = kFar;
    for (uint32_t k = 0; k < bones.size(); ++k) {
      const Vec3 a = parent.points[bones[k][0]], b = parent.points[bones[k][1]];
      const double t = nearestAlong(a, b, p);
      const Vec3 foot = lerp(a, b, t);
      const double d = distance(foot, p);
      if (!(d < nearest - kTie * parent.size)) continue;
      nearest = d;
      const bool split = t > kTie && t < 1 - kTie;
      connection.event = split ? AttachEvent::split : AttachEvent::connect;
      connection.parent_joint = split || t < 0.5 ? bones[k][0] : bones[k][1];
      connection.parent_bone = split ? k : 0;
      connection.along = split ? t : 0;
      connection.parent_position = split ? foot : parent.points[connection.parent_joint];
    }
    return nearest;
  }

  const std::vector<RigPart>& parts_;
  const ConnectOptions& options_;
  std::vector<Proxy> proxies_;
  std::vector<uint32_t> parent_;  // of the trees so far
  std::vector<uint32_t> image_;   // the other one of a part and its twin
  std::vector<char> free_;        // may still be attached
  std::vector<uint32_t> candidates_;
  std::vector<Connection> result_;
};

}  // namespace

std::vector<Connection> connectParts(const std::vector<RigPart>& parts,
                                     const ConnectOptions& options) {
  return Connecting(parts, options).run();
}

}  // namespace marrow
