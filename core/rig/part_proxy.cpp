#include "rig/part_proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// Bones whose directions differ by a smaller sine are parallel: measured at their ends alone.
constexpr double kParallel = 1e-5;

/// Calls visit with radii and distance at places where two bones are nearest to each other. Not
/// for bones whose cones are further apart than `room` × their reach.
template <typename Visit>
void forNearBones(const PartProxy& one, const PartProxy& other, double room, const Visit& visit) {
  const auto tryAt = [&](uint32_t a, double s, uint32_t b, double t) {
    visit(one.radiusOn(a, s), other.radiusOn(b, t), distance(one.on(a, s), other.on(b, t)));
  };
  for (uint32_t a = 0; a < one.middles.size(); ++a) {
    const Vec3 beyond =
        most(most(other.box.low - one.middles[a], one.middles[a] - other.box.high), Vec3{});
    const double own = (2 * room - 1) * one.reaches[a] + (room - 1) * other.size;
    if (dot(beyond, beyond) > own * own) continue;
    for (uint32_t b = 0; b < other.middles.size(); ++b) {
      const Vec3 d = one.middles[a] - other.middles[b];
      const double reach = room * (one.reaches[a] + other.reaches[b]);
      if (dot(d, d) > reach * reach) continue;
      // Balls of other sizes overlap more beside the nearest place; that of the ends is enough.
      for (const double s : {0.0, 1.0}) {
        tryAt(a, s, b, nearestAlong(other.on(b, 0), other.on(b, 1), one.on(a, s)));
        tryAt(a, nearestAlong(one.on(a, 0), one.on(a, 1), other.on(b, s)), b, s);
      }
      const auto [s, t] = nearestOnBones(one, a, other, b);
      tryAt(a, s, b, t);
    }
  }
}

}  // namespace

PartProxy proxyOf(const RigPart& part) {
  PartProxy proxy;
  if (!part.part || part.part->skeleton.bones.empty()) return proxy;
  proxy.exists = true;
  proxy.holds = part.source->skeleton;
  proxy.skeleton = &part.part->skeleton;
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
  for (const auto& [a, b] : proxy.skeleton->bones) {
    const Vec3 half = (proxy.points[b] - proxy.points[a]) / 2;
    proxy.middles.push_back(proxy.points[a] + half);
    proxy.reaches.push_back(length(half) + std::max(proxy.radii[a], proxy.radii[b]));
  }
  // A little larger, so that no decision is ever the box's.
  proxy.size = length(proxy.box.size());
  const double margin = 1e-6 * proxy.size;
  proxy.box.low = proxy.box.low - Vec3{margin, margin, margin};
  proxy.box.high = proxy.box.high + Vec3{margin, margin, margin};
  return proxy;
}

double nearestAlong(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  const double whole = dot(along, along);
  return whole > 0 ? std::clamp(dot(p - a, along) / whole, 0.0, 1.0) : 0;
}

double penetration(const PartProxy& proxy, Vec3 p) {
  double best = -kFar;
  for (uint32_t k = 0; k < proxy.skeleton->bones.size(); ++k) {
    const auto& [a, b] = proxy.skeleton->bones[k];
    const double t = nearestAlong(proxy.points[a], proxy.points[b], p);
    const double r = proxy.radiusOn(k, t);
    if (r > 0) best = std::max(best, 1 - distance(proxy.on(k, t), p) / r);
  }
  return best;
}

std::array<double, 2> nearestOnBones(const PartProxy& one, uint32_t a, const PartProxy& other,
                                     uint32_t b) {
  const Vec3 p = one.on(a, 0), q = one.on(a, 1), r = other.on(b, 0), s = other.on(b, 1);
  const Vec3 u = q - p, v = s - r, w = p - r;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double sine = uu * vv - uv * uv;
  if (sine > kParallel * kParallel * uu * vv) {
    const double x = (uv * vw - vv * uw) / sine, y = (uu * vw - uv * uw) / sine;
    if (x > 0 && x < 1 && y > 0 && y < 1) return {x, y};
  }
  // Two segments are nearest to each other at an end of one of them or where both are crossed.
  const std::array<std::array<double, 2>, 4> ends{{{0, nearestAlong(r, s, p)},
                                                   {1, nearestAlong(r, s, q)},
                                                   {nearestAlong(p, q, r), 0},
                                                   {nearestAlong(p, q, s), 1}}};
  size_t best = 0;
  double nearest = kFar;
  for (size_t i = 0; i < ends.size(); ++i) {
    const double d = distance(one.on(a, ends[i][0]), other.on(b, ends[i][1]));
    if (!(d < nearest)) continue;
    nearest = d;
    best = i;
  }
  return ends[best];
}

double ballOverlap(const PartProxy& one, const PartProxy& other) {
  double best = -kFar;
  forNearBones(one, other, 2, [&](double r, double q, double d) {
    if (std::min(r, q) > 0) best = std::max(best, (r + q - d) / std::min(r, q));
  });
  return best;
}

double depthOf(const PartProxy& one, const PartProxy& other) {
  double best = -kFar;
  forNearBones(one, other, 1, [&](double r, double q, double d) {
    if (std::max(r, q) > 0) best = std::max(best, 1 - d / std::max(r, q));
  });
  return best;
}

}  // namespace marrow
