#include "part/part.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "skeleton/inside.h"
#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/drawings.h"
#include "support/strokes.h"

using namespace marrow;

namespace {

Part must(Result<Part> part) {
  INFO(part.message());
  REQUIRE(part);
  return *part;
}

void requireSound(const Part& part) {
  REQUIRE(validate(part.mesh).empty());
  REQUIRE(part.normals.size() == part.mesh.positions.size());
  REQUIRE(part.depths.size() == part.mesh.positions.size());
  REQUIRE(part.inscribed_radii.size() == part.skeleton.joints.size());
  REQUIRE(part.skeleton.bones.size() + 1 == part.skeleton.joints.size());
  REQUIRE(part.inscribedRadius() > 0);
  for (const auto& joint : part.skeleton.joints) {
    REQUIRE(joint.radius > 0);
    REQUIRE(std::isfinite(joint.radius));
    REQUIRE(marrow::contains(part.outline.polygon, joint.position));
  }
}

bool sameSkeleton(const PartSkeleton& a, const PartSkeleton& b) {
  if (a.bones != b.bones || a.joints.size() != b.joints.size()) return false;
  for (size_t i = 0; i < a.joints.size(); ++i) {
    if (a.joints[i].kind != b.joints[i].kind) return false;
    if (a.joints[i].position != b.joints[i].position) return false;
  }
  return true;
}

void requireSame(const Part& a, const Part& b) {
  REQUIRE(sameSkeleton(a.skeleton, b.skeleton));
  REQUIRE(a.mesh.triangles == b.mesh.triangles);
  for (size_t i = 0; i < a.skeleton.joints.size(); ++i) {
    REQUIRE(a.skeleton.joints[i].radius == b.skeleton.joints[i].radius);
  }
  REQUIRE(a.mesh.positions.size() == b.mesh.positions.size());
  for (size_t i = 0; i < a.mesh.positions.size(); ++i) {
    REQUIRE(a.mesh.positions[i].x == b.mesh.positions[i].x);
    REQUIRE(a.mesh.positions[i].z == b.mesh.positions[i].z);
    REQUIRE(a.normals[i].z == b.normals[i].z);
  }
}

}  // namespace

TEST_CASE("part: a stroke becomes a closed mesh with a skeleton inside", "[part]") {
  for (int arms = 2; arms < 8; ++arms) requireSound(must(buildPart(softStar(arms, 100))));
}

TEST_CASE("part: another thickness gives what building anew gives", "[part]") {
  const std::vector<Vec2> stroke = softStar(5, 120);
  for (double epsilon_s : {0.1, 5.0, 200.0}) {
    PartOptions options;
    options.joints.epsilon_s = epsilon_s;
    const Part part = must(buildPart(stroke, options));
    for (double thickness : {0.05, 1.0, 3.3}) {
      options.inflate.thickness = thickness;
      const Part anew = must(buildPart(stroke, options));
      requireSame(withThickness(part, thickness), anew);
    }
  }
}

TEST_CASE("part: the preview has the skeleton of the finished part and fewer vertices", "[part]") {
  for (int arms = 2; arms < 8; ++arms) {
    const std::vector<Vec2> stroke = softStar(arms, 100);
    const Part preview = must(buildPart(stroke, previewOptions()));
    const Part finished = must(buildPart(stroke));
    requireSound(preview);
    REQUIRE(sameSkeleton(preview.skeleton, finished.skeleton));
    REQUIRE(preview.mesh.positions.size() < finished.mesh.positions.size() / 2);
  }
}

TEST_CASE("part: each stage is timed once, and all together", "[part]") {
  static double now_ms = 0;
  const Part part = must(buildPart(softStar(3, 100), {}, [] { return now_ms += 1; }));
  std::vector<std::string> stages;
  for (const auto& [stage, ms] : part.timings.stages_ms) {
    stages.push_back(stage);
    REQUIRE(ms == 1);
  }
  REQUIRE(stages == std::vector<std::string>{
                        "outline",
                        "straightSkeleton",
                        "axis",
                        "joints",
                        "triangulation",
                        "inflation",
                        "normals",
                        "proxy",
                    });
  REQUIRE(part.timings.total_ms == 8);
}

TEST_CASE("part: strokes from the smallest to the largest size are parts", "[part]") {
  const Part one = must(buildPart(softStar(5, 100)));
  for (int exponent : {-150, -60, -20, 20, 60, 150}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    std::vector<Vec2> stroke = softStar(5, 100);
    for (Vec2& point : stroke) point = point * scale;
    const Part part = must(buildPart(stroke));
    requireSound(part);
    // A power of two changes no digit on the way.
    REQUIRE(part.skeleton.bones == one.skeleton.bones);
    REQUIRE(part.mesh.triangles == one.mesh.triangles);
    REQUIRE(part.skeleton.joints[0].position == one.skeleton.joints[0].position * scale);
  }
}

TEST_CASE("part: a stroke too small for the arithmetic encloses no area", "[part]") {
  for (double scale : {1e-60, 1e-160, 1e-290}) {
    std::vector<Vec2> stroke = softStar(5, 100);
    for (Vec2& point : stroke) point = point * scale;
    REQUIRE(buildPart(stroke).status() == Status::noArea);
  }
}

TEST_CASE("part: far from the origin a stroke is a part or an error", "[part]") {
  for (double far : {1e3, 1e6, 1e9, 1e12, 1e15, 1e17, 1e20, 1e40}) {
    CAPTURE(far);
    const auto part = buildPart(softStar(5, 100, {far, -far}));
    if (far <= 1e9) REQUIRE(part);
    if (part) {
      REQUIRE(validate(part->mesh).empty());
    } else {
      REQUIRE(part.status() != Status::ok);
    }
  }
}

TEST_CASE("part: every real stroke is a sound part", "[part]") {
  const auto all = strokes::realStrokes();
  if (all.empty()) WARN("no real strokes here; skipped");
  for (const auto& stroke : all) {
    CAPTURE(stroke.name);
    requireSound(must(buildPart(stroke.points)));
    requireSound(must(buildPart(stroke.points, previewOptions())));
  }
}

TEST_CASE("part: the skeleton of a symmetric drawing is its own mirror image", "[part]") {
  for (const auto& shape : {strokes::star(5, 60, 150), strokes::rectangle(300, 120),
                            softStar(3, 100), softStar(6, 100), strokes::hand()}) {
    const auto both = [&] {
      PartOptions options;
      options.outline.symmetric = true;
      return must(buildPart(shape, options));
    }();
    REQUIRE(both.skeleton.mirror);
    const MirrorLine& line = *both.skeleton.mirror;
    const auto& joints = both.skeleton.joints;
    const double size = both.outline.perimeter;
    for (const auto& joint : joints) {
      const Vec2 image = line.mirrored(joint.position);
      CHECK(std::any_of(joints.begin(), joints.end(), [&](const auto& other) {
        return distance(other.position, image) < 1e-9 * size;
      }));
      // On the line, or clearly beside it: nothing is its own image by half.
      const double side = std::fabs(line.side(joint.position));
      CHECK((side < 1e-9 * size || side > 1e-4 * size));
    }
    for (const auto& branch : both.skeleton.branches) {
      REQUIRE(branch.image < both.skeleton.branches.size());
      CHECK(both.skeleton.branches[branch.image].levels.size() == branch.levels.size());
      CHECK(both.skeleton.branches[branch.image].levels == branch.levels);
    }
  }
}

TEST_CASE("part: no bone leaves what was drawn, whatever the threshold", "[part]") {
  for (const auto& stroke : strokes::strokeFamilies(5, 300)) {
    INFO(stroke.name);
    const Part part = must(buildPart(stroke.points));
    for (const double epsilon_s : {0.0, 1.0, 5.0, 100.0}) {
      for (const auto& branch : part.skeleton.branches) {
        Vec2 last = branch.samples[0].point;
        for (size_t i = 1; i < branch.samples.size(); ++i) {
          if (!isKept(branch.levels[i], epsilon_s * part.outline.scale())) continue;
          CHECK(segmentInside(part.outline.dense, last, branch.samples[i].point));
          CHECK(segmentInside(part.outline.polygon, last, branch.samples[i].point));
          last = branch.samples[i].point;
        }
      }
    }
  }
}

TEST_CASE("part: the levels of a branch say where joints are placed at any threshold", "[part]") {
  for (const auto& stroke : strokes::strokeFamilies(6, 100)) {
    INFO(stroke.name);
    const Part part = must(buildPart(stroke.points));
    for (const double epsilon_s : {0.0, 0.7, 3.0, 5.0, 8.0, 40.0}) {
      JointOptions options;
      options.epsilon_s = epsilon_s;
      const double scale = part.outline.scale();
      const auto placed =
          placeJoints(part.outline.polygon, part.axis, scale, options, &part.outline.dense,
                      part.skeleton.mirror ? &*part.skeleton.mirror : nullptr);
      REQUIRE(placed);
      REQUIRE(placed->branches.size() == part.skeleton.branches.size());
      for (size_t b = 0; b < placed->branches.size(); ++b) {
        const auto& branch = part.skeleton.branches[b];
        std::vector<uint32_t> kept;
        for (uint32_t i = 0; i < branch.levels.size(); ++i) {
          if (isKept(branch.levels[i], epsilon_s * scale)) kept.push_back(i);
        }
        CHECK(kept == placed->branches[b].at);
      }
    }
  }
}

TEST_CASE("part: branches, joints and bones tell of the same skeleton", "[part]") {
  for (const auto& stroke : strokes::strokeFamilies(7, 100)) {
    INFO(stroke.name);
    const Part part = must(buildPart(stroke.points));
    const auto& joints = part.skeleton.joints;
    const auto is_sleeve = [](const auto& joint) { return joint.kind == JointKind::sleeve; };
    CHECK(std::is_partitioned(joints.begin(), joints.end(),
                              [&](const auto& joint) { return !is_sleeve(joint); }));
    size_t bones = 0;
    for (const auto& branch : part.skeleton.branches) {
      REQUIRE(branch.first_bone == bones);
      REQUIRE(branch.at.size() == branch.joints.size());
      for (size_t k = 0; k < branch.joints.size(); ++k) {
        const auto& joint = joints[branch.joints[k]];
        CHECK(joint.position == branch.samples[branch.at[k]].point);
        CHECK(is_sleeve(joint) == (k > 0 && k + 1 < branch.joints.size()));
        if (k == 0) continue;
        const std::array<uint32_t, 2> bone{branch.joints[k - 1], branch.joints[k]};
        CHECK(part.skeleton.bones[bones++] == bone);
      }
    }
    CHECK(bones == part.skeleton.bones.size());
  }
}
