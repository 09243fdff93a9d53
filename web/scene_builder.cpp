#include "scene_builder.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"

namespace marrow {
namespace {

// Bones keep a size that can be seen and do not hide the part, at any zoom; larger on a large
// canvas.
constexpr double kBoneWidthShare = 0.09;  // radius ÷ length
constexpr double kBoneMin_px = 2.5, kBoneMax_px = 9;
constexpr double kJoint_px = 4.6, kEndJoint_px = 3.8, kRoot_px = 6.2;
constexpr double kInk_px = 3;
constexpr double kClosingDash_px = 7;
constexpr double kSheetMargin = 0.35;  // of the model's size, around it

constexpr Rgba kBone{0.97f, 0.96f, 0.92f, 1};
constexpr Rgba kChosenBone{1.00f, 0.86f, 0.62f, 1};
constexpr Rgba kChosenBranch{1.00f, 0.62f, 0.22f, 1};
constexpr Rgba kJoint{1.00f, 0.78f, 0.30f, 1};
constexpr Rgba kEndJoint{0.97f, 0.96f, 0.92f, 1};
constexpr Rgba kRoot{0.93f, 0.42f, 0.10f, 1};
constexpr Rgba kInk{0.16f, 0.20f, 0.27f, 1};
constexpr Rgba kClosing{0.16f, 0.20f, 0.27f, 0.35f};
constexpr Rgba kPolygon{0.13f, 0.29f, 0.53f, 0.9f};
constexpr Rgba kPeripheral{0.13f, 0.29f, 0.53f, 0.5f};
constexpr Rgba kInner{0.76f, 0.16f, 0.36f, 1};
constexpr Rgba kProxy{0.28f, 0.72f, 0.76f, 0.62f};
constexpr Rgba kSheet{0.15f, 0.39f, 0.68f, 0.08f};
constexpr Rgba kSymmetrySheet{0.80f, 0.47f, 0.65f, 0.16f};

Rgba toRgba(Color color) {
  return {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
          static_cast<float>(color.b) / 255, 1};
}

/// Colours that differ from those of the joints before and behind.
Rgba jointColor(size_t joint) {
  const double hue = std::fmod(0.08 + 0.61803398875 * static_cast<double>(joint), 1.0) * 6;
  const auto channel = [&](double shift) {
    const double t = std::fmod(hue + shift, 6.0);
    return static_cast<float>(0.42 + 0.5 * std::clamp(std::abs(t - 3) - 1, 0.0, 1.0));
  };
  return {channel(0), channel(4), channel(2), 1};
}

class Builder {
 public:
  explicit Builder(const UiState& ui) : ui_(ui) {
    scene_.camera = ui.camera;
    scene_.size = ui.size;
    scene_.dpr = ui.dpr;
    scene_.show_mesh = ui.show.mesh;
    scene_.show_wireframe = ui.show.wireframe;
    scene_.show_shadow = ui.show.mesh;
  }

  void addPart(const std::shared_ptr<const Part>& part, uint64_t mesh_id, const Frame& frame,
               Color color, bool selected) {
    Scene::Body body;
    body.mesh_id = mesh_id;
    body.part = part;
    body.frame = frame;
    body.color = toRgba(color);
    body.selected = selected;
    scene_.bodies.push_back(std::move(body));
    double high = 0, low = 0;
    for (const Vec3& p : part->mesh.positions) {
      high = std::max(high, p.z);
      low = std::min(low, p.z);
    }
    const Vec3 up = frame.z() * high, down = frame.z() * low;
    for (const Vec2 p : part->outline.dense) {
      const Vec3 world = frame.toWorld(p);
      box_.include(world + up);
      box_.include(world + down);
    }
    if (ui_.show.straight_skeleton) addStraightSkeleton(*part, frame);
    if (ui_.show.proxy) addProxy(part->skeleton, frame);
  }

  /// In place of the parts.
  void addFigure(const Evaluation& evaluation, const Stance& stance, const FigureKeeper& keeper) {
    Scene::PosedFigure& posed = scene_.figure.emplace();
    posed.mesh_id = keeper.meshId();
    posed.figure = keeper.figure();
    posed.skinning = ui_.posing.skinning;
    const Figure& figure = *posed.figure;
    for (const Figure::Stretch& stretch : figure.stretches) {
      const PlacedPart* part = findPlaced(evaluation.placed(), stretch.part);
      posed.colors.push_back(
          toRgba(part ? evaluation.parts()[part->source].source->color : Color{}));
    }
    const auto motions = motionsOf(figure, stance.rest, marrow::posed(stance.rest, stance.pose));
    posed.joints.resize(motions.size());
    for (size_t i = 0; i < motions.size(); ++i) {
      const Quaternion& q = motions[i].rotation;
      const Vec3 move = motions[i](figure.origin) - figure.origin;
      posed.joints[i].rotation = {static_cast<float>(q.x), static_cast<float>(q.y),
                                  static_cast<float>(q.z), static_cast<float>(q.w)};
      posed.joints[i].move = {static_cast<float>(move.x), static_cast<float>(move.y),
                              static_cast<float>(move.z), 0};
    }
    if (ui_.tool == ToolKind::pose) showWeights(posed, stance.rest);
    for (const Vec3 p : posedVertices(keeper.outermost(), motions, ui_.posing.skinning).positions) {
      box_.include(p);
    }
  }

  Rgba posedBoneColor(const Rig::Joint& tail) const {
    return !ui_.posing.joint.empty() && tail.id == ui_.posing.joint ? kChosenBranch : kBone;
  }

  template <typename IsShown, typename ColorOf>
  void addRig(const Rig& rig, const IsShown& shown, const ColorOf& color_of) {
    const double canvas_px = std::min(ui_.size.width, ui_.size.height);
    const double px = std::clamp(canvas_px / 900, 1.0, 2.5) / ui_.camera.zoom;
    for (const auto& [i, j] : rig.bones) {
      const Rig::Joint &head = rig.joints[i], &tail = rig.joints[j];
      const double span = distance(head.position, tail.position);
      if (span <= 0 || !shown(tail)) continue;
      const double radius = std::clamp(kBoneWidthShare * span, kBoneMin_px * px, kBoneMax_px * px);
      scene_.bones.push_back({relative(head.position), relative(tail.position),
                              static_cast<float>(radius), color_of(tail)});
    }
    for (const Rig::Joint& joint : rig.joints) {
      if (!shown(joint)) continue;
      const bool root = joint.parent < 0, junction = joint.kind == JointKind::junction;
      const double size = root ? kRoot_px : (junction ? kJoint_px : kEndJoint_px);
      scene_.joints.push_back({relative(joint.position), static_cast<float>(size * px),
                               root ? kRoot : (junction ? kJoint : kEndJoint)});
    }
  }

  void addInk(const DrawTool& drawing) {
    const auto [right, up, back] = drawing.camera().axes();
    const Vec3 foot = back * dot(back, drawing.camera().target);
    std::vector<Vec3> points;
    for (const Vec2 p : drawing.previewPoints()) points.push_back(foot + right * p.x + up * p.y);
    const bool pen = drawing.kind() == PointerKind::pen;
    addInk(points, drawing.camera(), true,
           [&](size_t i) { return pen ? drawing.pressureNear(i, points.size()) : 0.5; });
  }
  /// A line by hand, and dashes from its end to its beginning.
  template <typename Pressure>
  void addInk(const std::vector<Vec3>& points, const Camera& camera, bool closes,
              const Pressure& pressure) {
    if (points.empty()) return;
    scene_.ink_camera = camera;
    const auto place = [&](Vec3 p) { return relative(p, camera.target); };
    const double px = 1 / camera.zoom;
    const Vec3 gap = points.front() - points.back();
    const double dashes =
        closes ? std::min(std::floor(length(gap) / (kClosingDash_px * px)), 400.0) : 0;
    for (int i = 1; i < dashes; i += 2) {
      scene_.ink.push_back({place(points.back() + gap * (i / dashes)),
                            place(points.back() + gap * ((i + 1) / dashes)),
                            static_cast<float>(kInk_px * 0.7), kClosing});
    }
    for (size_t i = 1; i < points.size(); ++i) {
      scene_.ink.push_back({place(points[i - 1]), place(points[i]),
                            static_cast<float>(kInk_px * (0.5 + pressure(i))), kInk});
    }
    if (points.size() == 1) {
      scene_.ink.push_back({place(points[0]), place(points[0]), static_cast<float>(kInk_px), kInk});
    }
  }

  /// The plane of a stroke, around the model: what is in front of it hides it.
  void addSheet(const Frame& frame) {
    if (box_.isEmpty()) return;
    const Vec3 middle = box_.middle();
    const Vec3 normal = frame.z() / frame.scale();
    const Vec3 center = middle - normal * dot(normal, middle - frame.origin);
    addRectangle(center, frame.x, frame.y, kSheet);
  }
  void addSymmetryPlane(const Plane& plane) {
    if (box_.isEmpty()) return;
    const Vec3 middle = mirroredOnto(box_.middle(), plane);
    const Vec3 helper = std::abs(plane.normal.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 across = cross(helper, plane.normal);
    const Vec3 u = across / length(across);
    addRectangle(middle, u, cross(plane.normal, u), kSymmetrySheet);
  }

  Scene finish() {
    if (!box_.isEmpty()) {
      scene_.low = relative(box_.low, ui_.camera.target);
      scene_.high = relative(box_.high, ui_.camera.target);
    }
    double reach = 1000 / ui_.camera.zoom;
    for (const Float3 corner : {scene_.low, scene_.high}) {
      reach = std::max(reach, 2.0 * (std::abs(corner.x) + std::abs(corner.y) + std::abs(corner.z)));
    }
    scene_.depth = static_cast<float>(reach);
    return std::move(scene_);
  }

 private:
  void showWeights(Scene::PosedFigure& posed, const Rig& rig) const {
    using Weights = Posing::Weights;
    if (ui_.posing.weights == Weights::hidden) return;
    const bool all = ui_.posing.weights == Weights::all;
    posed.show = all ? Scene::PosedFigure::Show::joints : Scene::PosedFigure::Show::weight;
    std::string held_by;
    for (size_t i = 0; i < rig.joints.size(); ++i) {
      if (rig.joints[i].id != ui_.posing.joint) continue;
      held_by = rig.joints[boneOf(rig, static_cast<uint32_t>(i))].id;
    }
    for (size_t i = 0; i < posed.joints.size(); ++i) {
      const float chosen = posed.figure->joints[i].id == held_by ? 1.0f : 0.0f;
      const Rgba color = all ? jointColor(i) : Rgba{chosen, 0, 0, 1};
      posed.joints[i].color = {color.r, color.g, color.b, 1};
    }
  }

  static Float3 toFloat(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  static Float3 relative(Vec3 model, Vec3 target) { return toFloat(model - target); }
  Float3 relative(Vec3 model) const { return relative(model, ui_.camera.target); }
  static Vec3 mirroredOnto(Vec3 p, const Plane& plane) {
    return p - plane.normal * distance(plane, p);
  }

  void addRectangle(Vec3 center, Vec3 x, Vec3 y, Rgba color) {
    const Vec3 half = box_.size() / 2;
    const auto reach = [&](Vec3 axis) {
      return (std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z) +
             kSheetMargin * length(half);
    };
    scene_.sheets.push_back(
        {relative(center), toFloat(x * reach(x)), toFloat(y * reach(y)), color});
  }

  void addStraightSkeleton(const Part& part, const Frame& frame) {
    const StraightSkeleton& skeleton = part.straight_skeleton;
    const auto place = [&](uint32_t node) { return relative(frame.toWorld(skeleton.nodes[node])); };
    for (const StraightSkeleton::Edge& edge : skeleton.edges) {
      const bool inner = edge.kind == StraightSkeleton::Kind::skeleton;
      const bool border = edge.kind == StraightSkeleton::Kind::border;
      scene_.overlay.push_back({place(edge.a), place(edge.b), inner ? 2.2f : (border ? 1.6f : 1.0f),
                                inner ? kInner : (border ? kPolygon : kPeripheral)});
    }
  }

  void addProxy(const PartSkeleton& skeleton, const Frame& frame) {
    const double scale = frame.scale();
    const auto place = [&](const PartSkeleton::Joint& joint) {
      return relative(frame.toWorld(joint.place()));
    };
    for (const PartSkeleton::Joint& joint : skeleton.joints) {
      scene_.proxy_balls.push_back(
          {place(joint), static_cast<float>(joint.radius * scale), kProxy});
    }
    for (const auto& [i, j] : skeleton.bones) {
      const PartSkeleton::Joint& a = skeleton.joints[i];
      const PartSkeleton::Joint& b = skeleton.joints[j];
      if (distance(a.place(), b.place()) <= std::abs(a.radius - b.radius)) continue;
      scene_.proxy_cones.push_back({place(a), place(b), static_cast<float>(a.radius * scale),
                                    static_cast<float>(b.radius * scale), kProxy});
    }
  }

  const UiState& ui_;
  Scene scene_;
  Box3 box_;  // around the bodies
};

}  // namespace

Scene buildScene(const Evaluation& evaluation, const Rig& rig, const LivePart& live,
                 const DrawTool& gesture, const Hand& hand, const std::optional<Plane>& symmetry,
                 const Stance& stance, const FigureKeeper& figure, const UiState& ui) {
  Builder builder(ui);
  const auto& placed = evaluation.placed();
  const bool posing = ui.tool == ToolKind::pose;
  for (const PlacedPart& one : placed) {
    const EvaluatedPart& part = evaluation.parts()[one.source];
    if (!part.part || !part.source->visible) continue;
    builder.addPart(part.shapeOf(one), part.meshOf(one), one.frame, part.source->color,
                    !posing && ui.selection.has(one.id));
  }
  const bool exports = ui.open.exporting && takesOneBody(ui.exporting.file);
  if ((posing || exports) && figure.figure()) builder.addFigure(evaluation, stance, figure);
  if (live.part) {
    for (const PlacedPart& one : live.placed) {
      builder.addPart(live.part, live.mesh_id, one.frame, live.source.color, false);
    }
  }
  if (ui.show.bones) {
    const auto isShown = [&](const Rig::Joint& joint) {
      return joint.part >= placed.size() ||
             evaluation.parts()[placed[joint.part].source].source->visible;
    };
    const auto colorOf = [&](const Rig::Joint& joint) {
      if (posing) return builder.posedBoneColor(joint);
      const bool chosen = joint.part < placed.size() && ui.selection.has(placed[joint.part].id);
      if (!chosen) return kBone;
      const bool branch =
          !ui.selection.branch.empty() && ui.selection.branch == std::to_string(joint.branch);
      return branch ? kChosenBranch : kChosenBone;
    };
    builder.addRig(posing ? stance.posed : rig, isShown, colorOf);
  }
  if (hand.mode() == Hand::Mode::stroke && gesture.isStroke()) {
    builder.addInk(gesture);
    if (!live.placed.empty()) builder.addSheet(live.placed.front().frame);
  }
  if (symmetry) builder.addSymmetryPlane(*symmetry);
  if (hand.mode() == Hand::Mode::contour) {
    builder.addInk(hand.contour().ink(), ui.camera, false, [](size_t) { return 0.5; });
  }
  return builder.finish();
}

}  // namespace marrow
