// Creatures as people put them together from drawn parts, and what should hang on what: bodies,
// heads with ears, fins along bodies, legs, tails, arms, antennae; none of them drawn or placed
// neatly.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "document/document.h"

namespace marrow::bench {

struct PartedCreature {
  std::string name;
  Document document;
  /// Ids of placed parts: child, and the part that an animator would hang it on.
  std::vector<std::pair<std::string, std::string>> hangs;
};

/// A seeded family: the same ones every time. Every second one has its limbs drawn before what they
/// hang on.
std::vector<PartedCreature> partedCreatures(int count = 36);

}  // namespace marrow::bench
