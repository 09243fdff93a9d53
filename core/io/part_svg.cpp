#include <algorithm>
#include <array>
#include <cmath>

#include "io/part_export.h"

namespace marrow {
namespace {

// Lengths below are those of the picture, in pixels.
constexpr double kDrawing = 900;  // longer side of the drawing
constexpr double kMargin = 30;
constexpr double kLegendWidth = 290;
constexpr double kLegendHeight = 460;

constexpr std::array<JointKind, 3> kKinds = {JointKind::terminal, JointKind::sleeve,
                                             JointKind::junction};
const char* colorOf(JointKind kind) {
  switch (kind) {
    case JointKind::terminal:
      return "#d55e00";
    case JointKind::sleeve:
      return "#f0e442";
    case JointKind::junction:
      return "#0072b2";
  }
  return "#000";
}

/// Two decimals, whatever the locale.
std::string fixed(double value) {
  const long long hundredths = std::llround(value * 100);
  const long long size = hundredths < 0 ? -hundredths : hundredths;
  std::string text = std::to_string(size / 100);
  if (size % 100 != 0) {
    text += size % 100 < 10 ? ".0" : ".";
    text += std::to_string(size % 100);
  }
  return hundredths < 0 ? '-' + text : text;
}

std::string escaped(const std::string& name) {
  std::string text;
  for (char c : name) {
    switch (c) {
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '&':
        text += "&amp;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return text;
}

/// Model units → picture: y down, fitted.
class Frame {
 public:
  explicit Frame(const Part& part) {
    low_ = high_ = part.outline.dense.front();
    for (Vec2 point : part.outline.dense) include(point, 0);
    for (const auto& joint : part.skeleton.joints) include(joint.position, joint.radius);
    const Vec2 size = high_ - low_;
    scale_ = kDrawing / std::max(size.x, size.y);
    drawing_ = {size.x * scale_, size.y * scale_};
  }

  double length(double model) const { return model * scale_; }
  Vec2 point(Vec2 model) const {
    return {(model.x - low_.x) * scale_ + kMargin, (high_.y - model.y) * scale_ + kMargin};
  }
  double legendX() const { return drawing_.x + 2 * kMargin; }
  double width() const { return legendX() + kLegendWidth; }
  double height() const { return std::max(drawing_.y + 2 * kMargin, kLegendHeight); }

 private:
  void include(Vec2 point, double radius) {
    low_ = {std::min(low_.x, point.x - radius), std::min(low_.y, point.y - radius)};
    high_ = {std::max(high_.x, point.x + radius), std::max(high_.y, point.y + radius)};
  }

  Vec2 low_, high_, drawing_;
  double scale_ = 1;
};

std::string pair(Vec2 p) { return fixed(p.x) + ',' + fixed(p.y); }

std::string points(const Frame& frame, const std::vector<Vec2>& polygon) {
  std::string text;
  for (Vec2 point : polygon) text += (text.empty() ? "" : " ") + pair(frame.point(point));
  return text;
}

std::string openGroup(const char* id, const std::string& style) {
  return std::string("<g id=\"") + id + "\" " + style + ">\n";
}

std::string circle(Vec2 center, double radius, const std::string& style = {}) {
  return "<circle cx=\"" + fixed(center.x) + "\" cy=\"" + fixed(center.y) + "\" r=\"" +
         fixed(radius) + "\"" + (style.empty() ? "" : " " + style) + "/>\n";
}

std::string polygonOf(std::initializer_list<Vec2> corners) {
  std::string text = "<polygon points=\"";
  for (Vec2 corner : corners) text += pair(corner) + ' ';
  text.back() = '"';
  return text + "/>\n";
}

std::string balls(const Frame& frame, const PartSkeleton& skeleton) {
  std::string text;
  for (const auto& joint : skeleton.joints) {
    text += circle(frame.point(joint.position), frame.length(joint.radius));
  }
  return text;
}

/// A ball at each joint and the cone around each bone that touches its two.
std::string proxy(const Frame& frame, const PartSkeleton& skeleton) {
  std::string text = openGroup("proxy", "fill=\"#56b4e9\" opacity=\"0.2\"");
  for (const auto& bone : skeleton.bones) {
    const auto &a = skeleton.joints[bone[0]], &b = skeleton.joints[bone[1]];
    const Vec2 from = frame.point(a.position), to = frame.point(b.position);
    const double span = distance(from, to);
    const double ra = frame.length(a.radius), rb = frame.length(b.radius);
    const double sine = span > 0 ? (ra - rb) / span : 1;
    if (sine * sine >= 1) continue;  // one ball holds the other
    const Vec2 along = (to - from) / span;
    const Vec2 across = perpendicular(along) * std::sqrt(1 - sine * sine);
    const Vec2 left = along * sine + across, right = along * sine - across;
    text += polygonOf({from + left * ra, to + left * rb, to + right * rb, from + right * ra});
  }
  text += balls(frame, skeleton) + "</g>\n";
  text += openGroup("balls", "fill=\"none\" stroke=\"#3f9cd4\" stroke-opacity=\"0.55\"");
  return text + balls(frame, skeleton) + "</g>\n";
}

std::string arcs(const Frame& frame, const StraightSkeleton& skeleton, StraightSkeleton::Kind kind,
                 const std::string& style) {
  std::string path;
  for (const auto& edge : skeleton.edges) {
    if (edge.kind != kind) continue;
    path += 'M' + pair(frame.point(skeleton.nodes[edge.a])) + 'L' +
            pair(frame.point(skeleton.nodes[edge.b]));
  }
  return std::string("<path id=\"") + toString(kind) + "\" fill=\"none\" " + style + " d=\"" +
         path + "\"/>\n";
}

/// As animators draw them: a slim kite, widest near the joint it comes from.
std::string bones(const Frame& frame, const PartSkeleton& skeleton) {
  std::string text = openGroup(
      "bones",
      "fill=\"#3c3a36\" fill-opacity=\"0.55\" stroke=\"#22201d\" stroke-linejoin=\"round\"");
  for (const auto& bone : skeleton.bones) {
    const Vec2 from = frame.point(skeleton.joints[bone[0]].position);
    const Vec2 to = frame.point(skeleton.joints[bone[1]].position);
    const double span = distance(from, to);
    if (span <= 0) continue;
    const Vec2 side = perpendicular((to - from) / span) * std::min(5.0, span / 6);
    const Vec2 shoulder = lerp(from, to, 0.18);
    text += polygonOf({from, shoulder + side, to, shoulder - side});
  }
  return text + "</g>\n";
}

std::string joints(const Frame& frame, const PartSkeleton& skeleton) {
  std::string text = openGroup("joints", "stroke=\"#22201d\" stroke-width=\"1.2\"");
  for (const auto& joint : skeleton.joints) {
    text += circle(frame.point(joint.position), 5.5,
                   "fill=\"" + std::string(colorOf(joint.kind)) + "\"");
  }
  return text + "</g>\n";
}

/// Lines of text, each with a swatch that shows what it is about.
class Legend {
 public:
  explicit Legend(const Frame& frame) : x_(frame.legendX()) {}

  void title(const std::string& words) {
    text_ += "<text x=\"" + fixed(x_) + "\" y=\"" + fixed(y_) +
             "\" font-size=\"17\" font-weight=\"600\">" + escaped(words) + "</text>\n";
    y_ += 14;
  }
  void line(const std::string& style, const std::string& words) {
    y_ += kLine;
    text_ += "<line x1=\"" + fixed(x_) + "\" y1=\"" + fixed(y_ - 5) + "\" x2=\"" + fixed(x_ + 22) +
             "\" y2=\"" + fixed(y_ - 5) + "\" " + style + "/>\n";
    label(words);
  }
  void dot(double radius, const std::string& style, const std::string& words) {
    y_ += kLine;
    text_ += circle({x_ + 11, y_ - 5}, radius, style);
    label(words);
  }
  void plain(const std::string& words) {
    y_ += kLine;
    label(words);
  }
  void gap() { y_ += kLine / 2; }
  std::string svg() const {
    return "<g id=\"legend\" fill=\"#22201d\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" "
           "font-size=\"14\">\n" +
           text_ + "</g>\n";
  }

 private:
  static constexpr double kLine = 25;

  void label(const std::string& words) {
    text_ += "<text x=\"" + fixed(x_ + 32) + "\" y=\"" + fixed(y_) + "\">" + escaped(words) +
             "</text>\n";
  }

  double x_, y_ = kMargin + 20;
  std::string text_;
};

/// At most as many letters as fit the legend.
std::string shortened(const std::string& name) {
  constexpr size_t kMostLetters = 26;
  size_t letters = 0, end = 0;
  while (end < name.size()) {
    const bool starts_letter = (static_cast<unsigned char>(name[end]) & 0xc0) != 0x80;
    if (starts_letter && ++letters > kMostLetters) return name.substr(0, end) + "…";
    ++end;
  }
  return name.empty() ? "Unnamed part" : name;
}

std::string count(size_t number, const std::string& things) {
  return std::to_string(number) + ' ' + things;
}

constexpr char kOutlineStyle[] = "stroke=\"#b9ae97\" stroke-width=\"2.5\"";
constexpr char kPolygonStyle[] = "stroke=\"#22201d\" stroke-width=\"1.2\"";
constexpr char kPeripheralStyle[] = "stroke=\"#9aa3b5\" stroke-width=\"0.8\"";
constexpr char kArcStyle[] =
    "stroke=\"#cc3399\" stroke-width=\"1.6\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";

std::string legend(const Frame& frame, const std::string& name, const Part& part) {
  using Kind = StraightSkeleton::Kind;
  std::array<size_t, 3> edges{}, kinds{};
  for (const auto& edge : part.straight_skeleton.edges) ++edges[static_cast<size_t>(edge.kind)];
  for (const auto& joint : part.skeleton.joints) ++kinds[static_cast<size_t>(joint.kind)];

  Legend legend(frame);
  legend.title(shortened(name));
  legend.line(kOutlineStyle, "outline, " + count(part.outline.dense.size(), "points"));
  legend.line(kPolygonStyle, "polygon, " + count(part.outline.polygon.size(), "vertices"));
  legend.gap();
  legend.plain(
      std::string("straight skeleton by ") +
      (part.straight_skeleton.method == StraightSkeleton::Method::cgal ? "CGAL" : "wavefront"));
  legend.line(kPeripheralStyle, count(edges[static_cast<size_t>(Kind::peripheral)], "peripheral"));
  legend.line(kArcStyle, count(edges[static_cast<size_t>(Kind::skeleton)], "inner"));
  legend.gap();
  for (JointKind kind : kKinds) {
    legend.dot(
        5.5, "stroke=\"#22201d\" stroke-width=\"1.2\" fill=\"" + std::string(colorOf(kind)) + "\"",
        count(kinds[static_cast<size_t>(kind)], toString(kind)));
  }
  legend.line("stroke=\"#3c3a36\" stroke-width=\"4\"", count(part.skeleton.bones.size(), "bones"));
  legend.dot(9, "fill=\"#56b4e9\" fill-opacity=\"0.2\" stroke=\"#3f9cd4\"", "radii of the proxy");
  legend.gap();
  legend.plain("mesh: " + count(part.mesh.positions.size(), "vertices"));
  legend.plain(count(part.mesh.triangles.size(), "triangles"));
  return legend.svg();
}

}  // namespace

std::string partToSvg(const std::string& name, const Part& part) {
  const Frame frame(part);
  const std::string width = fixed(frame.width()), height = fixed(frame.height());
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" +
                    height + "\" viewBox=\"0 0 " + width + ' ' + height + "\">\n<title>" +
                    escaped(name) + "</title>\n<rect width=\"100%\" height=\"100%\" " +
                    "fill=\"#ffffff\"/>\n";
  svg += std::string("<polygon id=\"outline\" fill=\"#f6f2e8\" stroke-linejoin=\"round\" ") +
         kOutlineStyle + " points=\"" + points(frame, part.outline.dense) + "\"/>\n";
  svg += proxy(frame, part.skeleton);
  svg += arcs(frame, part.straight_skeleton, StraightSkeleton::Kind::peripheral, kPeripheralStyle);
  svg += arcs(frame, part.straight_skeleton, StraightSkeleton::Kind::skeleton, kArcStyle);
  svg += std::string("<polygon id=\"polygon\" fill=\"none\" ") + kPolygonStyle + " points=\"" +
         points(frame, part.outline.polygon) + "\"/>\n";
  svg += openGroup("vertices", "fill=\"#22201d\"");
  for (Vec2 vertex : part.outline.polygon) svg += circle(frame.point(vertex), 2);
  svg += "</g>\n";
  svg += bones(frame, part.skeleton);
  svg += joints(frame, part.skeleton);
  svg += legend(frame, name, part);
  return svg + "</svg>\n";
}

}  // namespace marrow
