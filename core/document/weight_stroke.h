// What the user painted over the weights that were computed: strokes of a brush on the surface.
//
// They are kept as they were painted, not as weights of vertices, so that they outlive whatever
// happens to the mesh. A stroke belongs to the part it was painted on: it lies in that part's frame
// and moves, turns and scales with it, its twin has the mirror image of it, for the joint on the
// other side, and a copy of the part has a copy of it. It paints over seams: other parts that the
// surface goes on to are painted as well. Where the part or the joint is not there any more, the
// stroke does nothing till it comes back.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/frame.h"
#include "base/result.h"

namespace marrow {

struct Document;
struct PartSource;

struct WeightStroke {
  /// What becomes of a joint's weight, which is that of the bones that leave it. The others grow or
  /// shrink in proportion.
  enum class Kind : uint8_t {
    add,     // more of it
    take,    // less of it
    smooth,  // all joints' weights become more like those around
  };
  static constexpr size_t kMostPoints = 10'000;
  static constexpr double kMinRadius = 1e-9, kMaxRadius = 1e50;

  Kind kind = Kind::add;
  std::string part;          // id of the part that it was painted on; no twin's
  std::string joint;         // id in the rig (see rig.h); of a smooth stroke it says nothing
  double radius = 20;        // of the brush, in the part's units; kMinRadius … kMaxRadius
  double strength = 1;       // 0 … 1: of the way, along the middle of the stroke
  std::vector<Vec3> points;  // in the part's frame, near its surface; drawable
  std::string extra = "{}";  // JSON object: fields this version does not know, kept on save
};
bool operator==(const WeightStroke& a, const WeightStroke& b);

using WeightStrokes = std::vector<std::shared_ptr<const WeightStroke>>;

/// The id of a joint (see Rig::Joint::id) with other ids of placed parts in it.
using RenamePlaced = std::function<std::string(const std::string& placed_id)>;
std::string renamedJoint(const std::string& joint, const RenamePlaced& rename);

/// The twin of a part, or the part of a twin, by their ids; itself where there is none.
std::string oppositePlaced(const Document& document, const std::string& placed_id);
/// The joint at the mirror place: with the opposite parts in its id.
std::string oppositeJoint(const Document& document, const std::string& joint);

/// A stroke on a part, made of one that names a part or its twin and lies in space: so do its
/// points and its radius. Points that are not drawable, or closer than an eighth of the radius to
/// the one before, are left out. Errors: notFound for a part that is not there, and where no joint
/// is named; noArea where nothing is left of it, or for a radius that is none; tooMany.
Result<WeightStroke> strokeOnPart(const Document& document, const WeightStroke& in_space);

// ---- What commands that change parts do to the strokes on them

/// Those on parts that are not there go.
void dropLostStrokes(Document& document);

/// The part's frame became another by the map, or its thickness another: strokes lie where its
/// surface went. Bit for bit as before where the frame did all of it.
void bringStrokes(const PartSource& before, const Affine& map, const PartSource& now,
                  Document& document);

/// Behind each stroke on `part` a copy on the part `copy`, with joints renamed. as_twin: as they
/// lie on the twin, whose frame the copy has.
void copyStrokes(const std::string& part, const std::string& copy, bool as_twin,
                 const RenamePlaced& rename, Document& document);

}  // namespace marrow
