// A character as a GLB or glTF file: glTF 2.0, for Blender, three.js and game engines.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "character/character.h"
#include "pose/pose.h"
#include "rig/rig.h"

namespace marrow {

struct GlbCharacter {
  std::string name;
  const Rig& rig;
  std::vector<SkinnedMesh> meshes;
  std::vector<Paint> paints;                        // each a material
  std::vector<std::pair<std::string, Pose>> poses;  // named, each an animation of one key
  std::string document;  // its text; kept in the file, so that it can be opened and edited again
};

/// With the document's poses and its text.
GlbCharacter glbOf(const Character& made, const Rig& rig, const Document& document,
                   const std::string& name);

struct GlbOptions {
  static constexpr double kLeastScale = 1e-9, kLargestScale = 1e9;

  double metres_per_unit = 0.01;  // kLeastScale … kLargestScale
};

/// The bytes of the file. Every joint of the rig is a node of its name under one node "Skeleton",
/// turned as restAxes says; y is up, the front view looks along −z. A mesh has a primitive for each
/// paint it shows, which share its vertices; there is a skin where a mesh has one. The document
/// lies in the buffer view that asset.extras.marrow.document names. Errors: meshFailed where a
/// number is not finite or too large for single precision; tooMany joints for 16 bits.
Result<std::string> toGlb(const GlbCharacter& character, const GlbOptions& options = {});

/// The same as one text: JSON, with the bytes in base64.
Result<std::string> toGltf(const GlbCharacter& character, const GlbOptions& options = {});

}  // namespace marrow
