#include <algorithm>
#include <array>
#include <cmath>

#include "io/export_text.h"
#include "io/part_export.h"

namespace marrow {
namespace {

using namespace svg;

// Lengths below are those of the picture, in pixels.
constexpr double kDrawing = 900;  // longer side of the drawing
constexpr double kMargin = 30;
constexpr double kLegendHeight = 460;

constexpr std::array<JointKind, 3> kKinds = {JointKind::terminal, JointKind::sleeve,
                                             JointKind::junction};

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
  double width() const { return legendX() + Legend::kWidth; }
  double height() const { return std::max(drawing_.y + 2 * kMargin, kLegendHeight); }

 private:
  void include(Vec2 point, double radius) {
    low_ = {std::min(low_.x, point.x - radius), std::min(low_.y, point.y - radius)};
    high_ = {std::max(high_.x, point.x + radius), std::max(high_.y, point.y + radius)};
  }

  Vec2 low_, high_, drawing_;
  double scale_ = 1;
};

std::string points(const Frame& frame, const std::vector<Vec2>& polygon) {
  std::string text;
  for (Vec2 point : polygon) text += (text.empty() ? "" : " ") + pair(frame.point(point));
  return text;
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

std::string bones(const Frame& frame, const PartSkeleton& skeleton) {
  std::string text = openGroup(
      "bones",
      "fill=\"#3c3a36\" fill-opacity=\"0.55\" stroke=\"#22201d\" stroke-linejoin=\"round\"");
  for (const auto& one : skeleton.bones) {
    text += bone(frame.point(skeleton.joints[one[0]].position),
                 frame.point(skeleton.joints[one[1]].position));
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

constexpr size_t kMostLetters = 26;  // that fit the legend
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

  Legend legend(frame.legendX(), kMargin + 20);
  legend.title(name.empty() ? "Unnamed part" : shortened(name, kMostLetters));
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
  std::string svg = open(frame.width(), frame.height(), name);
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
