// Outlines of real drawings.
#pragma once

#include <string>
#include <vector>

#include "sketch/outline.h"
#include "support/catch.h"
#include "support/strokes.h"

namespace marrow {

/// check(name, dense outline) for each real stroke; a warning where there are none beside the
/// project.
template <typename Check>
void forEachRealOutline(Check check) {
  const std::vector<strokes::NamedStroke> real = strokes::realStrokes();
  if (real.empty()) WARN("no real strokes beside the project: skipped");
  for (const strokes::NamedStroke& stroke : real) {
    const Result<Outline> outline = makeOutline(stroke.points);
    REQUIRE(outline);
    check(stroke.name, outline->dense);
  }
}

}  // namespace marrow
