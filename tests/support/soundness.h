// What holds for every document, whatever commands and files made it.
#pragma once

#include <cmath>
#include <set>
#include <string>

#include "document/document.h"
#include "document/placed_parts.h"
#include "document/placement.h"
#include "document/reference_image.h"
#include "io/document_json.h"

namespace marrow {

inline bool isUnit(const Plane& plane) {
  return std::fabs(dot(plane.normal, plane.normal) - 1) < 1e-13 &&
         isDrawable(Vec2{plane.offset, 0});
}

inline bool isThreshold(const std::optional<double>& value) {
  return !value || (*value >= 0 && *value <= Refinement::kLargest);
}
inline bool areThresholds(const Refinement& refine) {
  return isThreshold(refine.simplify) && isThreshold(refine.merge) && isThreshold(refine.prune) &&
         isThreshold(refine.collapse);
}

/// What is wrong with the part; empty: nothing.
inline std::string faultOf(const PartSource& part) {
  if (part.id.empty() || part.id.find(':') != std::string::npos) return "id";
  if (part.name.empty()) return "name";
  if (!isSound(part.frame)) return "frame";
  if (!isDrawable(part)) return "stroke";
  if (part.mesh && !faultIn(*part.mesh).empty()) return "mesh " + faultIn(*part.mesh);
  if (!(part.thickness >= kMinThickness && part.thickness <= kMaxThickness)) return "thickness";
  if (part.mirror && !isUnit(*part.mirror)) return "mirror";
  if (!areThresholds(part.refine)) return "refine";
  if (part.branches.size() > PartSource::kMostBranches) return "branches";
  for (const auto& branch : part.branches) {
    if (!isThreshold(branch.second)) return "branch";
  }
  if (part.attachment && !isDrawable(part.attachment->at)) return "attachment";
  return {};
}

/// What is wrong with the document; empty: nothing.
inline std::string ruleBrokenBy(const Document& document) {
  std::set<std::string> ids;
  if (document.parts.size() > Document::kMostParts) return "too many parts";
  for (const auto& part : document.parts) {
    if (!part) return "no part";
    const std::string fault = faultOf(*part);
    if (!fault.empty()) return part->id + ": " + fault;
    if (!ids.insert(part->id).second) return part->id + " is there twice";
  }
  if (!areThresholds(document.refine)) return "refine";
  if (document.symmetry && !isUnit(*document.symmetry)) return "symmetry";
  std::set<Reference::View> views;
  for (const auto& reference : document.references) {
    if (!reference || !reference->image || !isReferenceImage(*reference->image)) return "image";
    if (!views.insert(reference->view).second) return "two pictures in a view";
    if (!(reference->opacity >= 0 && reference->opacity <= 1)) return "opacity";
    if (!(reference->scale >= Reference::kMinScale && reference->scale <= Reference::kMaxScale)) {
      return "scale";
    }
    if (!isDrawable(reference->position)) return "position";
  }
  std::set<std::string> names;
  for (const auto& pose : document.poses) {
    if (!pose || pose->name.empty() || !names.insert(pose->name).second) return "a pose's name";
    for (const auto& joint : pose->joints) {
      const auto unit = withUnitRotation(joint.second);
      if (!unit || !(*unit == joint.second)) return "a pose's motion";
    }
  }
  if (!(document.blend >= 0 && document.blend <= Document::kLargestBlend)) return "blend";
  if (document.weight_strokes.size() > Document::kMostWeightStrokes) return "too many strokes";
  for (const auto& stroke : document.weight_strokes) {
    if (!stroke || stroke->points.size() > WeightStroke::kMostPoints) return "a weight stroke";
    if (!(stroke->radius >= WeightStroke::kMinRadius &&
          stroke->radius <= WeightStroke::kMaxRadius)) {
      return "a brush's radius";
    }
    if (!(stroke->strength >= 0 && stroke->strength <= 1)) return "a brush's strength";
    for (const Vec3 p : stroke->points) {
      if (!isDrawable(p)) return "a weight stroke's point";
    }
  }
  size_t twins = 0;
  for (const auto& part : document.parts) twins += part->mirror ? 1 : 0;
  if (placedParts(document).size() != document.parts.size() + twins) return "placed parts";

  return {};
}

/// What is wrong with the document, or with writing and reading it; empty: nothing.
inline std::string faultOf(const Document& document) {
  const std::string rule = ruleBrokenBy(document);
  if (!rule.empty()) return rule;
  const std::string text = writeDocument(document);
  const auto again = readDocument(text);
  if (!again) return "written, but not read: " + again.message();
  if (writeDocument(*again) != text) return "written otherwise after reading";
  return {};
}

}  // namespace marrow
