#include "rig/body_overlap.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr size_t kOutlinePoints = 32, kSurfacePoints = 48;

class Body {
 public:
  explicit Body(const RigPart& part)
      : part_(*part.part),
        frame_(part.placed->frame),
        z_(frame_.z()),
        thickness_(part.source->thickness) {}

  bool contains(Vec3 world) const {
    const Vec3 d = world - frame_.origin;
    const double square = dot(frame_.x, frame_.x);
    const double z = dot(z_, d) / square;
    if (!(z < part_.relief.highest() * thickness_ && z > part_.relief.lowest() * thickness_)) {
      return false;
    }
    const Vec2 p{dot(frame_.x, d) / square, dot(frame_.y, d) / square};
    return z < part_.relief.heightAt(p) * thickness_ && z > part_.relief.depthAt(p) * thickness_;
  }

  /// Calls visit with some points of the body in space.
  template <typename Visit>
  void forPoints(const Visit& visit) const {
    const auto place = [&](Vec3 p) {
      return frame_.origin + frame_.x * p.x + frame_.y * p.y + z_ * p.z;
    };
    const auto& outline = part_.outline.dense;
    for (size_t k = 0; k < kOutlinePoints; ++k) {
      visit(frame_.toWorld(outline[k * outline.size() / kOutlinePoints]));
    }
    const auto& positions = part_.mesh.positions;
    for (size_t k = 0; k < kSurfacePoints; ++k) {
      visit(place(positions[k * positions.size() / kSurfacePoints]));
    }
    for (const auto& joint : part_.skeleton.joints) visit(place(joint.place()));
  }

 private:
  const Part& part_;
  const Frame& frame_;
  Vec3 z_;
  double thickness_;
};

double shareInside(const Body& one, const Body& other) {
  int inside = 0, all = 0;
  one.forPoints([&](Vec3 p) {
    ++all;
    inside += other.contains(p) ? 1 : 0;
  });
  return inside > 1 ? static_cast<double>(inside) / all : 0;
}

}  // namespace

double bodyOverlap(const RigPart& one, const RigPart& other) {
  const Body a(one), b(other);
  return std::max(shareInside(a, b), shareInside(b, a));
}

}  // namespace marrow
