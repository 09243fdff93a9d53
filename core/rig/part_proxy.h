// A part's balls and cones in space  [RS §3.2, Fig. 8]. Internal to connecting.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/box.h"
#include "rig/rig.h"

namespace marrow {

struct PartProxy {
  bool exists = false;
  bool holds = false;  // has bones that something can hang on
  std::vector<Vec3> points;
  std::vector<double> radii;
  const PartSkeleton* skeleton = nullptr;
  std::vector<Vec3> middles;    // of bones
  std::vector<double> reaches;  // from there to the farthest point of the bone's cone
  Box3 box;
  double size = 0;  // of the box

  bool isEnd(size_t joint) const { return skeleton->joints[joint].kind != JointKind::sleeve; }
  Vec3 on(uint32_t bone, double t) const {
    const auto& [a, b] = skeleton->bones[bone];
    return lerp(points[a], points[b], t);
  }
  double radiusOn(uint32_t bone, double t) const {
    const auto& [a, b] = skeleton->bones[bone];
    return radii[a] + (radii[b] - radii[a]) * t;
  }
};

PartProxy proxyOf(const RigPart& part);

/// Where on a → b the point nearest to p is, 0 … 1.
double nearestAlong(Vec3 a, Vec3 b, Vec3 p);

/// How deep a point is in the cones, relative to the radius there: 1 on a bone, 0 at the surface.
double penetration(const PartProxy& proxy, Vec3 p);

/// Where bones of two proxies are nearest to each other, by how much the balls there overlap,
/// relative to the smaller radius: above 0 they meet. −∞ where none do.
double ballOverlap(const PartProxy& one, const PartProxy& other);
/// How deep a bone of one of two proxies is in the other's cones, relative to the radius there: 1
/// on a bone, 0 at the surface. The larger one of both; −∞ where their cones are apart.
double depthOf(const PartProxy& one, const PartProxy& other);

/// Where on bones a and b of two proxies these are nearest to each other, 0 … 1 on each.
std::array<double, 2> nearestOnBones(const PartProxy& one, uint32_t a, const PartProxy& other,
                                     uint32_t b);

}  // namespace marrow
