// Every change to a document is one of these; applying gives a new document.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "document/document.h"

namespace marrow {

/// Ids of placed parts (placed_parts.h): a twin's id means the part it belongs to, but for moving.
/// Each may be there once or twice; the order counts for nothing.
using Ids = std::vector<std::string>;

struct AddPart {
  std::vector<Vec2> stroke;
  Frame frame = {};
  std::optional<Plane> mirror = {};
};
/// A part that is a mesh (PartSource::mesh), with the skeleton of its silhouette in the frame's
/// plane. Errors: notSolid for one that is none, noArea, also where it has no breadth in that
/// plane; tooMany.
struct ImportPart {
  std::shared_ptr<const Mesh> mesh;  // in the frame; not null
  std::string name;                  // of the part; empty: by its number
  Frame frame = {};
};
struct DeleteParts {
  Ids ids;
};
/// Copies of the parts with all that is set for them, placed `move` away, each after its original.
/// Attachments among the copied parts are kept among the copies. Errors: tooMany.
struct DuplicateParts {
  Ids ids;
  Vec3 move;
};
/// Moves, turns and scales. A twin's id moves the twin, and its part as seen in the mirror. Where
/// both are named the plane of symmetry goes with them, and so does the document's where all parts
/// are named. What a map stretches unevenly is stretched into the stroke and the thickness.
/// Poses go along (posed_parts.h). Errors: noArea for a map that flattens, or leaves the drawable.
struct TransformParts {
  Ids ids;
  Affine map;
  std::string verb = "Move";  // for the step's name: "Move leg"
};
struct SetThickness {
  Ids ids;
  double thickness;
};
struct SetColor {
  Ids ids;
  Color color;
};
struct SetVisible {
  Ids ids;
  bool visible;
};
struct SetLocked {
  Ids ids;
  bool locked;
};
struct SetSkeleton {
  Ids ids;
  bool skeleton;
};
/// An empty name changes nothing; bytes that are not UTF-8 are replaced.
struct RenamePart {
  std::string id, name;
};
/// Another outline for a part: what contour editing gives. Errors: tooFewPoints, noArea; notDrawn
/// for an imported one.
struct SetStroke {
  std::string id;
  std::vector<Vec2> stroke;
};
/// Twins across the plane; nothing: the twins go.
struct SetMirror {
  Ids ids;
  std::optional<Plane> plane;
};
/// Twins become parts of their own, each after what was its mirror image; attachments to them stay.
/// "Leg" becomes "Leg.L" and "Leg.R". Errors: tooMany.
struct SeparateTwins {
  Ids ids;
};
struct SetSymmetry {
  std::optional<Plane> plane;
};
/// One threshold of a scope; nothing: back to the wider scope's.
struct SetRefinement {
  Ids ids;             // of parts; none: the whole model
  std::string branch;  // key of a branch of the one part: ε_s alone
  std::optional<double> Refinement::*threshold;
  std::optional<double> value;
};
/// All thresholds of a scope, and of those within it where `within`.
struct ResetRefinement {
  Ids ids;  // none: the whole model
  std::string branch;
  bool within = false;
};
/// Hangs a part on another, or on none, whatever connecting finds; nothing: by itself again.
struct SetAttachment {
  std::string id;
  std::optional<Attachment> attachment;
};
/// The part at which the bones of its tree begin. others: the rest of the tree, no longer roots.
struct SetRoot {
  std::string id;
  Ids others;
};
/// A picture behind the strokes, in place of the one in that view; `image` null: none.
struct SetReference {
  Reference reference;
};
/// A pose of this name, in place of the one that has it or after all others. Errors: notFound for
/// an empty name, noArea for a rotation or a move that is none, tooMany.
struct SetPose {
  std::string name;
  Pose joints;
};
/// An empty name changes nothing; bytes that are not UTF-8 are replaced. Errors: notFound, also for
/// a name that another pose has.
struct RenamePose {
  std::string name, to;
};
struct DeletePose {
  std::string name;
};
/// How far around seams parts grow into each other.
struct SetBlend {
  double radius;
};
/// A stroke of the weight brush, as it lies in space at rest; `part` is a placed part's id. See
/// strokeOnPart for the errors; locked.
struct AddWeightStroke {
  WeightStroke stroke;
};
/// What was painted for a joint, and for the one opposite where twins share it. An empty id: all
/// there is, smoothing too. Strokes on locked parts stay.
struct ClearWeightStrokes {
  std::string joint;
};
struct ReplaceDocument {  // open, new
  Document document;
  std::string name;  // of the step: "Open", "New drawing"
};

/// Any one of the above. A type of its own rather than a variant, so that `apply` never means
/// std::apply.
struct Command {
  using Step =
      std::variant<AddPart, ImportPart, DeleteParts, DuplicateParts, TransformParts, SetThickness,
                   SetColor, SetVisible, SetLocked, SetSkeleton, RenamePart, SetStroke, SetMirror,
                   SeparateTwins, SetSymmetry, SetRefinement, ResetRefinement, SetAttachment,
                   SetRoot, SetReference, SetPose, RenamePose, DeletePose, SetBlend,
                   AddWeightStroke, ClearWeightStrokes, ReplaceDocument>;
  template <typename One, typename = std::enable_if_t<std::is_constructible_v<Step, One>>>
  Command(One one) : step(std::move(one)) {}

  Step step;
};

/// The document after the command; the given one is untouched. New parts get the next free id
/// ("part-1", …), a name and a colour. Values out of range are clamped. A command that changes
/// nothing gives the same parts.
/// Locked parts stay as they are, but for SetLocked, SetVisible, RenamePart, SetRoot and what
/// becomes of their copies, which are not locked.
/// Errors: notFound; locked, where all parts are; tooFewPoints and noArea for a stroke that
/// encloses nothing, noArea for a plane that is none or what leaves the drawable; tooMany;
/// unreadable for a picture that is none.
Result<Document> apply(const Document& document, const Command& command);

/// For the menu: "Draw part 3", "Delete 4 parts", "Move leg".
std::string describe(const Document& before, const Command& command);

}  // namespace marrow
