// What counts as a change of a drawing, and is kept.
#include "keep/keeping.h"

#include "document/command.h"
#include "document/evaluation.h"
#include "support/catch.h"
#include "support/samples.h"
#include "support/weight_strokes.h"

namespace marrow {
namespace {

/// Whether the step is a change to be saved, and is kept by itself.
bool isKept(const Command& command) {
  Keeping keeping;
  Document document = sampleFiles().front().document;
  Origin origin;
  origin.kept = true;
  document.drawing = keeping.add(document, origin);
  keeping.update(document, 0, false);
  CHECK_FALSE(keeping.changed());
  const auto changed = apply(document, command);
  REQUIRE(changed);
  keeping.update(*changed, 1, false);
  const bool differs = keeping.changed();
  keeping.takeJobs();
  keeping.update(*changed, 1 + Keeping::kKeepAfter_ms, false);
  const auto jobs = keeping.takeJobs();
  CHECK(differs == !jobs.empty());
  return differs;
}

}  // namespace

TEST_CASE("keeping: poses, soft seams and strokes of the brush are changes like any other") {
  const Document& document = sampleFiles().front().document;
  CHECK(isKept(SetPose{"Sit", {}}));
  CHECK(isKept(SetBlend{12}));
  CHECK(isKept(AddWeightStroke{strokeAtJoint(document, 1, 40)}));
  CHECK_FALSE(isKept(SetBlend{document.blend}));
}

}  // namespace marrow
