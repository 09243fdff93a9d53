// The parts of a document and their twins, each with its place in space.
#pragma once

#include <string>
#include <vector>

#include "document/document.h"

namespace marrow {

constexpr char kTwinSuffix[] = ":twin";

/// A part, or the twin of one.
struct PlacedPart {
  std::string id;     // the part's; of a twin with kTwinSuffix
  size_t source = 0;  // index of the part in the document
  bool twin = false;
  Frame frame;
  char side = 0;  // 'L' or 'R' where the part has a twin, else 0. The character looks at the viewer
                  // of the front view: its left is at positive x (or z, or y: the plane's normal
                  // is turned so that its largest coordinate is positive)
};

/// In modelling order, each twin after its part. O(parts).
std::vector<PlacedPart> placedParts(const Document& document);

/// The one with this id; null where there is none. O(parts).
const PlacedPart* findPlaced(const std::vector<PlacedPart>& placed, const std::string& id);

/// The id of the part that a placed part belongs to, and whether that is its twin.
std::string sourceId(const std::string& placed_id);
bool isTwinId(const std::string& placed_id);

}  // namespace marrow
