// Strokes of the weight brush.
#pragma once

#include "document/evaluation.h"
#include "document/weight_stroke.h"

namespace marrow {

/// One dab, for a joint of the document's rig and where that is; in space.
inline WeightStroke strokeAtJoint(const Document& document, size_t joint, double radius) {
  Evaluation evaluation;
  evaluation.update(document);
  const Rig::Joint& at = evaluation.rig().joints.at(joint);
  WeightStroke stroke;
  stroke.part = evaluation.placed()[at.part].id;
  stroke.joint = at.id;
  stroke.radius = radius;
  stroke.points = {at.position};
  return stroke;
}

}  // namespace marrow
