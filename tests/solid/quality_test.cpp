// The judges of solids, on meshes whose faults are known.
#include "solid/quality.h"

#include "solid/exact_orientation.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/creatures.h"

using namespace marrow;

namespace {

Mesh together(Mesh mesh, const Mesh& other) {
  const uint32_t base = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({base + a, base + b, base + c});
  return mesh;
}

}  // namespace

TEST_CASE("quality: balls, rings and several of them have their genus and components") {
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 2), ring = torusMesh({9, 0, 0}, 2, 0.5, 20, 10);
  const SolidReport one = inspectSolid(ball), two = inspectSolid(together(ball, ring));
  CHECK(one.closed);
  CHECK(one.manifold);
  CHECK(one.genus == 0);
  CHECK(one.components == 1);
  CHECK(one.self_intersections == 0);
  CHECK(two.genus == 1);
  CHECK(two.components == 2);
  CHECK(two.self_intersections == 0);
  CHECK(two.volume == Approx(signedVolume(ball) + signedVolume(ring)));
}

TEST_CASE("quality: each way in which two triangles can meet is found") {
  const Vec3 a = {0, 0, 0}, b = {4, 0, 0}, c = {0, 4, 0};
  const struct {
    const char* name;
    std::array<Vec3, 3> other;
    size_t count;
  } cases[] = {
      {"pierced", {Vec3{1, 1, -1}, {1, 1, 1}, {9, 9, 0.5}}, 1},
      {"apart", {Vec3{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, 0},
      {"beside, in one plane", {Vec3{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}, 0},
      {"inside, in one plane", {Vec3{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}}, 1},
      {"around, in one plane", {Vec3{-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}}, 1},
      {"across, in one plane", {Vec3{-1, 1, 0}, {9, 1, 0}, {9, 1.1, 0}}, 1},
      {"a corner on the face", {Vec3{1, 1, 0}, {1, 1, 5}, {2, 1, 5}}, 1},
      {"a corner on the edge", {Vec3{2, 0, 0}, {2, -1, 5}, {3, -1, 5}}, 1},
      {"a corner just over the face", {Vec3{1, 1, 1e-300}, {1, 1, 5}, {2, 1, 5}}, 0},
      {"an edge along the edge", {Vec3{1, 0, 0}, {3, 0, 0}, {2, -1, 1}}, 1},
  };
  for (const auto& [name, other, count] : cases) {
    INFO(name);
    Mesh mesh;
    mesh.positions = {a, b, c, other[0], other[1], other[2]};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    CHECK(countSelfIntersections(mesh) == count);
    mesh.triangles = {{4, 3, 5}, {2, 1, 0}};
    CHECK(countSelfIntersections(mesh) == count);
  }
}

TEST_CASE("quality: triangles with common corners meet only beyond them") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0},  {0, 4, 0}, {4, 4, 0},
                    {1, 1, 1}, {9, 9, -1}, {0, 4, 3}, {1, 1, 0}};
  const auto count = [&](std::array<uint32_t, 3> one, std::array<uint32_t, 3> other) {
    mesh.triangles = {one, other};
    return countSelfIntersections(mesh);
  };
  CHECK(count({0, 1, 2}, {1, 3, 2}) == 0);  // two halves of a square
  CHECK(count({0, 1, 2}, {1, 2, 6}) == 0);  // a fold that is not closed
  CHECK(count({0, 1, 2}, {2, 1, 7}) == 1);  // a closed one
  CHECK(count({0, 1, 2}, {0, 1, 2}) == 1);
  CHECK(count({0, 1, 2}, {0, 4, 5}) == 1);  // out of the corner, through the face
  CHECK(count({0, 1, 2}, {0, 4, 6}) == 0);
  CHECK(count({0, 1, 2}, {0, 7, 4}) == 1);  // along the face
}

TEST_CASE("quality: the signs of nearly flat tetrahedra are those of exact arithmetic") {
  Random random(21);
  for (int i = 0; i < 2000; ++i) {
    // d is on the plane but for its last bits, and the corners are whole: the sign of what was
    // added decides.
    const auto whole = [&] { return static_cast<double>(random.below(2001) - 1000); };
    const Vec3 a = {whole(), whole(), whole()}, b = {whole(), whole(), whole()},
               c = {whole(), whole(), whole()};
    const Vec3 normal = cross(b - a, c - a);
    if (normal.z == 0) continue;
    const Vec3 d = a + (b - a) * random.below(5) + (c - a) * random.below(5);
    CHECK(exactOrientation(a, b, c, d) == 0);
    const double up = std::nextafter(d.z, 1e9);
    CHECK(exactOrientation(a, b, c, {d.x, d.y, up}) == (normal.z > 0 ? 1 : -1));
    CHECK(exactOrientation(c, b, a, {d.x, d.y, up}) == (normal.z > 0 ? -1 : 1));
  }
}

TEST_CASE("quality: closed is closed and nothing else") {
  Mesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  CHECK(isClosed(box));
  Mesh open = box;
  open.triangles.pop_back();
  CHECK_FALSE(isClosed(open));
  Mesh turned = box;
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  CHECK_FALSE(isClosed(turned));
  Mesh twice = box;
  twice.triangles.insert(twice.triangles.end(), box.triangles.begin(), box.triangles.end());
  CHECK_FALSE(isClosed(twice));
  Mesh wild = box;
  wild.triangles[0][0] = 77;
  CHECK_FALSE(isClosed(wild));
  CHECK_FALSE(isClosed({}));
}
