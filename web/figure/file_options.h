// A character as a file: what of it, and in which format.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/box.h"
#include "document/evaluation.h"
#include "pose/skin.h"

namespace marrow {

struct FileOptions {
  enum class Format : uint8_t { glb, gltf, obj, stl, ply };

  Format format = Format::glb;
  std::string name;               // of the drawing
  double metres_per_unit = 0.01;  // glb, gltf
  bool parts = false;             // glb, gltf: a mesh for each part, in place of one body
  bool weights = true;            // glb, gltf: with a skin
  std::string pose;               // of the others: the pose it has; empty, or none's: at rest
  Skinning skinning = Skinning::linear;

  /// Whether bones and poses go with it.
  bool hasBones() const { return format == Format::glb || format == Format::gltf; }
};
/// Whether all of it is one body, as pose mode shows it.
inline bool takesOneBody(const FileOptions& options) {
  return !options.parts || !options.hasBones();
}
const char* toString(FileOptions::Format format);  // "glb": also the file's ending

/// Around the parts that are shown, at rest.
Box3 shownBox(const Evaluation& evaluation);
/// The scale at which what is in the box is so many metres high; 0: as drawn, 100 units a metre.
double metresPerUnit(const Box3& box, double height_m);

/// What comes of them.
struct MadeFile {
  std::vector<std::string> left_out;  // sentences: parts that are not in it, and why
  std::string bytes;
};

}  // namespace marrow
