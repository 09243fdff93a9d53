#include "rig/body_overlap.h"

#include <algorithm>

namespace marrow {
namespace {

// Columns along each side of where the boxes meet, and points in each column. Multiples of eight
// never fall on a border between two places of the relief's lattice, where rounding would decide.
constexpr int kColumns = 16, kDeep = 4;
// For how much it is, so many are enough where it is more than this.
constexpr int kFewColumns = 8, kFewDeep = 2;
constexpr double kPlenty = 0.05;
// Columns along each side of a body for its volume.
constexpr int kVolumeColumns = 24;

Box3 both(const Box3& one, const Box3& other) {
  Box3 box;
  box.low = most(one.low, other.low);
  box.high = least(one.high, other.high);
  return box;
}

bool hasVolume(const Box3& box) {
  const Vec3 size = box.size();
  return size.x > 0 && size.y > 0 && size.z > 0;
}

}  // namespace

PartBody::PartBody(const RigPart& part)
    : relief_(part.part->relief), thickness_(part.source->thickness) {
  const Frame& frame = part.placed->frame;
  origin_ = frame.origin;
  x_ = frame.x;
  y_ = frame.y;
  z_ = frame.z();
  const double square = dot(x_, x_);
  to_x_ = x_ / square;
  to_y_ = y_ / square;
  to_z_ = z_ / square;
  low_ = {relief_.low().x, relief_.low().y, relief_.lowest() * thickness_};
  high_ = {relief_.high().x, relief_.high().y, relief_.highest() * thickness_};
  const Vec2 cell = (relief_.high() - relief_.low()) / kVolumeColumns;
  double thick = 0;
  for (int i = 0; i < kVolumeColumns; ++i) {
    for (int j = 0; j < kVolumeColumns; ++j) {
      const Vec2 p = relief_.low() + Vec2{(i + 0.5) * cell.x, (j + 0.5) * cell.y};
      thick += std::max(0.0, relief_.heightAt(p) - relief_.depthAt(p));
    }
  }
  volume_ = thick * cell.x * cell.y * thickness_ * square * frame.scale();
}

Box3 PartBody::box() const {
  Box3 box;
  for (int corner = 0; corner < 8; ++corner) {
    box.include(toWorld({corner & 1 ? high_.x : low_.x, corner & 2 ? high_.y : low_.y,
                         corner & 4 ? high_.z : low_.z}));
  }
  return box;
}

Box3 PartBody::boxSeenBy(const PartBody& other) const {
  Box3 box;
  for (int corner = 0; corner < 8; ++corner) {
    box.include(other.toLocal(toWorld({corner & 1 ? high_.x : low_.x, corner & 2 ? high_.y : low_.y,
                                       corner & 4 ? high_.z : low_.z})));
  }
  return box;
}

/// Calls visit with points that both bodies have, and with how much volume each stands for, in
/// units of the smaller body's plane; gives the share of the smaller body.
template <typename Visit>
double visitShared(const PartBody& one, const PartBody& other, int columns, int deep,
                   const Visit& visit) {
  const bool swap = other.volume_ < one.volume_;
  const PartBody &small = swap ? other : one, &large = swap ? one : other;
  if (!(small.volume_ > 0)) return 0;
  Box3 own, others;
  own.low = small.low_;
  own.high = small.high_;
  others.low = large.low_;
  others.high = large.high_;
  if (!hasVolume(both(others, small.boxSeenBy(large)))) return 0;
  const Box3 box = both(own, large.boxSeenBy(small));
  if (!hasVolume(box)) return 0;

  // From the one's axes to the other's.
  const Vec3 origin = large.toLocal(small.origin_);
  const Vec3 x = large.toLocal(small.origin_ + small.x_) - origin;
  const Vec3 y = large.toLocal(small.origin_ + small.y_) - origin;
  const Vec3 z = large.toLocal(small.origin_ + small.z_) - origin;
  const Vec2 cell{box.size().x / columns, box.size().y / columns};
  double shared = 0;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < columns; ++j) {
      const Vec2 at{box.low.x + (i + 0.5) * cell.x, box.low.y + (j + 0.5) * cell.y};
      const double low = std::max(small.relief_.depthAt(at) * small.thickness_, box.low.z);
      const double high = std::min(small.relief_.heightAt(at) * small.thickness_, box.high.z);
      if (!(high > low)) continue;
      const double step = (high - low) / deep;
      const double piece = cell.x * cell.y * step;
      const Vec3 foot = origin + x * at.x + y * at.y;
      const Vec3 from = foot + z * low, to = foot + z * high;
      Box3 column;
      column.low = least(from, to);
      column.high = most(from, to);
      if (!column.meets(others)) continue;
      for (int k = 0; k < deep; ++k) {
        const double height = low + (k + 0.5) * step;
        if (!large.containsLocal(foot + z * height)) continue;
        shared += piece;
        visit(small.toWorld({at.x, at.y, height}), piece);
      }
    }
  }
  const double unit = length(small.x_);
  return shared * unit * unit * unit / small.volume_;
}

BodyOverlap bodyOverlap(const PartBody& one, const PartBody& other) {
  BodyOverlap overlap;
  double shared = 0;
  Vec3 moment;
  overlap.share = visitShared(one, other, kColumns, kDeep, [&](Vec3 p, double piece) {
    shared += piece;
    moment = moment + p * piece;
    overlap.points.push_back(p);
  });
  if (shared > 0) overlap.middle = moment / shared;
  return overlap;
}

double sharedVolume(const PartBody& one, const PartBody& other) {
  const auto nothing = [](Vec3, double) {};
  const double share = visitShared(one, other, kFewColumns, kFewDeep, nothing);
  return share > kPlenty ? share : visitShared(one, other, kColumns, kDeep, nothing);
}

}  // namespace marrow
