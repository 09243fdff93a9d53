#include "solid/close.h"

#include <algorithm>
#include <limits>

#include "solid/solids.h"
#include "support/catch.h"

namespace marrow {
namespace {

double volumeOf(const Mesh& mesh) { return inspect(mesh).volume; }

void checkSolid(const Mesh& mesh) {
  const MeshReport report = inspect(mesh);
  CHECK(report.closed);
  CHECK(report.manifold);
  CHECK(report.volume > 0);
}

/// Every triangle with corners of its own, as STL has them.
Mesh apart(const Mesh& mesh) {
  Mesh loose;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(loose.positions.size());
    for (const uint32_t corner : triangle) loose.positions.push_back(mesh.positions[corner]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  return loose;
}

/// A ball of loose triangles whose corners nearly meet.
Mesh looseBall(Random& random, double gap) {
  Mesh loose = apart(sphereMesh({}, 1, 3));
  for (Vec3& p : loose.positions) {
    p = p + Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)} * gap;
  }
  return loose;
}

Mesh together(const Mesh& one, const Mesh& other) {
  Mesh both = one;
  const auto offset = static_cast<uint32_t>(one.positions.size());
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) {
    both.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return both;
}

template <typename Keeps>
Mesh without(Mesh mesh, const Keeps& keeps) {
  const auto gone = [&](const auto& t) {
    return !keeps((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
  };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), gone),
                       mesh.triangles.end());
  return mesh;
}

std::string reason(const Mesh& mesh) {
  const auto closed = closeSurface(mesh);
  REQUIRE(!closed);
  CHECK(closed.status() == Status::notSolid);
  return closed.message();
}

}  // namespace

TEST_CASE("close: what is closed stays as it is", "[close]") {
  for (const Mesh& mesh : {boxMesh({0, 0, 0}, {1, 2, 3}), sphereMesh({1, 2, 3}, 1, 3),
                           torusMesh({0, 0, 0}, 2, 1, 20, 12)}) {
    const auto closed = closeSurface(mesh);
    REQUIRE(closed);
    CHECK(closed->triangles.size() == mesh.triangles.size());
    CHECK(closed->positions.size() == mesh.positions.size());
    CHECK(volumeOf(*closed) == Approx(volumeOf(mesh)));
  }
}

TEST_CASE("close: loose triangles, turned any way, doubled and crushed become the solid again",
          "[close]") {
  Random random(1);
  const Mesh sphere = sphereMesh({}, 1, 3);
  for (int run = 0; run < 20; ++run) {
    Mesh loose = apart(sphere);
    for (auto& triangle : loose.triangles) {
      if (random.below(2)) std::swap(triangle[0], triangle[1]);
    }
    for (int i = 0; i < 5; ++i) {
      loose.triangles.push_back(loose.triangles[static_cast<size_t>(random.below(500))]);
      loose.triangles.push_back({7, 7, static_cast<uint32_t>(random.below(500))});
    }
    const auto closed = closeSurface(loose);
    REQUIRE(closed);
    checkSolid(*closed);
    CHECK(closed->triangles.size() == sphere.triangles.size());
    CHECK(volumeOf(*closed) == Approx(volumeOf(sphere)));
  }
}

TEST_CASE("close: folds without thickness vanish; faces that are there from both sides count once",
          "[close]") {
  Mesh folded = sphereMesh({}, 1, 2);
  const auto [a, b, c] = folded.triangles[5];
  // Another vertex in the place of c: rounding has put two corners of a thin fold there.
  folded.positions.push_back(folded.positions[c]);
  const auto added = static_cast<uint32_t>(folded.positions.size() - 1);
  folded.triangles.push_back({a, b, added});
  folded.triangles.push_back({b, a, c});
  const auto unfolded = closeSurface(apart(folded));
  REQUIRE(unfolded);
  CHECK(unfolded->triangles.size() == 128);

  Mesh twice = sphereMesh({}, 1, 2);
  for (size_t t = 0; t < 128; ++t) {
    const auto [i, j, k] = twice.triangles[t];
    twice.triangles.push_back({j, i, k});
  }
  const auto once = closeSurface(twice);
  REQUIRE(once);
  CHECK(once->triangles.size() == 128);
  checkSolid(*once);
}

TEST_CASE("close: corners that nearly meet are one, where that is what it takes", "[close]") {
  Random random(2);
  const Mesh loose = looseBall(random, 2e-6);
  const auto closed = closeSurface(loose);
  REQUIRE(closed);
  checkSolid(*closed);
  CHECK(closed->triangles.size() == 512);
}

TEST_CASE("close: flat holes of any shape and small ones get caps", "[close]") {
  // A bust: cut flat across.
  const Mesh ball = sphereMesh({}, 1, 4);
  const auto bust = closeSurface(without(ball, [](Vec3 p) { return p.y > -0.3; }));
  REQUIRE(bust);
  checkSolid(*bust);
  CHECK(volumeOf(*bust) < volumeOf(ball));
  CHECK(volumeOf(*bust) > 0.6 * volumeOf(ball));

  // A tube, open at both ends.
  const auto tube = closeSurface(
      without(boxMesh({0, 0, 0}, {1, 1, 5}), [](Vec3 p) { return p.z > 0.1 && p.z < 4.9; }));
  REQUIRE(tube);
  checkSolid(*tube);
  CHECK(volumeOf(*tube) == Approx(5));

  // The first triangles are gone, wherever they were.
  Mesh holed = sphereMesh({}, 1, 5);
  holed.triangles.erase(holed.triangles.begin(), holed.triangles.begin() + 6);
  const auto mended = closeSurface(holed);
  REQUIRE(mended);
  checkSolid(*mended);

  // A hole with more corners than are tried one by one.
  const auto fine = closeSurface(without(sphereMesh({}, 1, 6), [](Vec3 p) { return p.z < 0.5; }));
  REQUIRE(fine);
  checkSolid(*fine);
}

TEST_CASE("close: a corner on another's edge is no hole, however long the edge is", "[close]") {
  // One face is a grid, the corners of which lie on the edges of the others.
  for (const int steps : {2, 3, 90}) {
    const Mesh grid = gridBoxMesh({0, 0, 0}, {1, 2, 3}, steps);
    const Mesh plain = boxMesh({0, 0, 0}, {1, 2, 3});
    for (const bool seamed : {false, true}) {
      const Mesh mixed = together(without(grid, [](Vec3 p) { return p.x < 1e-9; }),
                                  without(plain, [](Vec3 p) { return p.x > 1e-9; }));
      const auto closed = closeSurface(seamed ? apart(mixed) : mixed);
      REQUIRE(closed);
      CHECK(validate(*closed).empty());
      CHECK(volumeOf(*closed) == Approx(6));
      CHECK(piecesOf(*closed).size() == 1);
      CHECK_FALSE(crossesItself(*closed));
    }
  }
  Mesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  box.triangles[1] = {0, 3, 8};
  box.triangles.push_back({8, 3, 1});
  box.positions.push_back({0.5, 0, 0});
  const auto closed = closeSurface(box);
  REQUIRE(closed);
  CHECK(validate(*closed).empty());
  CHECK(volumeOf(*closed) == Approx(1));
}

TEST_CASE("close: vertices that no triangle uses count for nothing", "[close]") {
  Random random(4);
  const Mesh loose = looseBall(random, 1e-7);
  const auto known = closeSurface(loose);
  REQUIRE(known);
  for (const Vec3 far : {Vec3{1e6, 0, 0}, Vec3{1e300, -1e300, 0},
                         Vec3{std::numeric_limits<double>::quiet_NaN(), 0, 0}}) {
    Mesh more = loose;
    more.positions.push_back(far);
    const auto closed = closeSurface(more);
    REQUIRE(closed);
    CHECK(closed->positions == known->positions);
    CHECK(closed->triangles == known->triangles);
  }
}

TEST_CASE("close: holes that meet at corners get a cap each", "[close]") {
  // Of a grid of squares on top of a box some along the diagonal are missing, or larger ones.
  const Mesh box = gridBoxMesh({0, 0, 0}, {1, 1, 1}, 8);
  const auto holed = [&](int field) {
    return without(box, [&](Vec3 p) {
      if (p.z < 1 - 1e-9) return true;
      const int i = static_cast<int>(p.x * 8) / field, k = static_cast<int>(p.y * 8) / field;
      const bool inside = field > 2 || (p.x > 0.25 && p.x < 0.75 && p.y > 0.25 && p.y < 0.75);
      return !inside || i != k;
    });
  };
  for (const int field : {1, 2, 4}) {
    for (const bool seamed : {false, true}) {
      CAPTURE(field, seamed);
      const Mesh mesh = holed(field);
      REQUIRE(mesh.triangles.size() < box.triangles.size());
      const auto closed = closeSurface(seamed ? apart(mesh) : mesh);
      REQUIRE(closed);
      CHECK(validate(*closed).empty());
      CHECK(volumeOf(*closed) == Approx(1));
      CHECK_FALSE(crossesItself(*closed));
    }
  }
}

TEST_CASE("close: pieces that cannot be closed are left out where the rest is the model",
          "[close]") {
  // Half a tube, open and bent.
  const Mesh card = without(torusMesh({3, 0, 0}, 1, 0.3, 20, 12), [](Vec3 p) { return p.y > 0; });
  const Mesh open = without(card, [](Vec3 p) { return p.z > 0; });
  const Mesh ball = sphereMesh({}, 1, 3);
  CHECK(!closeSurface(together(ball, open)));
  for (const bool seamed : {false, true}) {
    const Mesh both = together(ball, open);
    const auto closed = closeMost(seamed ? apart(both) : both);
    REQUIRE(closed);
    CHECK(closed->left_out == 1);
    CHECK(closed->mesh.triangles.size() == ball.triangles.size());
    CHECK(volumeOf(closed->mesh) == Approx(volumeOf(ball)));
  }
  const auto whole = closeMost(ball);
  REQUIRE(whole);
  CHECK(whole->left_out == 0);
  // Its eyes are not what somebody wants of a head.
  const auto eyes = closeMost(together(sphereMesh({3, 0, 0}, 0.1, 2), open));
  REQUIRE(!eyes);
  CHECK(eyes.message() == closeSurface(open).message());
}

TEST_CASE("close: what cannot be closed is refused with the reason", "[close]") {
  // The corner of a room: three squares.
  Mesh corner = boxMesh({0, 0, 0}, {1, 1, 1});
  corner.triangles.resize(6);
  corner = without(boxMesh({0, 0, 0}, {1, 1, 1}), [](Vec3 p) {
    return std::min({p.x, p.y, p.z}) < 1e-9;
  });
  CHECK(corner.triangles.size() == 6);
  CHECK(reason(corner).find("hole") != std::string::npos);

  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(reason(sheet).find("encloses nothing") != std::string::npos);

  Mesh fin = boxMesh({0, 0, 0}, {1, 1, 1});
  fin.positions.push_back({0, -1, -1});
  fin.triangles.push_back({0, 1, 8});
  CHECK(reason(fin).find("More than two") != std::string::npos);

  Mesh twisted;
  for (uint32_t i = 0; i < 12; ++i) {
    const double turn = 2 * kPi * i / 12, lean = turn / 2;
    const Vec3 out{std::cos(turn), std::sin(turn), 0};
    const Vec3 across = out * std::cos(lean) + Vec3{0, 0, std::sin(lean)};
    twisted.positions.push_back(out * 3 + across);
    twisted.positions.push_back(out * 3 - across);
  }
  for (uint32_t i = 0; i < 12; ++i) {
    const uint32_t a = 2 * i, b = 2 * i + 1;
    const uint32_t c = i == 11 ? 1 : a + 2, d = i == 11 ? 0 : a + 3;
    twisted.triangles.push_back({a, b, c});
    twisted.triangles.push_back({c, b, d});
  }
  CHECK(reason(twisted).find("one side") != std::string::npos);

  CHECK(reason({}).find("no surface") != std::string::npos);
}

TEST_CASE("close: solids that touch at corners, edges or faces stay solids", "[close]") {
  const Mesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  for (const Vec3 away : {Vec3{1, 1, 1}, Vec3{1, 1, 0}, Vec3{1, 0, 0}, Vec3{0.5, 0.5, 0.5}}) {
    const auto both = closeSurface(together(box, boxMesh(away, away + Vec3{1, 1, 1})));
    REQUIRE(both);
    checkSolid(*both);
    CHECK(volumeOf(*both) == Approx(2));
    CHECK(piecesOf(*both).size() == 2);
  }
  // The same of loose triangles, where the file does not say what belongs together.
  for (const Vec3 away : {Vec3{1, 1, 0}, Vec3{0, -1, 1}, Vec3{1, 0.5, 0.25}}) {
    Mesh assembly = together(box, boxMesh(away, away + Vec3{1, 1, 1}));
    for (auto& triangle : assembly.triangles) {
      std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    }
    const auto both = closeSurface(apart(assembly));
    REQUIRE(both);
    checkSolid(*both);
    CHECK(volumeOf(*both) == Approx(2));
    CHECK(piecesOf(*both).size() == 2);
    CHECK_FALSE(crossesItself(*both));
  }
  // A face that both have, cut along either diagonal.
  Mesh other = boxMesh({1, 0, 0}, {2, 1, 1});
  for (auto& triangle : other.triangles) {
    if (triangle == std::array<uint32_t, 3>{0, 4, 6}) triangle = {0, 4, 2};
    if (triangle == std::array<uint32_t, 3>{0, 6, 2}) triangle = {4, 6, 2};
  }
  const auto adjacent = closeSurface(apart(together(box, other)));
  REQUIRE(adjacent);
  checkSolid(*adjacent);
  CHECK(volumeOf(*adjacent) == Approx(2));
  CHECK(piecesOf(*adjacent).size() == 2);
  // Loose triangles that meet in one corner.
  const auto loose = closeSurface(apart(together(box, boxMesh({1, 1, 1}, {2, 2, 2}))));
  REQUIRE(loose);
  checkSolid(*loose);
  CHECK(loose->positions.size() == 16);
}

TEST_CASE("close: pieces face outward each, and those that enclose nothing go", "[close]") {
  Mesh inward = sphereMesh({5, 0, 0}, 1, 2);
  for (auto& triangle : inward.triangles) std::swap(triangle[0], triangle[1]);
  Mesh mixed = together(inward, boxMesh({0, 0, 0}, {1, 1, 1}));
  const auto first = static_cast<uint32_t>(mixed.positions.size());
  for (const Vec3 p : {Vec3{9, 0, 0}, Vec3{10, 0, 0}, Vec3{9, 1, 0}, Vec3{9.3, 0.3, 0}}) {
    mixed.positions.push_back(p);
  }
  for (const auto& [a, b, c] :
       {std::array<uint32_t, 3>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
    mixed.triangles.push_back({first + a, first + b, first + c});
  }
  const auto closed = closeSurface(mixed);
  REQUIRE(closed);
  checkSolid(*closed);
  const std::vector<Mesh> pieces = piecesOf(*closed);
  REQUIRE(pieces.size() == 2);
  for (const Mesh& piece : pieces) CHECK(volumeOf(piece) > 0.9);
}

TEST_CASE("close: triangles without area are flipped away, wherever corners lie on edges",
          "[close]") {
  Random random(8);
  for (int run = 0; run < 30; ++run) {
    Mesh mesh = boxMesh({0, 0, 0}, {3, 2, 1});
    // Corners on edges, of one of the two triangles alone; flat ones close the gap.
    for (int i = 0; i < 6; ++i) {
      const auto t = static_cast<size_t>(random.below(static_cast<int>(mesh.triangles.size())));
      const auto [a, b, c] = mesh.triangles[t];
      const Vec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
      if (length(cross(q - p, r - p)) < 1e-9) continue;
      const auto added = static_cast<uint32_t>(mesh.positions.size());
      mesh.positions.push_back(
          lerp(mesh.positions[a], mesh.positions[b], random.between(0.2, 0.8)));
      mesh.triangles[t] = {a, added, c};
      mesh.triangles.push_back({added, b, c});
      mesh.triangles.push_back({a, b, added});
    }
    REQUIRE(inspect(mesh).closed);
    REQUIRE(inspect(mesh).degenerate > 0);
    const auto closed = closeSurface(mesh);
    REQUIRE(closed);
    CHECK(validate(*closed).empty());
    CHECK(volumeOf(*closed) == Approx(6));
    CHECK_FALSE(crossesItself(*closed));
  }
}

TEST_CASE("close: what is left of twisted needles has a volume", "[close]") {
  Random random(9);
  int closed_count = 0;
  for (int run = 0; run < 200; ++run) {
    Mesh needle = boxMesh({0, 0, 0}, {1e-6, 1e-6, 1});
    for (Vec3& p : needle.positions) {
      if (random.below(2)) p.z = random.below(2);
    }
    const auto closed = closeSurface(needle);
    if (!closed) continue;
    ++closed_count;
    checkSolid(*closed);
  }
  CHECK(closed_count > 100);
}

TEST_CASE("close: a piece that crosses itself is told from two that cross each other", "[close]") {
  const Mesh box = boxMesh({0, 0, 0}, {2, 2, 2});
  CHECK_FALSE(crossesItself(together(box, boxMesh({1, 1, 1}, {3, 3, 3}))));
  Mesh pushed = sphereMesh({}, 1, 3);
  pushed.positions[0] = {-3, 0.1, 0.05};
  CHECK(crossesItself(pushed));
}

TEST_CASE("close: random damage is mended or refused, never wrong", "[close]") {
  Random random(3);
  int closed_count = 0;
  for (int run = 0; run < 300; ++run) {
    Mesh mesh = run % 2 ? apart(sphereMesh({}, 1, 2)) : torusMesh({}, 2, 1, 12, 8);
    for (int i = random.below(12); i > 0 && !mesh.triangles.empty(); --i) {
      auto& triangle = mesh.triangles[static_cast<size_t>(
          random.below(static_cast<int>(mesh.triangles.size())))];
      const auto any = static_cast<uint32_t>(random.below(static_cast<int>(mesh.positions.size())));
      switch (random.below(4)) {
        case 0:
          triangle = mesh.triangles.back();
          mesh.triangles.pop_back();
          break;
        case 1:
          triangle[static_cast<size_t>(random.below(3))] = any;
          break;
        case 2:
          std::swap(triangle[0], triangle[1]);
          break;
        default:
          mesh.positions[any] = mesh.positions[any] * random.between(-1, 1);
      }
    }
    const auto closed = closeSurface(mesh);
    if (!closed) {
      CHECK(closed.status() == Status::notSolid);
      continue;
    }
    ++closed_count;
    const MeshReport report = inspect(*closed);
    if (!report.closed || !report.manifold || !(report.volume > 0)) FAIL("run " << run);
  }
  CHECK(closed_count > 20);
  CHECK(closed_count < 290);
}

}  // namespace marrow
