#include "pose/skin.h"

#include <cmath>

#include "pose/rigs.h"
#include "support/catch.h"
#include "surface/mesh.h"

namespace marrow {
namespace {

/// An upright tube about y from −length to length, closed at both ends by its middle.
struct Tube {
  Mesh mesh;
  std::vector<Vec3> normals;
  std::vector<VertexSkin> skin;  // joint 0 below, 1 above, even in between over `blend`
};

Tube tube(double length, double radius, double blend) {
  constexpr uint32_t kAround = 24, kRings = 41;
  Tube made;
  const double step = 2 * length / (kRings - 1);
  for (uint32_t ring = 0; ring < kRings; ++ring) {
    for (uint32_t i = 0; i < kAround; ++i) {
      const double angle = 6.283185307179586 * i / kAround;
      made.mesh.positions.push_back(
          {radius * std::cos(angle), -length + step * ring, radius * std::sin(angle)});
    }
  }
  const auto at = [&](uint32_t ring, uint32_t i) { return ring * kAround + i % kAround; };
  for (uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    for (uint32_t i = 0; i < kAround; ++i) {
      made.mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring, i + 1)});
      made.mesh.triangles.push_back({at(ring, i + 1), at(ring + 1, i), at(ring + 1, i + 1)});
    }
  }
  const auto bottom = static_cast<uint32_t>(made.mesh.positions.size());
  made.mesh.positions.push_back({0, -length, 0});
  made.mesh.positions.push_back({0, length, 0});
  for (uint32_t i = 0; i < kAround; ++i) {
    made.mesh.triangles.push_back({bottom, at(0, i), at(0, i + 1)});
    made.mesh.triangles.push_back({bottom + 1, at(kRings - 1, i + 1), at(kRings - 1, i)});
  }
  made.normals = vertexNormals(made.mesh);
  for (const Vec3 p : made.mesh.positions) {
    const double above = std::min(1.0, std::max(0.0, 0.5 + p.y / blend));
    VertexSkin own;
    if (above >= 0.5) {
      own.joints = {1, 0, 0, 0};
      own.weights = {above, 1 - above, 0, 0};
    } else {
      own.joints = {0, above > 0 ? 1u : 0u, 0, 0};
      own.weights = {1 - above, above, 0, 0};
    }
    made.skin.push_back(own);
  }
  return made;
}

double volumeBent(const Tube& made, const Quaternion& bend, Skinning how) {
  SkinnedVertices bent;
  skin(made.mesh.positions, made.normals, made.skin, {{}, {bend, {}}}, how, bent);
  return inspect({bent.positions, made.mesh.triangles}).volume;
}

/// How far the bent tube comes to lie from both bones, in radii.
double bulge(const Tube& made, const Quaternion& bend, Skinning how) {
  SkinnedVertices bent;
  skin(made.mesh.positions, made.normals, made.skin, {{}, {bend, {}}}, how, bent);
  const Vec3 up = rotated(bend, {0, 1, 0});
  double most = 0;
  for (const Vec3 p : bent.positions) {
    const double below = length(p - Vec3{0, std::min(p.y, 0.0), 0});
    const double above = length(p - up * std::max(dot(p, up), 0.0));
    most = std::max(most, std::min(below, above) / 10);
  }
  return most;
}

}  // namespace

TEST_CASE("skin: who follows one joint moves with it, whatever the way of skinning", "[skin]") {
  Random random(1);
  for (const Skinning how : {Skinning::linear, Skinning::dualQuaternions}) {
    for (int run = 0; run < 100; ++run) {
      const std::vector<Rigid> motions{{randomTurn(random), randomRotation(random).x * 50},
                                       {randomTurn(random), randomRotation(random).y * 50}};
      const Vec3 p{random.between(-9, 9), 3, random.between(-9, 9)};
      VertexSkin own;
      own.joints[0] = 1;
      SkinnedVertices moved;
      skin({p}, {{0, 1, 0}}, {own}, motions, how, moved);
      CHECK(distance(moved.positions[0], motions[1](p)) < 1e-9);
      CHECK(distance(moved.normals[0], motions[1].direction({0, 1, 0})) < 1e-9);
    }
  }
}

TEST_CASE("skin: when all joints move alike everything moves so, even turned the other way round",
          "[skin]") {
  Random random(2);
  const Tube made = tube(50, 10, 40);
  for (const Skinning how : {Skinning::linear, Skinning::dualQuaternions}) {
    const Rigid motion{randomTurn(random), {4, 5, 6}};
    const Rigid same{motion.rotation * -1, motion.move};
    SkinnedVertices moved;
    skin(made.mesh.positions, made.normals, made.skin, {motion, same}, how, moved);
    for (size_t i = 0; i < moved.positions.size(); ++i) {
      CHECK(distance(moved.positions[i], motion(made.mesh.positions[i])) < 1e-9);
    }
  }
}

TEST_CASE("skin: an elbow at 90° loses volume by linear blending, less by dual quaternions",
          "[skin]") {
  const Tube made = tube(50, 10, 20);
  const double rest = inspect(made.mesh).volume;
  const double half = std::sqrt(0.5);
  const Quaternion elbow{0, 0, half, half}, twist{0, 1, 0, 0};
  const double linear = volumeBent(made, elbow, Skinning::linear) / rest;
  const double dual = volumeBent(made, elbow, Skinning::dualQuaternions) / rest;
  const double linear_twist = volumeBent(made, twist, Skinning::linear) / rest;
  const double dual_twist = volumeBent(made, twist, Skinning::dualQuaternions) / rest;
  CHECK(linear == Approx(0.966).margin(0.002));
  CHECK(dual == Approx(0.998).margin(0.002));
  CHECK(linear_twist == Approx(0.867).margin(0.002));  // the candy wrapper
  CHECK(dual_twist == Approx(0.991).margin(0.002));
  // Beyond the rest's radius: what bulges at the elbow.
  CHECK(bulge(made, elbow, Skinning::linear) == Approx(1.018).margin(0.002));
  CHECK(bulge(made, elbow, Skinning::dualQuaternions) == Approx(1.12).margin(0.002));
}

}  // namespace marrow
