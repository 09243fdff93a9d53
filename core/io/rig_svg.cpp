#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "base/box.h"
#include "io/export_text.h"
#include "io/rig_export.h"
#include "rig/names.h"

namespace marrow {
namespace {

// Lengths below are those of the picture, in pixels.
constexpr double kRow = 1500;     // width of the three drawings together, at most
constexpr double kTallest = 800;  // height of one
constexpr double kMargin = 30;
constexpr double kGap = 50;        // between drawings
constexpr double kHeading = 34;    // above them
constexpr size_t kMostNames = 14;  // of parts, in the legend
constexpr size_t kMostLetters = 24;

constexpr std::array<JointKind, 3> kKinds = {JointKind::terminal, JointKind::sleeve,
                                             JointKind::junction};
constexpr char kBoneStyle[] = "fill=\"#3c3a36\" fill-opacity=\"0.6\" stroke=\"#22201d\"";
constexpr char kConnectionStyle[] = "fill=\"#cc3399\" fill-opacity=\"0.75\" stroke=\"#8e1f69\"";
constexpr char kJointStroke[] = "stroke=\"#22201d\" stroke-width=\"1\"";
constexpr char kRootStyle[] = "fill=\"none\" stroke=\"#22201d\" stroke-width=\"2\"";

/// What one looks along; y up in the front and right views, −z up in the one from above.
struct Side {
  const char* name;
  Vec3 right, up;

  Vec2 operator()(Vec3 p) const { return {dot(p, right), dot(p, up)}; }
  /// Larger is nearer.
  double depth(Vec3 p) const { return dot(p, cross(right, up)); }
};
constexpr std::array<Side, 3> kSides = {{{"front", {1, 0, 0}, {0, 1, 0}},
                                         {"right", {0, 0, -1}, {0, 1, 0}},
                                         {"top", {1, 0, 0}, {0, 0, -1}}}};

/// A visible part in space.
struct Body {
  const RigPart* part;
  std::vector<Vec3> positions;
  Vec3 middle;
};

std::vector<Body> bodiesOf(const std::vector<RigPart>& parts) {
  std::vector<Body> bodies;
  for (const RigPart& part : parts) {
    if (!part.part || !part.source->visible || part.part->mesh.positions.empty()) continue;
    Body body{&part, {}, {}};
    for (Vec3 position : part.part->mesh.positions) {
      body.positions.push_back(part.placed->frame.toWorld(position));
      body.middle = body.middle + body.positions.back();
    }
    body.middle = body.middle / static_cast<double>(body.positions.size());
    bodies.push_back(std::move(body));
  }
  return bodies;
}

/// One side's place in the picture.
struct View {
  Side side;
  Box2 box;
  double scale = 1;
  Vec2 corner;  // top left

  Vec2 size() const { return extent() * scale; }
  Vec2 extent() const { return box.isEmpty() ? Vec2{} : box.size(); }
  Vec2 operator()(Vec3 p) const {
    const Vec2 flat = side(p);
    return corner + Vec2{flat.x - box.low.x, box.high.y - flat.y} * scale;
  }
};

/// The border of what faces the viewer, as loops of vertices. Filled by the non-zero rule they are
/// the silhouette.
std::vector<std::vector<uint32_t>> contours(const Body& body, const Side& side) {
  using Edge = std::pair<uint32_t, uint32_t>;
  std::vector<Edge> front;
  for (const auto& [a, b, c] : body.part->part->mesh.triangles) {
    const Vec2 p = side(body.positions[a]), q = side(body.positions[b]),
               r = side(body.positions[c]);
    if (cross(q - p, r - p) > 0) front.insert(front.end(), {{a, b}, {b, c}, {c, a}});
  }
  std::sort(front.begin(), front.end());
  std::multimap<uint32_t, uint32_t> border;
  for (const auto& [a, b] : front) {
    if (!std::binary_search(front.begin(), front.end(), Edge{b, a})) border.emplace(a, b);
  }
  std::vector<std::vector<uint32_t>> loops;
  while (!border.empty()) {
    std::vector<uint32_t> loop{border.begin()->first};
    for (auto next = border.begin(); next != border.end(); next = border.find(loop.back())) {
      loop.push_back(next->second);
      border.erase(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::string silhouette(const Body& body, const View& view) {
  std::string path;
  for (const auto& loop : contours(body, view.side)) {
    for (size_t i = 0; i + 1 < loop.size(); ++i) {
      path += (i == 0 ? 'M' : 'L') + svg::pair(view(body.positions[loop[i]]));
    }
    path += 'Z';
  }
  const std::string color = toString(body.part->source->color);
  return "<path fill=\"" + color + "\" stroke=\"" + color + "\" d=\"" + path + "\"/>\n";
}

std::string silhouettes(std::vector<const Body*> bodies, const View& view) {
  std::stable_sort(bodies.begin(), bodies.end(), [&](const Body* a, const Body* b) {
    return view.side.depth(a->middle) < view.side.depth(b->middle);
  });
  std::string text =
      "<g class=\"parts\" fill-opacity=\"0.3\" stroke-opacity=\"0.8\" stroke-linejoin=\"round\">\n";
  for (const Body* body : bodies) text += silhouette(*body, view);
  return text + "</g>\n";
}

/// Whether it leads from one part to another.
bool isConnection(const Rig& rig, const std::array<uint32_t, 2>& bone) {
  return rig.joints[bone[0]].part != rig.joints[bone[1]].part;
}

std::string bones(const Rig& rig, const View& view, bool connections) {
  std::string text = std::string("<g class=\"") + (connections ? "connections" : "bones") +
                     "\" stroke-linejoin=\"round\" " +
                     (connections ? kConnectionStyle : kBoneStyle) + ">\n";
  for (const auto& bone : rig.bones) {
    if (isConnection(rig, bone) != connections) continue;
    text += svg::bone(view(rig.joints[bone[0]].position), view(rig.joints[bone[1]].position), 4);
  }
  return text + "</g>\n";
}

std::string joints(const Rig& rig, const View& view) {
  std::string text = std::string("<g class=\"joints\" ") + kJointStroke + ">\n";
  for (const Rig::Joint& joint : rig.joints) {
    text += svg::circle(view(joint.position), 3.5,
                        std::string("fill=\"") + svg::colorOf(joint.kind) + "\"");
  }
  text += std::string("</g>\n<g class=\"roots\" ") + kRootStyle + ">\n";
  for (const uint32_t root : rig.roots) text += svg::circle(view(rig.joints[root].position), 8);
  return text + "</g>\n";
}

std::string heading(const View& view) {
  return "<text x=\"" + svg::fixed(view.corner.x) + "\" y=\"" + svg::fixed(kMargin + 14) +
         "\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" font-size=\"15\" " +
         "fill=\"#6d675c\">" + view.side.name + "</text>\n";
}

/// All at one scale, beside each other.
std::array<View, 3> arrange(const std::vector<Body>& bodies, const Rig& rig) {
  std::array<View, 3> views;
  double width = 0, height = 0;
  for (size_t i = 0; i < views.size(); ++i) {
    View& view = views[i];
    view.side = kSides[i];
    for (const Body& body : bodies) {
      for (Vec3 p : body.positions) view.box.include(view.side(p));
    }
    for (const Rig::Joint& joint : rig.joints) view.box.include(view.side(joint.position));
    width += view.extent().x;
    height = std::max(height, view.extent().y);
  }
  const double scale = width > 0 || height > 0 ? 1 / std::max(width / kRow, height / kTallest) : 1;
  double x = kMargin;
  for (View& view : views) {
    view.scale = scale;
    view.corner = {x, kMargin + kHeading};
    x += std::max(view.size().x, 40.0) + kGap;
  }
  return views;
}

svg::Legend legendOf(const std::string& name, double x, const Evaluation& character,
                     const std::vector<Body>& bodies, const std::vector<std::string>& names) {
  const Rig& rig = character.rig();
  std::array<size_t, 3> kinds{};
  for (const Rig::Joint& joint : rig.joints) ++kinds[static_cast<size_t>(joint.kind)];

  svg::Legend legend(x, kMargin + 20);
  legend.title(name.empty() ? "Unnamed character" : svg::shortened(name, kMostLetters));
  for (JointKind kind : kKinds) {
    legend.dot(5, kJointStroke + std::string(" fill=\"") + svg::colorOf(kind) + '"',
               svg::count(kinds[static_cast<size_t>(kind)], toString(kind)));
  }
  const auto connecting =
      static_cast<size_t>(std::count_if(rig.bones.begin(), rig.bones.end(),
                                        [&](const auto& bone) { return isConnection(rig, bone); }));
  legend.line("stroke=\"#3c3a36\" stroke-width=\"4\"",
              svg::count(rig.bones.size() - connecting, "bones within parts"));
  legend.line("stroke=\"#cc3399\" stroke-width=\"4\"", svg::count(connecting, "between parts"));
  legend.dot(8, kRootStyle, svg::count(rig.roots.size(), rig.roots.size() == 1 ? "root" : "roots"));

  const std::vector<uint32_t> unattached = unattachedParts(character);
  legend.gap();
  for (size_t i = 0; i < bodies.size() && i < kMostNames; ++i) {
    const auto part = static_cast<uint32_t>(bodies[i].part->placed - character.placed().data());
    const std::string color = toString(bodies[i].part->source->color);
    const bool alone = std::count(unattached.begin(), unattached.end(), part) > 0;
    legend.line("stroke=\"" + color + "\" stroke-opacity=\"0.5\" stroke-width=\"12\"",
                svg::shortened(names[part], kMostLetters - (alone ? 12 : 0)) +
                    (alone ? ", unattached" : ""));
  }
  if (bodies.size() > kMostNames) {
    legend.plain("and " + svg::count(bodies.size() - kMostNames, "more parts"));
  }
  return legend;
}

}  // namespace

std::string rigToSvg(const std::string& name, const Evaluation& character) {
  const Rig& rig = character.rig();
  const std::vector<RigPart> parts = character.rigParts();
  const std::vector<Body> bodies = bodiesOf(parts);
  const std::array<View, 3> views = arrange(bodies, rig);
  std::vector<const Body*> all;
  for (const Body& body : bodies) all.push_back(&body);

  const View& last = views.back();
  const double legend_x = last.corner.x + std::max(last.size().x, 40.0) + kGap;
  const svg::Legend legend = legendOf(name, legend_x, character, bodies, uniqueNames(parts));
  double height = legend.bottom();
  for (const View& view : views) height = std::max(height, view.corner.y + view.size().y);

  std::string text = svg::open(legend_x + svg::Legend::kWidth, height + kMargin, name);
  for (const View& view : views) {
    text += svg::openGroup(view.side.name, "stroke-width=\"1\"");
    text += heading(view) + silhouettes(all, view) + bones(rig, view, false) +
            bones(rig, view, true) + joints(rig, view) + "</g>\n";
  }
  return text + legend.svg() + "</svg>\n";
}

}  // namespace marrow
