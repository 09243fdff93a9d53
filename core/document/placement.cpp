#include "document/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/box.h"
#include "base/text.h"

namespace marrow {
namespace {

constexpr double kEven = 1e-12;        // of the squares of lengths
constexpr double kFlat = 1e-9;         // of the square of the longer direction; of a stretch
constexpr double kThinStroke = 1e-12;  // of the square of the spread
constexpr double kSameThickness = 1e-9;
constexpr double kUnit = 1e-14;  // of the square of a normal's length

bool isIdentity(const Affine& map) {
  return map.x == Vec3{1, 0, 0} && map.y == Vec3{0, 1, 0} && map.z == Vec3{0, 0, 1};
}

/// False for NaN as well.
bool isScale(double length) { return length >= kSmallestScale && length <= kLargestScale; }

/// Of lengths x and y, and the product of the directions.
bool isEven(double xx, double yy, double xy) {
  const double most = kEven * std::max(xx, yy);
  return std::fabs(xx - yy) <= most && std::fabs(xy) <= most;
}

double largest(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// By its spread along its two principal directions.
bool isThin(const std::vector<Vec2>& stroke) {
  Vec2 mean;
  for (Vec2 p : stroke) mean = mean + p / static_cast<double>(stroke.size());
  double xx = 0, xy = 0, yy = 0;
  for (Vec2 p : stroke) {
    const Vec2 d = p - mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  return !(xx * yy - xy * xy > kThinStroke * (xx + yy) * (xx + yy));
}

/// The mesh in the frame that a fit gives. Positive factors only: it stays outward.
Mesh fitted(Mesh mesh, const FrameFit& fit) {
  for (Vec3& p : mesh.positions) {
    const Vec2 flat = fit(Vec2{p.x, p.y});
    p = {flat.x, flat.y, p.z};
  }
  return inSinglePrecision(std::move(mesh));
}

Error flattened(const PartSource& part) {
  return {Status::noArea, onOneLine(part.name) + " would be flat, or too far away."};
}

}  // namespace

bool isSound(const Frame& frame) {
  return isDrawable(frame.origin) && isScale(length(frame.x)) && isScale(length(frame.y)) &&
         isEven(dot(frame.x, frame.x), dot(frame.y, frame.y), dot(frame.x, frame.y));
}

std::optional<FrameFit> fitFrame(Vec3 origin, Vec3 x, Vec3 y) {
  const double x_length = length(x), y_length = length(y);
  if (!isDrawable(origin) || !isScale(x_length) || !isScale(y_length)) return std::nullopt;
  const Vec3 along = x / x_length;
  const double shear = dot(y, along);
  Vec3 across = y - along * shear;
  const double height = length(across);
  if (!(height * x_length > kFlat * std::max(x_length * x_length, y_length * y_length))) {
    return std::nullopt;
  }
  // Once more: where x and y lie close together the difference has few digits.
  across = across / height;
  across = across - along * dot(across, along);
  across = across / length(across);

  FrameFit fit;
  const double scale = std::sqrt(x_length * height);
  fit.frame = {origin, along * scale, across * scale};
  fit.even = isEven(x_length * x_length, y_length * y_length, dot(x, y));
  if (!fit.even) {
    fit.xx = x_length / scale;
    fit.xy = shear / scale;
    fit.yy = dot(y, across) / scale;
  }
  return fit;
}

bool isDrawable(const std::vector<Vec2>& stroke, const Frame& frame) {
  return std::all_of(stroke.begin(), stroke.end(),
                     [&](Vec2 p) { return isDrawable(p) && isDrawable(frame.toWorld(p)); });
}

bool isDrawable(const PartSource& part) {
  if (!isDrawable(part.stroke, part.frame)) return false;
  if (!part.mesh) return true;
  const Box3 box = boxOf(part.mesh->positions);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? box.low.x : box.high.x, corner & 2 ? box.low.y : box.high.y,
                 (corner & 4 ? box.low.z : box.high.z) * kMaxThickness};
    if (!isDrawable(p) || !isDrawable(part.frame.toWorld(p))) return false;
  }
  return true;
}

bool fitInFrame(PartSource& part) {
  if (isSound(part.frame)) return true;
  const auto fit = fitFrame(part.frame.origin, part.frame.x, part.frame.y);
  if (!fit) return false;
  part.frame = fit->frame;
  for (Vec2& p : part.stroke) p = (*fit)(p);
  if (part.mesh) part.mesh = std::make_shared<const Mesh>(fitted(*part.mesh, *fit));
  return true;
}

Mesh flipped(const Mesh& mesh) {
  Mesh other = mesh;
  for (Vec3& p : other.positions) p.z = -p.z;
  for (auto& triangle : other.triangles) std::swap(triangle[1], triangle[2]);
  return other;
}

std::optional<Plane> normalised(const Plane& plane) {
  const double off = dot(plane.normal, plane.normal) - 1;
  if (std::fabs(off) <= kUnit && isDrawable(Vec2{plane.offset, 0})) return plane;
  const double size = largest(plane.normal);
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  const Vec3 direction = plane.normal / size;
  const double length_of = length(direction);
  const Plane unit{direction / length_of, plane.offset / size / length_of};
  if (!isDrawable(unit.normal) || !isDrawable(Vec2{unit.offset, 0})) return std::nullopt;
  return unit;
}

Affine mirrored(const Affine& map, const Plane& plane) {
  Affine seen;
  if (isIdentity(map)) {
    seen.move = mirroredDirection(map.move, plane);
    return seen;
  }
  const auto column = [&](Vec3 axis) {
    return mirroredDirection(map.direction(mirroredDirection(axis, plane)), plane);
  };
  seen.x = column(Vec3{1, 0, 0});
  seen.y = column(Vec3{0, 1, 0});
  seen.z = column(Vec3{0, 0, 1});
  seen.move = mirrored(map(mirrored(Vec3{}, plane)), plane);
  return seen;
}

std::optional<Plane> mapped(const Plane& plane, const Affine& map) {
  if (isIdentity(map)) {
    const Plane moved{plane.normal, plane.offset - dot(plane.normal, map.move)};
    return normalised(moved);
  }
  // By the cofactors, which are the inverse transposed but for a factor.
  const Vec3 xy = cross(map.x, map.y), yz = cross(map.y, map.z), zx = cross(map.z, map.x);
  Vec3 normal = yz * plane.normal.x + zx * plane.normal.y + xy * plane.normal.z;
  if (dot(xy, map.z) < 0) normal = -normal;
  const auto unit = normalised({normal, 0});
  if (!unit) return std::nullopt;
  const Vec3 point = map(plane.normal * -plane.offset);
  return normalised({unit->normal, -dot(unit->normal, point)});
}

Result<PartSource> mapped(const PartSource& part, const Affine& map) {
  PartSource next = part;
  if (isIdentity(map)) {
    next.frame.origin = part.frame.origin + map.move;
    if (!isDrawable(next.frame.origin) || !isDrawable(next)) return flattened(part);
    return next;
  }
  const auto fit =
      fitFrame(map(part.frame.origin), map.direction(part.frame.x), map.direction(part.frame.y));
  if (!fit) return flattened(part);
  next.frame = fit->frame;
  if (!fit->even) {
    for (Vec2& p : next.stroke) p = (*fit)(p);
    if (isThin(next.stroke)) return flattened(part);
  }
  if (next.mesh && !fit->even) {
    next.mesh = std::make_shared<const Mesh>(fitted(*next.mesh, *fit));
    if (!faultIn(*next.mesh).empty()) return flattened(part);
  }

  const double before = part.frame.scale(), after = next.frame.scale();
  const Vec3 front = map.direction(part.frame.z() / before);
  const double towards = dot(front, next.frame.z());
  if (next.mesh && towards < 0) next.mesh = std::make_shared<const Mesh>(flipped(*next.mesh));
  if (!isDrawable(next)) return flattened(part);
  const double stretch = std::fabs(towards) / after;
  const double factor = stretch * before / after;
  if (!(factor > kFlat) || !std::isfinite(factor)) return flattened(part);
  if (std::fabs(factor - 1) > kSameThickness) {
    next.thickness = std::clamp(part.thickness * factor, kMinThickness, kMaxThickness);
  }
  return next;
}

}  // namespace marrow
