// Do rigs have the joints that people place? Measured on tests/data/characters: drawings of bipeds
// with joints placed as an animator would place them, and of other creatures with the limbs that
// one would want; besides, where they are beside the project, on real drawings. tests/data/
// characters/draw.py says how they were made.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "bench/quality.h"

namespace marrow::bench {

struct PlacedJoint {
  std::string name;  // "torso", "left_elbow"; the character's left, which is the viewer's right
  Vec2 position;
};

struct WantedLimb {
  std::string name;
  Vec2 tip;            // in the middle of its end
  Vec2 base;           // where an animator would turn it; not known where it is not `wanted`
  bool wanted = true;  // otherwise it may be there
};

/// A drawing and what a person knows of it, in the drawing's units.
struct PlacedDrawing {
  std::string name;
  bool biped = false;
  bool symmetric = false;  // exactly, about x = 0
  std::vector<Vec2> points;
  std::vector<PlacedJoint> joints;          // of bipeds
  std::vector<std::string> straight, bent;  // elbows and knees
  std::vector<WantedLimb> limbs;
};

/// By name; without those whose outline is not to be had.
std::vector<PlacedDrawing> placedDrawings();

/// Rows of the table of rig quality. Distances are shares of the larger side of the outline's box.
std::vector<QualityRow> placedJoints();

/// Writes what was missed to the standard error, the worst first, and the rows as `quality` does.
void missedJoints();

}  // namespace marrow::bench
