// Seams made soft.
#include "solid/blend.h"

#include <map>

#include "solid/quality.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/creatures.h"

using namespace marrow;

namespace {

/// The largest angle's cosine between triangles of different parts that share an edge.
double sharpestSeam(const MergedMesh& merged) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> sides;
  const auto normal = [&](uint32_t t) {
    const auto& [i, j, k] = merged.mesh.triangles[t];
    const Vec3 a = merged.mesh.positions[i];
    const Vec3 n = cross(merged.mesh.positions[j] - a, merged.mesh.positions[k] - a);
    return n / length(n);
  };
  double sharpest = 1;
  for (uint32_t t = 0; t < merged.mesh.triangles.size(); ++t) {
    for (size_t i = 0; i < 3; ++i) {
      sides[{merged.mesh.triangles[t][i], merged.mesh.triangles[t][(i + 1) % 3]}] = t;
    }
  }
  for (const auto& [edge, t] : sides) {
    const auto other = sides.find({edge.second, edge.first});
    if (other == sides.end()) continue;
    if (merged.part_of_triangle[t] == merged.part_of_triangle[other->second]) continue;
    sharpest = std::min(sharpest, dot(normal(t), normal(other->second)));
  }
  return sharpest;
}

MergedMesh twoBalls() {
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 4);
  return merged({ball, moved(ball, {1.4, 0.3, 0.1})});
}

}  // namespace

TEST_CASE("blend: a larger radius makes seams softer and the solid larger") {
  const MergedMesh sharp = twoBalls();
  double seam = sharpestSeam(sharp), volume = signedVolume(sharp.mesh);
  CHECK(seam < 0.2);
  for (const double radius : {0.15, 0.3, 0.6}) {
    INFO("radius " << radius);
    const MergedMesh soft = blendSeams(sharp, {radius});
    const SolidReport report = inspectSolid(soft.mesh);
    CHECK(report.closed);
    CHECK(report.manifold);
    CHECK(report.self_intersections == 0);
    CHECK(report.genus == 0);
    CHECK(sharpestSeam(soft) > seam);
    CHECK(report.volume > volume);
    seam = sharpestSeam(soft);
    volume = report.volume;
  }
  CHECK(seam > 0.8);
}

TEST_CASE("blend: what is farther from the seams than the radius stays where it is") {
  const MergedMesh sharp = twoBalls();
  const MergedMesh soft = blendSeams(sharp, {0.3});
  CHECK(soft.mesh.triangles == sharp.mesh.triangles);
  size_t still = 0;
  for (size_t v = 0; v < sharp.mesh.positions.size(); ++v) {
    double nearest = 10;
    for (size_t u = 0; u < sharp.mesh.positions.size(); ++u) {
      if (!sharp.on_seam[u]) continue;
      nearest = std::min(nearest, distance(sharp.mesh.positions[v], sharp.mesh.positions[u]));
    }
    if (nearest < 0.3) continue;
    CHECK(soft.mesh.positions[v] == sharp.mesh.positions[v]);
    ++still;
  }
  CHECK(still > 100);
  CHECK(blendSeams(sharp, {0}).mesh.positions == sharp.mesh.positions);
  CHECK(blendSeams({}, {1}).mesh.triangles.empty());
}

TEST_CASE("blend: whatever is merged and blended stays a solid with unit normals") {
  Random random(41);
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 3), ring = torusMesh({0, 0, 0}, 1.2, 0.3, 24, 10);
  for (int round = 0; round < 30; ++round) {
    INFO("round " << round);
    std::vector<Mesh> meshes;
    const int count = 2 + random.below(5);
    for (int i = 0; i < count; ++i) {
      Affine place = randomRotation(random);
      const Vec3 stretch = {random.between(0.2, 1), random.between(0.2, 1), random.between(0.2, 1)};
      place.move = Vec3{random.unit(), random.unit(), random.unit()} * 1.5;
      meshes.push_back(mapped(random.below(3) ? ball : ring, [&](Vec3 p) {
        return place({p.x * stretch.x, p.y * stretch.y, p.z * stretch.z});
      }));
    }
    const MergedMesh sharp = merged(meshes);
    const SolidReport before = inspectSolid(sharp.mesh);
    for (const double radius : {0.05, 0.2, 1.0}) {
      const MergedMesh soft = blendSeams(sharp, {radius});
      const SolidReport after = inspectSolid(soft.mesh);
      CHECK(after.closed);
      CHECK(after.manifold);
      CHECK(after.self_intersections == 0);
      CHECK(after.genus == before.genus);
      CHECK(after.volume > before.volume * 0.999);
      for (const auto& normals : soft.corner_normals) {
        for (const Vec3 n : normals) {
          if (std::fabs(length(n) - 1) > 1e-9) FAIL_CHECK("a normal of length " << length(n));
        }
      }
    }
  }
}
