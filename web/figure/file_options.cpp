#include "figure/file_options.h"

#include <algorithm>

#include "io/glb.h"

namespace marrow {

const char* toString(FileOptions::Format format) {
  using Format = FileOptions::Format;
  switch (format) {
    case Format::glb:
      return "glb";
    case Format::gltf:
      return "gltf";
    case Format::obj:
      return "obj";
    case Format::stl:
      return "stl";
    case Format::ply:
      return "ply";
  }
  return "";
}

Box3 shownBox(const Evaluation& evaluation) {
  Box3 box;
  for (const PlacedPart& placed : evaluation.placed()) {
    const EvaluatedPart& part = evaluation.parts()[placed.source];
    if (!part.part || !part.source->visible) continue;
    for (const Vec3& p : part.shapeOf(placed)->mesh.positions) box.include(placed.frame.toWorld(p));
  }
  return box;
}

double metresPerUnit(const Box3& box, double height_m) {
  const double height = box.isEmpty() ? 0 : box.size().y;
  if (!(height_m > 0) || !(height > 0)) return GlbOptions{}.metres_per_unit;
  return std::clamp(height_m / height, GlbOptions::kLeastScale, GlbOptions::kLargestScale);
}

}  // namespace marrow
