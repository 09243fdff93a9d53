// What the exports of this room share: JSON a field a line, words of OBJ files, shapes of SVG ones.
#pragma once

#include <string>
#include <vector>

#include "base/timing.h"
#include "base/vec.h"
#include "io/json.h"
#include "skeleton/joints.h"
#include "surface/mesh.h"

namespace marrow {

/// Milliseconds by stage, and "total".
Json timingsToTree(const Timings& timings);

/// The text of an object, each of its fields on a line of its own.
std::string toLines(const Json& object);

namespace obj {

/// The shortest text that reads back to the same bits.
std::string number(double value);
/// A name for one line: no control characters, no spaces, never empty.
std::string name(const std::string& words);
/// A line such as "v 1 2 3".
void appendVector(std::string& text, const char* keyword, Vec3 v);
/// Smoothed triangles; `first` is the number of their first vertex and normal in the file, from 1.
void appendFaces(std::string& text, const Mesh& mesh, size_t first);

}  // namespace obj

namespace svg {

const char* colorOf(JointKind kind);
/// Two decimals, whatever the locale.
std::string fixed(double value);
std::string escaped(const std::string& words);
/// At most so many letters, and "…" where there are more.
std::string shortened(const std::string& words, size_t most_letters);
std::string count(size_t number, const std::string& things);

std::string pair(Vec2 p);
std::string openGroup(const char* id, const std::string& style);
std::string circle(Vec2 center, double radius, const std::string& style = {});
std::string polygonOf(const std::vector<Vec2>& corners);
/// As animators draw them: a slim kite, widest near the joint it comes from. Nothing where both
/// ends are one.
std::string bone(Vec2 from, Vec2 to, double widest = 5);
/// The start of a picture on white ground, up to its first shape.
std::string open(double width, double height, const std::string& title);

/// Lines of text, each with a swatch that shows what it is about.
class Legend {
 public:
  static constexpr double kWidth = 290;

  Legend(double x, double y) : x_(x), y_(y) {}

  void title(const std::string& words);
  void line(const std::string& style, const std::string& words);
  void dot(double radius, const std::string& style, const std::string& words);
  void plain(const std::string& words);
  void gap() { y_ += kLine / 2; }
  /// Of its last line.
  double bottom() const { return y_; }
  std::string svg() const;

 private:
  static constexpr double kLine = 25;

  void label(const std::string& words);

  double x_, y_;
  std::string text_;
};

}  // namespace svg
}  // namespace marrow
