#include "bench/connect_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "base/box.h"
#include "bench/parted_creatures.h"
#include "document/evaluation.h"
#include "support/random.h"

namespace marrow::bench {
namespace {

// Shares of the diagonal of the child's box, of a bone, of the smaller body's volume.
constexpr double kFar = 0.1;
constexpr double kOutside = 0.02;
constexpr double kOverlap = 0.01;

/// A closed mesh in space, asked whether points are inside.
class SolidBody {
 public:
  SolidBody(const Mesh& mesh, const Frame& frame) : mesh_(mesh), frame_(frame) {
    for (const Vec3 p : mesh.positions) {
      box_.include(p);
      world_.include(frame.toWorld(p));
    }
    cells_.resize(kSide * kSide);
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      Box2 box;
      for (const uint32_t v : mesh.triangles[t]) box.include(flat(mesh.positions[v]));
      for (int y = row(box.low.y); y <= row(box.high.y); ++y) {
        for (int x = column(box.low.x); x <= column(box.high.x); ++x) {
          cells_[static_cast<size_t>(y * kSide + x)].push_back(t);
        }
      }
    }
  }

  const Box3& box() const { return world_; }

  /// grown: as if the body were larger by this, seen along z.
  bool has(Vec3 world) const {
    const Vec3 p = frame_.toLocal(world);
    if (!box_.has(p)) return false;
    // Off the edges that points in the parts' planes lie on.
    const Vec2 at{p.x + 1.1e-7, p.y + 0.7e-7};
    bool inside = false;
    for (const uint32_t t : cells_[static_cast<size_t>(row(p.y) * kSide + column(p.x))]) {
      const auto& [i, j, k] = mesh_.triangles[t];
      const Vec3 a = mesh_.positions[i], b = mesh_.positions[j], c = mesh_.positions[k];
      const double u = cross(flat(b) - at, flat(c) - at), v = cross(flat(c) - at, flat(a) - at),
                   w = cross(flat(a) - at, flat(b) - at);
      if ((u > 0) != (v > 0) || (v > 0) != (w > 0) || u + v + w == 0) continue;
      if ((u * a.z + v * b.z + w * c.z) / (u + v + w) > p.z) inside = !inside;
    }
    return inside;
  }

  double volume() const {
    double six = 0;
    for (const auto& [i, j, k] : mesh_.triangles) {
      six += dot(mesh_.positions[i], cross(mesh_.positions[j], mesh_.positions[k]));
    }
    const double scale = frame_.scale();
    return std::abs(six) / 6 * scale * scale * scale;
  }

 private:
  static constexpr int kSide = 48;
  static Vec2 flat(Vec3 p) { return {p.x, p.y}; }
  static int cell(double t) { return std::clamp(static_cast<int>(t * kSide), 0, kSide - 1); }
  int column(double x) const { return cell((x - box_.low.x) / (box_.high.x - box_.low.x)); }
  int row(double y) const { return cell((y - box_.low.y) / (box_.high.y - box_.low.y)); }

  const Mesh& mesh_;
  Frame frame_;
  Box3 box_, world_;
  std::vector<std::vector<uint32_t>> cells_;
};

/// What two bodies share: points of it, and how much of the smaller one it is.
struct Shared {
  std::vector<Vec3> points;
  double share = 0;

  double distanceTo(Vec3 p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3 point : points) nearest = std::min(nearest, distance(p, point));
    return nearest;
  }
};

Shared sharedBy(const SolidBody& one, const SolidBody& other) {
  constexpr int kSteps = 24;
  Shared shared;
  Box3 both;
  both.low = most(one.box().low, other.box().low);
  both.high = least(one.box().high, other.box().high);
  const Vec3 size = both.size();
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) return shared;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      for (int k = 0; k < kSteps; ++k) {
        const Vec3 p =
            both.low + Vec3{size.x * (i + 0.5), size.y * (j + 0.5), size.z * (k + 0.5)} / kSteps;
        if (one.has(p) && other.has(p)) shared.points.push_back(p);
      }
    }
  }
  const double volume = size.x * size.y * size.z * static_cast<double>(shared.points.size()) /
                        (kSteps * kSteps * kSteps);
  shared.share = volume / std::min(one.volume(), other.volume());
  return shared;
}

struct Counts {
  int attachments = 0, wrong = 0, far = 0, outside = 0;
  int bones = 0, bones_outside = 0;
  int joints = 0, parts = 0;
};

/// A creature, its bodies and its rig.
class Judging {
 public:
  Judging(const PartedCreature& creature, Counts& counts, bool verbose)
      : creature_(creature), counts_(counts), verbose_(verbose), evaluation_(previewOptions()) {
    evaluation_.update(creature.document);
    parts_ = evaluation_.rigParts();
    for (const RigPart& part : parts_) {
      bodies_.emplace_back();
      if (part.part) bodies_.back().emplace(part.part->mesh, part.placed->frame);
    }
  }

  void judge() {
    const Rig& rig = evaluation_.rig();
    for (const auto& [child_id, parent_id] : creature_.hangs) {
      const uint32_t child = indexOf(child_id), parent = indexOf(parent_id);
      if (!bodies_[child] || !bodies_[parent]) continue;
      const Shared shared = sharedBy(*bodies_[child], *bodies_[parent]);
      if (shared.share <= kOverlap) continue;
      ++counts_.attachments;
      const auto found = std::find_if(rig.connections.begin(), rig.connections.end(),
                                      [&](const Connection& c) { return c.child == child; });
      if (found == rig.connections.end() || found->parent != parent) {
        ++counts_.wrong;
        const bool missing = found == rig.connections.end();
        say("wrong or missing", child, missing ? child : found->parent, shared.share);
        continue;
      }
      const double off =
          shared.distanceTo(found->child_position) / length(bodies_[child]->box().size());
      if (off > kFar) {
        ++counts_.far;
        say("far", child, parent, off);
      }
      const double outside = outsideOf(found->child_position, found->parent_position);
      if (outside > kOutside) {
        ++counts_.outside;
        say("outside", child, parent, outside);
      }
    }
    counts_.joints += static_cast<int>(rig.joints.size());
    counts_.parts += static_cast<int>(parts_.size());
    judgeBones(evaluation_.rig());
    for (const double factor : {0.5, 2.0, 4.0}) {
      Refinement refine;
      refine.simplify = Refinement::kSimplify * factor;
      refine.merge = Refinement::kMerge * factor;
      refine.prune = Refinement::kPrune * factor;
      refine.collapse = Refinement::kCollapse * factor;
      judgeBones(refineRig(parts_, rig.connections, refine));
    }
  }

 private:
  uint32_t indexOf(const std::string& id) const {
    uint32_t i = 0;
    while (parts_[i].placed->id != id) ++i;
    return i;
  }

  void judgeBones(const Rig& rig) {
    for (const auto& [a, b] : rig.bones) {
      ++counts_.bones;
      const double outside = outsideOf(rig.joints[a].position, rig.joints[b].position);
      if (!(outside > kOutside)) continue;
      ++counts_.bones_outside;
      if (verbose_) {
        std::fprintf(stderr, "%s: bone %s – %s outside by %.2f\n", creature_.name.c_str(),
                     rig.joints[a].name.c_str(), rig.joints[b].name.c_str(), outside);
      }
    }
  }

  /// Which share of a bone is in no body.
  double outsideOf(Vec3 a, Vec3 b) const {
    constexpr int kSteps = 50;
    int outside = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const Vec3 p = lerp(a, b, static_cast<double>(i) / kSteps);
      outside += std::none_of(bodies_.begin(), bodies_.end(),
                              [&](const auto& body) { return body && body->has(p); });
    }
    return static_cast<double>(outside) / (kSteps + 1);
  }

  void say(const char* what, uint32_t child, uint32_t other, double value) const {
    if (!verbose_) return;
    std::fprintf(stderr, "%s: %s: %s (%s) – %s (%s): %.3f\n", creature_.name.c_str(), what,
                 parts_[child].source->name.c_str(), parts_[child].placed->id.c_str(),
                 parts_[other].source->name.c_str(), parts_[other].placed->id.c_str(), value);
  }

  const PartedCreature& creature_;
  Counts& counts_;
  bool verbose_;
  Evaluation evaluation_;
  std::vector<RigPart> parts_;
  std::vector<std::optional<SolidBody>> bodies_;
};

}  // namespace

std::vector<QualityRow> connectQuality(bool verbose) {
  Counts counts;
  int creatures = 0;
  for (const PartedCreature& creature : partedCreatures()) {
    ++creatures;
    Judging(creature, counts, verbose).judge();
  }
  const std::string of = "of " + std::to_string(counts.attachments) + " attachments in " +
                         std::to_string(creatures) + " creatures";
  const auto count = [&](std::string what, int value, double most, const std::string& note) {
    return QualityRow{std::move(what), static_cast<double>(value), most, false, "", note};
  };
  std::vector<QualityRow> rows{
      count("parts that overlap: wrong or missing attachments", counts.wrong, 1, of),
      count("parts that overlap: child's joint over 10 % of it from where they do", counts.far, 3,
            of),
      count("parts that overlap: connecting bones outside of the bodies", counts.outside, 0, of),
      count(
          "bones outside of the bodies at any threshold", counts.bones_outside, 0,
          "of " + std::to_string(counts.bones) + " bones at 0.5, 1, 2 and 4 times the thresholds")};
  QualityRow joints;
  joints.what = "joints a part, of parts put together";
  joints.value = static_cast<double>(counts.joints) / counts.parts;
  joints.wanted = 4;
  joints.note =
      std::to_string(counts.joints) + " joints of " + std::to_string(counts.parts) + " parts";
  rows.push_back(std::move(joints));
  return rows;
}

}  // namespace marrow::bench
