// The document: what a user gave, nothing derived. A plain value: it is what is saved, undone and
// shared. Parts that did not change are shared between documents, so a step of history is cheap.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace marrow {

struct Color {
  uint8_t r = 0, g = 0, b = 0;
};
inline bool operator==(Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

/// "#rrggbb". Nothing where the text is something else.
std::optional<Color> parseColor(const std::string& text);
std::string toString(Color color);

/// Colours for new parts, told apart by colour-blind eyes too [Okabe & Ito 2008, lightened].
/// Cycles.
Color partColor(size_t index);

/// Coordinates beyond it could overflow in the geometry.
constexpr double kLargestCoordinate = 1e50;
/// Finite and not beyond the largest coordinate.
bool isDrawable(Vec2 point);

constexpr double kMinThickness = 0.05, kMaxThickness = 4;
constexpr double kMinEpsilonS = 0.1, kMaxEpsilonS = 200;

/// One closed stroke and what the user set for it.
struct PartSource {
  std::string id;  // unique in the document, never reused
  std::string name;
  std::vector<Vec2> stroke;  // model units, y up, as drawn, drawable
  double thickness = 1;      // scales the inflated depth; kMinThickness … kMaxThickness
  Color color;
  std::optional<double> epsilon_s;  // "refine": {"simplify"}; unset: the default;
                                    // kMinEpsilonS … kMaxEpsilonS
  std::string extra = "{}";         // JSON object: fields this version does not know, kept on save
};

struct Document {
  static constexpr int kVersion = 1;
  std::vector<std::shared_ptr<const PartSource>> parts;  // in modelling order, never null
  uint64_t last_part = 0;    // largest n for which an id "part-n" was ever given
  std::string extra = "{}";  // as above

  /// Index of the part with this id, or nothing.
  std::optional<size_t> find(const std::string& id) const;
};

/// The n of an id "part-n"; 0 for any other id.
uint64_t partNumber(const std::string& id);
/// Raises `last_part` to a number whose id no part has or had, and returns it.
uint64_t takePartNumber(Document& document);
std::string partId(uint64_t number);
std::string defaultPartName(uint64_t number);

}  // namespace marrow
