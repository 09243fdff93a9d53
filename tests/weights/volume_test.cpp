#include "weights/volume.h"

#include <limits>
#include <set>

#include "support/catch.h"
#include "surface/mesh.h"
#include "weights/bodies.h"

using namespace marrow;

namespace {

VolumeOptions about(double vertices) {
  VolumeOptions options;
  options.target_vertices = vertices;
  return options;
}

Vec3 pointOf(const Volume& volume, const Volume::Place& place) {
  Vec3 sum;
  for (size_t i = 0; i < 8; ++i) {
    sum = sum + volume.vertices[volume.cells[place.cell][i]] * place.shares[i];
  }
  return sum;
}

/// How many edges of cells lie between two vertices; −1: no way.
int wayBetween(const Volume& volume, uint32_t from, uint32_t to) {
  std::vector<std::vector<uint32_t>> neighbours(volume.vertices.size());
  for (const auto& cell : volume.cells) {
    for (uint32_t corner = 0; corner < 8; ++corner) {
      for (const uint32_t axis : {1u, 2u, 4u}) {
        neighbours[cell[corner]].push_back(cell[corner ^ axis]);
      }
    }
  }
  std::vector<int> way(volume.vertices.size(), -1);
  std::vector<uint32_t> front{from};
  way[from] = 0;
  for (size_t i = 0; i < front.size(); ++i) {
    for (const uint32_t v : neighbours[front[i]]) {
      if (way[v] >= 0) continue;
      way[v] = way[front[i]] + 1;
      front.push_back(v);
    }
  }
  return way[to];
}

uint32_t vertexAt(const Volume& volume, Vec3 point) {
  const auto place = volume.locate(point);
  REQUIRE(place);
  return volume.cells[place->cell][0];
}

/// Two arms along x with a gap in y between them, joined at x = 0.
Mesh fork(double gap) {
  Mesh mesh = box({0, 0, 0}, {100, 10, 10});
  append(mesh, box({0, 10 + gap, 0}, {100, 20 + gap, 10}));
  append(mesh, box({-10, 0, 0}, {1, 20 + gap, 10}));
  return mesh;
}

}  // namespace

TEST_CASE("volume: it has about as many vertices as asked for, as one piece") {
  const Mesh bodies[] = {box({0, 0, 0}, {3, 1, 1}), tube(straight({0, 0, 0}, {100, 30, 20}, 30), 4),
                         tube({{0, 0, 0}, {30, 0, 0}, {50, 20, 0}, {50, 40, 20}, {50, 40, 60}}, 8),
                         fork(3)};
  for (const Mesh& body : bodies) {
    REQUIRE(validate(tube(straight({0, 0, 0}, {100, 30, 20}, 30), 4)).empty());
    for (const double target : {300.0, 1000.0, 3500.0}) {
      const auto volume = makeVolume(body, about(target));
      REQUIRE(volume);
      CHECK(static_cast<double>(volume->vertices.size()) > 0.7 * target);
      CHECK(static_cast<double>(volume->vertices.size()) < 1.3 * target);
      CHECK(volume->piece_count == 1);
      REQUIRE(volume->pieces.size() == volume->vertices.size());
      std::set<uint32_t> used;
      for (const auto& cell : volume->cells) {
        CHECK(std::set<uint32_t>(cell.begin(), cell.end()).size() == 8);
        used.insert(cell.begin(), cell.end());
        for (uint32_t corner = 0; corner < 8; ++corner) {
          const Vec3 step = volume->vertices[cell[corner]] - volume->vertices[cell[0]];
          const Vec3 exact = Vec3{corner & 1 ? 1.0 : 0, corner & 2 ? 1.0 : 0, corner & 4 ? 1.0 : 0};
          CHECK(distance(step, exact * volume->spacing) < 1e-9 * volume->spacing);
        }
      }
      CHECK(used.size() == volume->vertices.size());
    }
  }
}

TEST_CASE("volume: cells lie where the body is, and only there") {
  const Vec3 low{-1, -2, 0.5}, high{4, 1, 2};
  const auto volume = makeVolume(box(low, high), about(2000));
  REQUIRE(volume);
  const double h = volume->spacing;
  for (const Vec3 p : volume->vertices) {
    CHECK(p.x > low.x - h);
    CHECK(p.y > low.y - h);
    CHECK(p.z > low.z - h);
    CHECK(p.x < high.x + h);
    CHECK(p.y < high.y + h);
    CHECK(p.z < high.z + h);
  }
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p{random.between(low.x, high.x), random.between(low.y, high.y),
                 random.between(low.z, high.z)};
    const auto place = volume->locate(p);
    REQUIRE(place);
    CHECK(distance(pointOf(*volume, *place), p) < 1e-9);
    double sum = 0;
    for (const double share : place->shares) {
      CHECK(share >= 0);
      sum += share;
    }
    CHECK(sum == Approx(1).epsilon(1e-12));
  }
  CHECK(!volume->locate({40, 0, 1}));
  CHECK(!volume->locate({std::numeric_limits<double>::quiet_NaN(), 0, 1}));
  CHECK(!volume->locate({1e300, 0, 1}));
}

TEST_CASE("volume: limbs that come near in space are not glued") {
  const auto volume = makeVolume(fork(2.2), about(1000));
  REQUIRE(volume);
  REQUIRE(volume->spacing > 1.7 * 2.2);
  const uint32_t a = vertexAt(*volume, {98, 9, 5}), b = vertexAt(*volume, {98, 13.2, 5});
  CHECK(wayBetween(*volume, a, b) > 2 * 90 / volume->spacing);
  CHECK(volume->piece_count == 1);
  // A point on the surface goes to the side that its inside is on.
  for (double x = 20; x < 100; x += 3.7) {
    const auto lower = volume->locate({x, 10, 5}, {x, 9.5, 5});
    const auto upper = volume->locate({x, 12.2, 5}, {x, 12.7, 5});
    REQUIRE(lower);
    REQUIRE(upper);
    CHECK(lower->cell != upper->cell);
  }
}

TEST_CASE("volume: limbs with a hairline between them are not glued, however they lie") {
  Random random(5);
  for (const double gap : {0.02, 0.3, 1.0}) {
    for (int run = 0; run < 6; ++run) {
      INFO("gap " << gap << ", run " << run);
      const auto map = randomSimilarity(random);
      const auto place = [&](Vec3 p) { return run == 0 ? p : map(p); };
      const auto volume = makeVolume(mapped(fork(gap), place), about(1000));
      REQUIRE(volume);
      const double size = distance(place({0, 0, 0}), place({1, 0, 0}));
      REQUIRE(volume->spacing > 3.5 * gap * size);
      const uint32_t a = vertexAt(*volume, place({98, 7, 5}));
      const uint32_t b = vertexAt(*volume, place({98, 13 + gap, 5}));
      CHECK(wayBetween(*volume, a, b) > 2 * 85 * size / volume->spacing);
      CHECK(volume->piece_count == 1);
    }
  }
}

TEST_CASE("volume: bodies with a hairline between them are pieces of their own") {
  Mesh bodies = box({0, 0, 0}, {10, 10, 10});
  append(bodies, box({10.01, 2, 2}, {20, 8, 8}));
  CHECK(makeVolume(bodies)->piece_count == 2);
}

TEST_CASE("volume: thin limbs do not fall apart") {
  for (const double radius : {0.3, 1.0, 2.0}) {
    Mesh body = box({-20, -20, -20}, {20, 20, 20});
    append(body, tube(straight({10, 3, 2}, {110, 43, 27}, 40), radius));
    const auto volume = makeVolume(body, about(800));
    REQUIRE(volume);
    CHECK(volume->piece_count == 1);
    CHECK(wayBetween(*volume, vertexAt(*volume, {0, 0, 0}), vertexAt(*volume, {109, 42.6, 26.7})) >
          100 / volume->spacing);
  }
}

TEST_CASE("volume: bodies that overlap are one piece, others their own") {
  Mesh bodies = box({0, 0, 0}, {10, 10, 10});
  append(bodies, box({9, 2, 2}, {20, 8, 8}));
  CHECK(makeVolume(bodies)->piece_count == 1);
  append(bodies, box({25, 2, 2}, {30, 8, 8}));
  const auto volume = makeVolume(bodies);
  CHECK(volume->piece_count == 2);
  CHECK(wayBetween(*volume, vertexAt(*volume, {5, 5, 5}), vertexAt(*volume, {27, 5, 5})) == -1);
}

TEST_CASE("volume: mirrored bodies have mirrored volumes") {
  Mesh body = tube({{0, 0, 0}, {30, 10, 0}, {50, 20, 10}, {60, 40, 20}}, 8);
  append(body, tube({{0, 0, 0}, {-30, 10, 0}, {-50, 20, 10}, {-60, 40, 20}}, 5));
  const Mesh mirrored = insideOut(mapped(body, [](Vec3 p) { return Vec3{-p.x, p.y, p.z}; }));
  const auto one = makeVolume(body, about(1500)), other = makeVolume(mirrored, about(1500));
  REQUIRE(one);
  REQUIRE(other);
  REQUIRE(one->vertices.size() == other->vertices.size());
  CHECK(one->spacing == Approx(other->spacing).epsilon(1e-12));
  const auto sorted = [](const Volume& volume, double side) {
    std::multiset<std::array<long, 3>> places;
    for (const Vec3 p : volume.vertices) {
      places.insert(
          {std::lround(side * p.x * 100), std::lround(p.y * 100), std::lround(p.z * 100)});
    }
    return places;
  };
  CHECK(sorted(*one, 1) == sorted(*other, -1));
}

TEST_CASE("volume: a lattice centred on the plane of symmetry treats both sides alike") {
  // Something on one side only moves the middle of the box.
  Mesh body = box({-10, 0, 0}, {10, 10, 10});
  append(body, box({8, 4, 4}, {33.3, 6, 6}));
  VolumeOptions options = about(1000);
  options.centre = Vec3{0, 0, 0};
  const auto volume = makeVolume(body, options);
  REQUIRE(volume);
  std::set<std::array<long, 3>> places;
  const auto place = [&](double x, Vec3 p) {
    return std::array<long, 3>{std::lround(x * 100), std::lround(p.y * 100),
                               std::lround(p.z * 100)};
  };
  for (const Vec3 p : volume->vertices) places.insert(place(p.x, p));
  for (const Vec3 p : volume->vertices) {
    if (p.x < -volume->spacing / 2) CHECK(places.count(place(-p.x, p)) == 1);
  }
}

TEST_CASE("volume: a body turned inside out has the same volume") {
  const Mesh body = fork(3);
  const auto one = makeVolume(body), other = makeVolume(insideOut(body));
  REQUIRE(one);
  REQUIRE(other);
  CHECK((one->cells == other->cells));
}

TEST_CASE("volume: hostile meshes give a volume or a reason") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  CHECK(makeVolume({}).status() == Status::meshFailed);
  CHECK(makeVolume({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}}).status() == Status::meshFailed);
  CHECK(makeVolume({{{kNan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).status() ==
        Status::meshFailed);
  CHECK(makeVolume({{{1, 2, 3}}, {{0, 0, 0}}}).status() == Status::meshFailed);
  CHECK(makeVolume({{{1, 2, 3}}, {{0, 1, 2}}}).status() == Status::meshFailed);

  const Mesh good = tube(straight({0, 0, 0}, {100, 30, 20}, 10), 10);
  Mesh bad = good;
  bad.positions[17].y = kNan;
  bad.triangles.push_back({0, 1, 1000000});
  CHECK(makeVolume(bad));
  Mesh open = good;
  open.triangles.resize(open.triangles.size() / 2);
  CHECK(makeVolume(open));
  const Mesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  CHECK(makeVolume(flat));
  for (const double scale : {1e-30, 1e-3, 1e30, 1e150}) {
    const auto volume = makeVolume(mapped(good, [&](Vec3 p) { return p * scale; }));
    REQUIRE(volume);
    CHECK(volume->piece_count == 1);
    CHECK(volume->vertices.size() > 2500);
  }
  const auto far = makeVolume(mapped(good, [](Vec3 p) { return p + Vec3{1e6, -1e6, 1e6}; }));
  REQUIRE(far);
  CHECK(far->piece_count == 1);
  VolumeOptions odd;
  for (const double centre : {1e9, kNan, -std::numeric_limits<double>::infinity()}) {
    odd.centre = Vec3{centre, 0, 0};
    CHECK(makeVolume(good, odd));
  }
  odd = about(kNan);
  CHECK(makeVolume(good, odd));
  CHECK(makeVolume(good, about(-3)));

  Random random(3);
  Mesh soup;
  for (int i = 0; i < 300; ++i) {
    soup.positions.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
  }
  for (int i = 0; i < 3000; ++i) {
    soup.triangles.push_back({static_cast<uint32_t>(random.below(300)),
                              static_cast<uint32_t>(random.below(300)),
                              static_cast<uint32_t>(random.below(300))});
  }
  const auto volume = makeVolume(soup);
  CHECK((volume ? volume->vertices.size() : 0) < 20000);
}
