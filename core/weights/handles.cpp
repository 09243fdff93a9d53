#include "weights/handles.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace marrow {
namespace {

constexpr double kNear = 0.8661;  // of the spacing: half the diagonal of a cell
constexpr double kShared = 1;     // of the spacing: from its joint on, a bone has no share
constexpr double kStep = 0.25;    // of the spacing: between samples of a bone

struct Hold {
  uint32_t vertex, bone;
  double distance;  // in spacings
};

bool isFinite(const Segment& bone) {
  return std::isfinite(dot(bone[0], {1, 1, 1})) && std::isfinite(dot(bone[1], {1, 1, 1}));
}

/// The part of a segment that lies in the grid's box; false where none does.
bool clip(const Volume& volume, Segment& bone) {
  const Vec3 low = (bone[0] - volume.origin) / volume.spacing;
  const Vec3 along = (bone[1] - bone[0]) / volume.spacing;
  double begin = 0, end = 1;
  const auto cut = [&](double from, double step, double size) {
    if (step == 0) {
      if (from < 0 || from > size) end = -1;
      return;
    }
    const double a = (0 - from) / step, b = (size - from) / step;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  };
  cut(low.x, along.x, volume.nx);
  cut(low.y, along.y, volume.ny);
  cut(low.z, along.z, volume.nz);
  if (!(begin <= end)) return false;
  bone = {lerp(bone[0], bone[1], begin), lerp(bone[0], bone[1], end)};
  return isFinite(bone);
}

/// The corners of the cells that a bone runs through.
void collect(const Volume& volume, Segment bone, uint32_t number, std::vector<Hold>& holds) {
  if (!isFinite(bone)) return;
  const Segment whole = bone;
  if (!clip(volume, bone)) return;
  const double steps = std::ceil(distance(bone[0], bone[1]) / (kStep * volume.spacing));
  const int count = std::max(1, static_cast<int>(steps));
  // A bone often lies exactly between cells, in the plane of its part: those of all sides count.
  const double aside = 1e-6 * volume.spacing;
  std::vector<uint32_t> cells;
  for (int i = 0; i <= count; ++i) {
    const Vec3 p = lerp(bone[0], bone[1], static_cast<double>(i) / count);
    for (uint32_t side = 0; side < 8; ++side) {
      const Vec3 to{side & 1 ? aside : -aside, side & 2 ? aside : -aside,
                    side & 4 ? aside : -aside};
      if (const auto place = volume.locate(p + to)) cells.push_back(place->cell);
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (const uint32_t cell : cells) {
    for (const uint32_t v : volume.cells[cell]) {
      holds.push_back({v, number, distanceTo(whole, volume.vertices[v]) / volume.spacing});
    }
  }
}

}  // namespace

double distanceTo(const Segment& segment, Vec3 point) {
  const Vec3 along = segment[1] - segment[0], apart = point - segment[0];
  const double square = dot(along, along);
  const double t = square > 0 ? std::min(std::max(dot(apart, along) / square, 0.0), 1.0) : 0;
  return distance(point, segment[0] + along * t);
}

std::vector<Segment> boneSegments(const Rig& rig) {
  std::vector<Segment> segments;
  segments.reserve(rig.bones.size());
  for (const auto& [parent, child] : rig.bones) {
    segments.push_back({rig.joints[parent].position, rig.joints[child].position});
  }
  return segments;
}

Handles makeHandles(const Volume& volume, const std::vector<Segment>& bones) {
  std::vector<Hold> holds;
  for (uint32_t bone = 0; bone < bones.size(); ++bone) collect(volume, bones[bone], bone, holds);
  const auto order = [](const Hold& hold) { return std::tie(hold.vertex, hold.bone); };
  std::sort(holds.begin(), holds.end(),
            [&](const Hold& a, const Hold& b) { return order(a) < order(b); });
  holds.erase(std::unique(holds.begin(), holds.end(),
                          [&](const Hold& a, const Hold& b) { return order(a) == order(b); }),
              holds.end());

  Handles handles;
  handles.starts.push_back(0);
  for (size_t begin = 0, end; begin < holds.size(); begin = end) {
    double nearest = holds[begin].distance;
    for (end = begin; end < holds.size() && holds[end].vertex == holds[begin].vertex; ++end) {
      nearest = std::min(nearest, holds[end].distance);
    }
    if (nearest > kNear) continue;
    double sum = 0;
    for (size_t i = begin; i < end; ++i) {
      // How far along the bone its joint is, however far beside it the vertex lies.
      const double d = holds[i].distance;
      const double share = 1 - std::sqrt(std::max(d * d - nearest * nearest, 0.0)) / kShared;
      if (!(share > 0)) continue;
      handles.bones.push_back(holds[i].bone);
      handles.shares.push_back(share);
      sum += share;
    }
    for (size_t i = handles.starts.back(); i < handles.shares.size(); ++i) handles.shares[i] /= sum;
    handles.vertices.push_back(holds[begin].vertex);
    handles.starts.push_back(static_cast<uint32_t>(handles.bones.size()));
  }
  return handles;
}

}  // namespace marrow
