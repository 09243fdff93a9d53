// Random creatures: documents of many parts in any place, most of which touch. Made with + − × ÷
// and square roots alone, so that every platform makes the same ones.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/placed_parts.h"
#include "support/random.h"

namespace marrow {

/// The rotation of a quaternion of small whole numbers; x, y and z are its columns.
inline Affine randomRotation(Random& random) {
  double w = 0, x = 0, y = 0, z = 0, n = 0;
  while (n == 0) {
    w = random.below(9) - 4;
    x = random.below(9) - 4;
    y = random.below(9) - 4;
    z = random.below(9) - 4;
    n = w * w + x * x + y * y + z * z;
  }
  Affine turn;
  turn.x = Vec3{n - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)} / n;
  turn.y = Vec3{2 * (x * y - z * w), n - 2 * (x * x + z * z), 2 * (y * z + x * w)} / n;
  turn.z = Vec3{2 * (x * z + y * w), 2 * (y * z - x * w), n - 2 * (x * x + y * y)} / n;
  return turn;
}

/// A rotation, a scale and a move; turns about the origin.
inline Affine randomSimilarity(Random& random, double far = 500) {
  Affine map = randomRotation(random);
  const double scale = random.between(0.4, 2.5);
  map.x = map.x * scale;
  map.y = map.y * scale;
  map.z = map.z * scale;
  map.move = {random.between(-far, far), random.between(-far, far), random.between(-far, far)};
  return map;
}

inline Plane randomPlane(Random& random, Vec3 through) {
  const Vec3 normal = randomRotation(random).x;
  return {normal / length(normal), -dot(normal / length(normal), through)};
}

/// Points of the unit circle, counter-clockwise from (1, 0); not evenly far apart.
inline std::vector<Vec2> unitCircle(int points) {
  std::vector<Vec2> circle;
  const int quarter = std::max(1, points / 4);
  for (int i = 0; i < 4 * quarter; ++i) {
    const double t = static_cast<double>(i % quarter) / quarter;
    Vec2 p = Vec2{1 - t * t, 2 * t} / (1 + t * t);
    for (int turns = i / quarter; turns > 0; --turns) p = perpendicular(p);
    circle.push_back(p);
  }
  return circle;
}

/// A long bent limb along x from −size to size, a lump, or a star with soft arms.
inline std::vector<Vec2> randomShape(Random& random, double size, int points) {
  std::vector<Vec2> stroke = unitCircle(points);
  switch (random.below(4)) {
    case 0: {
      const double width = size * random.between(0.55, 1), dent = random.between(-0.2, 0.2);
      for (Vec2& p : stroke) p = Vec2{p.x * size, p.y * width} * (1 + dent * p.x * p.y);
      break;
    }
    case 1: {
      const int arms = 3 + random.below(3);
      for (Vec2& p : stroke) {
        Vec2 turned{1, 0};  // p, its angle times `arms`
        for (int i = 0; i < arms; ++i) {
          turned = {turned.x * p.x - turned.y * p.y, turned.x * p.y + turned.y * p.x};
        }
        p = p * (size * (0.7 + 0.3 * turned.x));
      }
      break;
    }
    default: {
      const double width = size * random.between(0.12, 0.4), bend = random.between(-0.5, 0.5);
      const double taper = random.between(-0.5, 0.5);
      for (Vec2& p : stroke) {
        p = {p.x * size, p.y * width * (1 + taper * p.x) + bend * size * p.x * p.x};
      }
    }
  }
  return stroke;
}

struct CreatureOptions {
  int points = 60;         // of each stroke
  double apart = 0.1;      // how often a part touches no other
  double mirrored = 0.3;   // how often a part has a twin
  double upright = 0.4;    // how often a part lies in the front view's plane
  double overruled = 0.1;  // how often the user said where a part hangs
  double no_bones = 0.1;   // how often a part has no skeleton
  double refined = 0.2;    // how often a part has thresholds of its own
};

/// Each part but the first begins inside an earlier one, but for those apart.
inline Document randomCreature(Random& random, int parts, const CreatureOptions& options = {}) {
  const auto chance = [&](double often) { return random.unit() < often; };
  Document creature;
  creature.symmetry = Plane{{1, 0, 0}, 0};
  if (chance(0.2)) creature.symmetry = randomPlane(random, {});
  if (chance(0.1)) creature.symmetry.reset();
  const auto anyPartId = [&] {
    const int index = random.below(static_cast<int>(creature.parts.size()));
    const PartSource& part = *creature.parts[static_cast<size_t>(index)];
    return part.mirror && chance(0.5) ? part.id + kTwinSuffix : part.id;
  };

  for (int i = 0; i < parts; ++i) {
    auto part = std::make_shared<PartSource>();
    const uint64_t number = takePartNumber(creature);
    part->id = partId(number);
    part->name = chance(0.5) ? "Leg" : defaultPartName(number);
    part->color = partColor(static_cast<size_t>(number - 1));
    const double size = i == 0 ? 150 : random.between(25, 110);
    part->stroke = randomShape(random, size, options.points);
    part->thickness = random.between(0.5, 1.5);

    Affine turn = chance(options.upright) ? Affine{} : randomRotation(random);
    const double scale = random.between(0.5, 1.5);
    part->frame.x = turn.x * scale;
    part->frame.y = turn.y * scale;
    if (i > 0) {
      const int index = random.below(std::min(i, 1 + random.below(i)));
      const PartSource& parent = *creature.parts[static_cast<size_t>(index)];
      const int border = random.below(static_cast<int>(parent.stroke.size()));
      const Vec2 inside = parent.stroke[static_cast<size_t>(border)] * random.between(0.2, 0.9);
      const Vec2 start = lerp(part->stroke[part->stroke.size() / 2], part->stroke[0], 0.08);
      part->frame.origin =
          parent.frame.toWorld(inside) - (part->frame.toWorld(start) - part->frame.origin);
      if (chance(options.apart)) {
        part->frame.origin = part->frame.origin + randomRotation(random).x * 2000;
      }
    }
    if (i > 0 && chance(options.mirrored)) {
      part->mirror = creature.symmetry && chance(0.8) ? *creature.symmetry
                                                      : randomPlane(random, part->frame.origin);
    }
    part->skeleton = i == 0 || !chance(options.no_bones);
    part->visible = !chance(0.1);
    part->root = chance(0.05);
    if (chance(options.refined)) {
      part->refine.simplify = random.between(0, 40);
      if (chance(0.5)) part->refine.merge = random.between(0, 100);
      if (chance(0.5)) part->refine.prune = random.between(0, 100);
      if (chance(0.5)) part->refine.collapse = random.between(0, 60);
    }
    if (i > 0 && chance(options.overruled)) {
      part->attachment = Attachment{};
      if (chance(0.8)) part->attachment->part = anyPartId();
      part->attachment->at = {random.between(-100, 100), random.between(-100, 100)};
    }
    creature.parts.push_back(std::move(part));
  }
  return creature;
}

/// Of all parts and twins.
inline std::vector<std::string> allPlacedIds(const Document& document) {
  std::vector<std::string> ids;
  for (const PlacedPart& placed : placedParts(document)) ids.push_back(placed.id);
  return ids;
}

}  // namespace marrow
