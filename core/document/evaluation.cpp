#include "document/evaluation.h"

#include <string_view>
#include <unordered_map>
#include <utility>

namespace marrow {

Evaluation::Evaluation(PartOptions options, Clock clock)
    : options_(std::move(options)), clock_(clock) {}

void Evaluation::update(const Document& document) {
  std::unordered_map<std::string_view, const EvaluatedPart*> before;
  for (const EvaluatedPart& part : parts_) before.emplace(part.source->id, &part);

  recomputed_ = 0;
  std::vector<EvaluatedPart> parts;
  parts.reserve(document.parts.size());
  for (const auto& source : document.parts) {
    const auto found = before.find(source->id);
    parts.push_back(evaluate(source, found == before.end() ? nullptr : found->second));
  }
  parts_ = std::move(parts);
}

EvaluatedPart Evaluation::evaluate(const std::shared_ptr<const PartSource>& source,
                                   const EvaluatedPart* before) {
  if (!before) return rebuild(source);
  if (source == before->source) return *before;
  if (source->stroke != before->source->stroke) return rebuild(source);

  const bool new_joints = epsilonS(*source) != epsilonS(*before->source);
  const bool new_thickness = source->thickness != before->source->thickness;
  EvaluatedPart next = *before;
  next.source = source;
  if (!new_joints && !new_thickness) return next;
  if (!before->part) return rebuild(source);

  ++recomputed_;
  next.skeleton_id = next_id_++;
  if (new_joints) {
    JointOptions joints = options_.joints;
    joints.epsilon_s = epsilonS(*source);
    auto part = withJoints(*next.part, joints, clock_);
    next.part = part ? std::make_shared<const Part>(std::move(*part)) : nullptr;
    if (!part) next.error = part.error();
  }
  if (new_thickness && next.part) {
    next.mesh_id = next_id_++;
    next.part = std::make_shared<const Part>(withThickness(*next.part, source->thickness, clock_));
  }
  return next;
}

EvaluatedPart Evaluation::rebuild(const std::shared_ptr<const PartSource>& source) {
  ++recomputed_;
  EvaluatedPart next;
  next.source = source;
  next.mesh_id = next_id_++;
  next.skeleton_id = next_id_++;
  PartOptions options = options_;
  options.joints.epsilon_s = epsilonS(*source);
  options.inflate.thickness = source->thickness;
  auto part = buildPart(source->stroke, options, clock_);
  if (part) {
    next.part = std::make_shared<const Part>(std::move(*part));
  } else {
    next.error = part.error();
  }
  return next;
}

double Evaluation::epsilonS(const PartSource& source) const {
  return source.epsilon_s.value_or(options_.joints.epsilon_s);
}

}  // namespace marrow
