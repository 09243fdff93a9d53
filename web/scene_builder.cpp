#include "scene_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow {
namespace {

// Bones keep a size that can be seen and do not hide the part, at any zoom; larger on a large
// canvas.
constexpr double kBoneWidthShare = 0.09;  // radius ÷ length
constexpr double kBoneMin_px = 2.5, kBoneMax_px = 9;
constexpr double kJoint_px = 4.6, kEndJoint_px = 3.8;
constexpr double kInk_px = 3;
constexpr double kClosingDash_px = 7;

constexpr Rgba kBone{0.97f, 0.96f, 0.92f, 1};
constexpr Rgba kJoint{1.00f, 0.78f, 0.30f, 1};
constexpr Rgba kEndJoint{0.97f, 0.96f, 0.92f, 1};
constexpr Rgba kInk{0.16f, 0.20f, 0.27f, 1};
constexpr Rgba kClosing{0.16f, 0.20f, 0.27f, 0.35f};
constexpr Rgba kPolygon{0.13f, 0.29f, 0.53f, 0.9f};
constexpr Rgba kPeripheral{0.13f, 0.29f, 0.53f, 0.5f};
constexpr Rgba kInner{0.76f, 0.16f, 0.36f, 1};
constexpr Rgba kProxy{0.28f, 0.72f, 0.76f, 0.62f};

Rgba toRgba(Color color) {
  return {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
          static_cast<float>(color.b) / 255, 1};
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

  void addPart(const std::shared_ptr<const Part>& part, uint64_t mesh_id, Color color,
               bool selected) {
    Scene::Body body;
    body.mesh_id = mesh_id;
    body.part = part;
    body.color = toRgba(color);
    body.selected = selected;
    scene_.bodies.push_back(std::move(body));
    for (const Vec3& p : part->mesh.positions) grow(p);
    if (ui_.show.straight_skeleton) addStraightSkeleton(*part);
    if (ui_.show.proxy) addProxy(part->skeleton);
    if (ui_.show.bones) addBones(part->skeleton);
  }

  void addInk(const DrawTool& drawing) {
    const std::vector<Vec2> points = drawing.previewPoints();
    if (points.empty()) return;
    scene_.ink_camera = drawing.camera();
    const Vec3 target = drawing.camera().target;
    const auto place = [&](Vec2 p) { return relative({p.x, p.y, target.z}, target); };
    const double px = 1 / drawing.camera().zoom;
    const Vec2 gap = points.front() - points.back();
    const double dashes = std::min(std::floor(length(gap) / (kClosingDash_px * px)), 400.0);
    for (int i = 1; i < dashes; i += 2) {
      scene_.ink.push_back({place(points.back() + gap * (i / dashes)),
                            place(points.back() + gap * ((i + 1) / dashes)),
                            static_cast<float>(kInk_px * 0.7), kClosing});
    }
    const bool pen = drawing.kind() == PointerKind::pen;
    for (size_t i = 1; i < points.size(); ++i) {
      const double pressure = pen ? drawing.pressureNear(i, points.size()) : 0.5;
      scene_.ink.push_back({place(points[i - 1]), place(points[i]),
                            static_cast<float>(kInk_px * (0.5 + pressure)), kInk});
    }
    if (points.size() == 1) {
      scene_.ink.push_back({place(points[0]), place(points[0]), static_cast<float>(kInk_px), kInk});
    }
  }

  Scene finish() {
    if (low_.x <= high_.x) {
      scene_.low = relative(low_, ui_.camera.target);
      scene_.high = relative(high_, ui_.camera.target);
    }
    double reach = 1000 / ui_.camera.zoom;
    for (const Float3 corner : {scene_.low, scene_.high}) {
      reach = std::max(reach, 2.0 * (std::abs(corner.x) + std::abs(corner.y) + std::abs(corner.z)));
    }
    scene_.depth = static_cast<float>(reach);
    return std::move(scene_);
  }

 private:
  static Float3 relative(Vec3 model, Vec3 target) {
    const Vec3 p = model - target;
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }
  Float3 relative(Vec2 model) const { return relative({model.x, model.y, 0}, ui_.camera.target); }

  void grow(Vec3 p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }

  void addStraightSkeleton(const Part& part) {
    const StraightSkeleton& skeleton = part.straight_skeleton;
    for (const StraightSkeleton::Edge& edge : skeleton.edges) {
      const bool inner = edge.kind == StraightSkeleton::Kind::skeleton;
      const bool border = edge.kind == StraightSkeleton::Kind::border;
      scene_.overlay.push_back({relative(skeleton.nodes[edge.a]), relative(skeleton.nodes[edge.b]),
                                inner ? 2.2f : (border ? 1.6f : 1.0f),
                                inner ? kInner : (border ? kPolygon : kPeripheral)});
    }
  }

  void addProxy(const PartSkeleton& skeleton) {
    for (const PartSkeleton::Joint& joint : skeleton.joints) {
      scene_.proxy_balls.push_back(
          {relative(joint.position), static_cast<float>(joint.radius), kProxy});
    }
    for (const auto& [i, j] : skeleton.bones) {
      const PartSkeleton::Joint& a = skeleton.joints[i];
      const PartSkeleton::Joint& b = skeleton.joints[j];
      if (distance(a.position, b.position) <= std::abs(a.radius - b.radius)) continue;
      scene_.proxy_cones.push_back({relative(a.position), relative(b.position),
                                    static_cast<float>(a.radius), static_cast<float>(b.radius),
                                    kProxy});
    }
  }

  void addBones(const PartSkeleton& skeleton) {
    const double canvas_px = std::min(ui_.size.width, ui_.size.height);
    const double px = std::clamp(canvas_px / 900, 1.0, 2.5) / ui_.camera.zoom;
    for (const auto& [i, j] : skeleton.bones) {
      // The wide end lies at the joint with more flesh around it, as in a limb.
      const bool turned = skeleton.joints[j].radius > skeleton.joints[i].radius;
      const Vec2 head = skeleton.joints[turned ? j : i].position;
      const Vec2 tail = skeleton.joints[turned ? i : j].position;
      const double span = distance(head, tail);
      if (span <= 0) continue;
      const double radius = std::clamp(kBoneWidthShare * span, kBoneMin_px * px, kBoneMax_px * px);
      scene_.bones.push_back({relative(head), relative(tail), static_cast<float>(radius), kBone});
    }
    for (const PartSkeleton::Joint& joint : skeleton.joints) {
      const bool end = joint.kind != JointKind::junction;
      scene_.joints.push_back({relative(joint.position),
                               static_cast<float>((end ? kEndJoint_px : kJoint_px) * px),
                               end ? kEndJoint : kJoint});
    }
  }

  const UiState& ui_;
  Scene scene_;
  Vec3 low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity()};
  Vec3 high_{-low_.x, -low_.y, -low_.z};
};

}  // namespace

Scene buildScene(const std::vector<EvaluatedPart>& parts, const LivePart& live,
                 const DrawTool& drawing, const UiState& ui) {
  Builder builder(ui);
  for (const EvaluatedPart& part : parts) {
    if (!part.part) continue;
    builder.addPart(part.part, part.mesh_id, part.source->color, part.source->id == ui.selected);
  }
  if (live.part) builder.addPart(live.part, live.mesh_id, live.color, false);
  if (drawing.active() && drawing.isStroke()) builder.addInk(drawing);
  return builder.finish();
}

}  // namespace marrow
