// The document: what a user gave, nothing derived. A plain value: it is what is saved, undone and
// shared. Parts that did not change are shared between documents, so a step of history is cheap.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/frame.h"
#include "base/result.h"
#include "base/vec.h"
#include "document/pose.h"
#include "document/refinement.h"
#include "document/weight_stroke.h"
#include "surface/mesh.h"

namespace marrow {

struct Color {
  uint8_t r = 0, g = 0, b = 0;
};
inline bool operator==(Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

/// "#rrggbb". Nothing where the text is something else.
std::optional<Color> parseColor(const std::string& text);
std::string toString(Color color);

/// Colours for new parts, told apart by colour-blind eyes too [Okabe & Ito 2008, lightened].
/// Cycles.
Color partColor(size_t index);

/// Coordinates beyond it could overflow in the geometry.
constexpr double kLargestCoordinate = 1e50;
/// Finite and not beyond the largest coordinate.
bool isDrawable(Vec2 point);
bool isDrawable(Vec3 point);

constexpr double kMinThickness = 0.05, kMaxThickness = 4;

/// What the user said about where a part hangs, against what connecting finds by itself.
struct Attachment {
  std::string part;  // the placed part to hang on (see placed_parts.h); empty: on none
  Vec2 at;           // in that part's plane: the nearest place on its bones is meant
};
inline bool operator==(const Attachment& a, const Attachment& b) {
  return a.part == b.part && a.at == b.at;
}

/// One closed stroke and what the user set for it; or a mesh that was imported, with its
/// silhouette.
struct PartSource {
  static constexpr size_t kMostTriangles = 100'000;  // of a mesh
  static constexpr size_t kMostBranches = 500;

  std::string id;  // unique in the document, never reused; without ':'
  std::string name;
  std::vector<Vec2> stroke;  // in the part's plane, as drawn, drawable
  /// The body in the part's frame at thickness 1 where it was imported, else null. Closed, outward,
  /// each number that of a float (see faultIn). `stroke` is its silhouette then.
  std::shared_ptr<const Mesh> mesh;
  Frame frame;                  // places that plane in space
  double thickness = 1;         // scales the inflated depth; kMinThickness … kMaxThickness
  std::optional<Plane> mirror;  // the part has a twin across this plane
  bool skeleton = true;         // has bones of its own; ears and spikes need none
  bool visible = true;          // a hidden part stays in the rig
  bool locked = false;          // cannot be selected on the canvas, nor changed there
  bool root = false;            // the bones of its tree begin here
  Color color;
  Refinement refine;                       // unset: the document's
  std::map<std::string, double> branches;  // "refine": {"branches"}: ε_s of single branches, by
                                           // the branch's key (see rig.h)
  std::optional<Attachment> attachment;
  std::string extra = "{}";  // JSON object: fields this version does not know, kept on save
};

/// A picture to draw after, in the plane through the origin of one of the views.
struct Reference {
  static constexpr double kMinScale = 1e-6, kMaxScale = 1e6;

  enum class View : uint8_t { front, right, top };
  View view = View::front;
  std::shared_ptr<const std::string> image;  // data URL: PNG, JPEG or WebP; never null
  double opacity = 0.5;                      // 0 … 1
  Vec2 position;     // of its middle, model units in the view: x to the right, y up
  double scale = 1;  // model units per pixel of the picture
  std::string extra = "{}";
};

/// What keeps a mesh from being a part's, as a clause: "has a hole"; empty: nothing.
std::string faultIn(const Mesh& mesh);
/// With every number as a file keeps it.
Mesh inSinglePrecision(Mesh mesh);

struct Document {
  static constexpr int kVersion = 1;
  static constexpr size_t kMostParts = 10'000;
  static constexpr size_t kMostPoses = 1'000;
  static constexpr size_t kMostWeightStrokes = 5'000;
  /// Of all imported meshes together, so that what is written can be read back: 32 bytes each at
  /// most, beside three of the largest pictures.
  static constexpr size_t kMostTriangles = 500'000;
  static constexpr double kLargestBlend = 1'000;

  std::vector<std::shared_ptr<const PartSource>> parts;  // in modelling order, never null
  Refinement refine;                                     // of the whole model; unset: the defaults
  std::optional<Plane> symmetry;  // the character's symmetry plane, if the user gave one
  std::vector<std::shared_ptr<const Reference>> references;  // at most one per view, never null
  std::vector<std::shared_ptr<const NamedPose>> poses;       // in the user's order, never null
  double blend = 0;  // how far around seams the body is soft, model units; 0 … kLargestBlend
  WeightStrokes weight_strokes;  // in the order painted, never null
  uint64_t last_part = 0;        // largest n for which an id "part-n" was ever given
  std::string extra = "{}";      // as above
  uint64_t drawing = 0;  // the app's number for what was opened or begun; not saved, so that
                         // undoing "Open" brings back which file the drawing belongs to

  /// Index of the part with this id, or nothing.
  std::optional<size_t> find(const std::string& id) const;
  /// The pose of this name, or null.
  const NamedPose* findPose(const std::string& name) const;
};

/// Behind it the numbers that are free begin again.
constexpr uint64_t kLargestPartNumber = 999'999'999'999'999;
/// The n of an id "part-n"; 0 for any other id.
uint64_t partNumber(const std::string& id);
/// Raises `last_part` to a number whose id no part has or had, and returns it.
uint64_t takePartNumber(Document& document);
std::string partId(uint64_t number);
std::string defaultPartName(uint64_t number);
/// "Pose 1", or the next number that no pose is called by.
std::string freshPoseName(const Document& document);

}  // namespace marrow
