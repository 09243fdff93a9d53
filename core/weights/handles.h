// Bones as handles of a volume: the vertices whose weights are given.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rig/rig.h"
#include "weights/volume.h"

namespace marrow {

using Segment = std::array<Vec3, 2>;

/// One per bone of the rig, in their order.
std::vector<Segment> boneSegments(const Rig& rig);

/// The vertices near the bones, ascending. Each is held by one bone, or near a joint by several, in
/// shares that are positive and sum to 1.
struct Handles {
  std::vector<uint32_t> vertices;
  std::vector<uint32_t> starts;  // of handle i: bones and shares from starts[i] to starts[i + 1]
  std::vector<uint32_t> bones;   // ascending in each handle
  std::vector<double> shares;
};

/// Held are the vertices not farther than √3/2 of the spacing from a bone that runs through a cell
/// at them: there is always one, and a bone that lies between lattice lines is held all around, so
/// that mirrored bones are held alike. Who is how near decides the shares: those of the bones that
/// start or end at a joint go over into each other within one spacing of it. A bone that is nowhere
/// inside the volume holds nothing.
Handles makeHandles(const Volume& volume, const std::vector<Segment>& bones);

/// Distance of a point to a segment.
double distanceTo(const Segment& segment, Vec3 point);

}  // namespace marrow
