#include "surface/triangulation.h"

#include <algorithm>
#include <map>

#include "sketch/outline.h"
#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/meshes.h"
#include "support/outlines.h"
#include "support/strokes.h"
#include "surface/border.h"

using namespace marrow;

namespace {

using Triangle = std::array<uint32_t, 3>;

std::vector<Vec2> borderOf(const Triangulation& flat) {
  return {flat.points.begin(), flat.points.begin() + flat.border_count};
}

double cotangent(Vec2 apex, Vec2 a, Vec2 b) {
  return dot(a - apex, b - apex) / cross(a - apex, b - apex);
}

/// What is wrong with the flat triangles of an outline; empty when nothing is.
std::string fault(const std::vector<Vec2>& outline, const Triangulation& flat) {
  const uint32_t border = flat.border_count;
  const std::vector<Vec2> polygon = borderOf(flat);
  if (!isSimple(polygon)) return "the border touches itself";
  const double whole = signedArea(polygon), drawn = signedArea(outline);
  // A border of few points may cut bulges; no more than a little.
  if (std::fabs(whole - drawn) > 0.05 * drawn) return "the border is another shape";
  if (flat.triangles.size() != 2 * flat.points.size() - border - 2) return "Euler does not hold";

  double area = 0;
  std::map<std::pair<uint32_t, uint32_t>, double> cotangents;  // of angles across directed edges
  for (const Triangle& t : flat.triangles) {
    const Vec2 a = flat.points[t[0]], b = flat.points[t[1]], c = flat.points[t[2]];
    const double doubled = cross(b - a, c - a);
    if (!(doubled > 0)) return "a triangle has no area";
    area += doubled / 2;
    for (int k = 0; k < 3; ++k) {
      const uint32_t i = t[k], j = t[(k + 1) % 3], apex = t[(k + 2) % 3];
      const bool fresh =
          cotangents.insert({{i, j}, cotangent(flat.points[apex], flat.points[i], flat.points[j])})
              .second;
      if (!fresh) return "two triangles lie on the same side of an edge";
    }
  }
  if (std::fabs(area - whole) > 1e-9 * whole) return "the triangles do not tile the shape";
  for (const auto& [edge, angle] : cotangents) {
    const auto [i, j] = edge;
    const bool on_border = i < border && j == (i + 1) % border;
    const auto other = cotangents.find({j, i});
    if (on_border != (other == cotangents.end())) return "an edge of the border is missing";
    if (on_border) continue;
    if (i < border && j < border) return "an edge joins two border points";
    if (angle + other->second < -1e-6 * (1 + std::fabs(angle))) return "an edge is not Delaunay";
  }
  return "";
}

void checkSound(const std::string& name, const std::vector<Vec2>& outline, int target) {
  INFO(name << ", " << target << " points");
  TriangulationOptions options;
  options.target_points = target;
  const Result<Triangulation> flat = triangulate(outline, options);
  REQUIRE(flat);
  CHECK(fault(outline, *flat) == "");
  CHECK(flat->points[0] == outline[0]);
}

Outlines knownOutlines() {
  Random random(11);
  return {{"disc", discOutline(100, 200)},
          {"triangle", {{0, 0}, {10, 0}, {3, 8}}},
          {"square", rectangleOutline(1, 1)},
          {"strip", rectangleOutline(200, 20)},
          {"long strip", rectangleOutline(3000, 20)},
          {"star", starOutline(100, 30, 5)},
          {"many tips", starOutline(100, 60, 40)},
          {"spiral", spiralOutline(5, 4)},
          {"comb", combOutline(random, 9)},
          {"noise", blobOutline(random, 3000, 60, 0.4)},
          {"needles", jaggedOutline(random, 70)}};
}

std::vector<Vec2> changed(std::vector<Vec2> outline, double scale, Vec2 shift) {
  for (Vec2& p : outline) p = p * scale + shift;
  return outline;
}

}  // namespace

TEST_CASE(
    "triangulation: known shapes are tiled by Delaunay triangles of about the number asked for",
    "[triangulation]") {
  for (const auto& [name, outline] : knownOutlines()) {
    for (const int target : {60, 300, 1000, 2500}) {
      checkSound(name, outline, target);
      TriangulationOptions options;
      options.target_points = target;
      const double count = static_cast<double>(triangulate(outline, options)->points.size());
      INFO(name << ", " << target << " points, got " << count);
      if (target < 300) continue;
      CHECK(count > 0.65 * target);
      CHECK(count < 1.3 * target);
    }
  }
}

TEST_CASE("triangulation: random outlines are tiled by Delaunay triangles", "[triangulation]") {
  Random random(12);
  for (int i = 0; i < 250; ++i) {
    checkSound("jagged " + std::to_string(i), jaggedOutline(random, 3 + random.below(90)), 400);
    checkSound("comb " + std::to_string(i), combOutline(random, 1 + random.below(12)), 400);
    const std::vector<Vec2> blob =
        blobOutline(random, 20 + random.below(400), 1 + random.below(30), random.between(0, 0.6));
    if (isSimple(blob)) checkSound("blob " + std::to_string(i), blob, 100 + random.below(900));
  }
}

TEST_CASE("triangulation: real strokes are tiled by Delaunay triangles", "[triangulation]") {
  forEachRealOutline([](const std::string& name, const std::vector<Vec2>& outline) {
    for (const int target : {300, 1000}) checkSound(name, outline, target);
  });
}

TEST_CASE("triangulation: polygons that broke other programs are tiled by Delaunay triangles",
          "[triangulation]") {
  const std::vector<strokes::NamedStroke> hard = strokes::hardPolygons();
  if (hard.empty()) WARN("no hard polygons beside the project: skipped");
  for (const strokes::NamedStroke& polygon : hard) {
    const Result<Outline> outline = makeOutline(polygon.points);
    if (outline) checkSound(polygon.name, outline->dense, 1000);
    std::vector<Vec2> ring = polygon.points;
    if (signedArea(ring) < 0) std::reverse(ring.begin(), ring.end());
    if (isSimple(ring)) checkSound(polygon.name + " as it is", ring, 1000);
  }
}

TEST_CASE("triangulation: whatever a pen can draw is tiled by Delaunay triangles",
          "[triangulation]") {
  int drawn = 0;
  for (const strokes::NamedStroke& stroke : strokes::strokeFamilies(5, 600)) {
    const Result<Outline> outline = makeOutline(stroke.points);
    if (!outline) continue;
    ++drawn;
    checkSound(stroke.name, outline->dense, drawn % 3 == 0 ? 1000 : 300);
  }
  CHECK(drawn > 400);
}

TEST_CASE("triangulation: slivers, specks and continents are tiled", "[triangulation]") {
  for (const double size : {1e-4, 1e-2, 1.0, 1e6}) {
    for (const double aspect : {1.0, 10.0, 1e3, 1e4}) {
      checkSound("strip", rectangleOutline(size * aspect, size), 300);
      checkSound("turned strip",
                 {{0, 0},
                  {3 * size * aspect, 4 * size * aspect},
                  {3 * size * aspect - 4 * size, 4 * size * aspect + 3 * size},
                  {-4 * size, 3 * size}},
                 300);
      checkSound("needle", {{0, 0}, {size * aspect, 0}, {size * aspect / 3, size}}, 300);
    }
  }
}

TEST_CASE("triangulation: moving and scaling an outline by powers of two gives the same triangles",
          "[triangulation]") {
  for (const auto& [name, outline] : knownOutlines()) {
    // On a grid, so that moving is exact.
    std::vector<Vec2> snapped;
    for (const Vec2 p : outline) {
      snapped.push_back({std::round(p.x * 1024) / 1024, std::round(p.y * 1024) / 1024});
    }
    if (!isSimple(snapped)) continue;
    const Result<Triangulation> first = triangulate(snapped);
    REQUIRE(first);
    const Result<Triangulation> scaled = triangulate(changed(snapped, 0x1p-14, {}));
    REQUIRE(scaled);
    INFO(name);
    CHECK(first->triangles == scaled->triangles);
    bool same = first->points.size() == scaled->points.size();
    for (size_t i = 0; same && i < first->points.size(); ++i) {
      same = first->points[i] * 0x1p-14 == scaled->points[i];
    }
    CHECK(same);

    const Result<Triangulation> moved = triangulate(changed(snapped, 1, {512, -4096}));
    REQUIRE(moved);
    // A lattice point that is just far enough from the others may come or go.
    CHECK(static_cast<double>(moved->points.size()) ==
          Approx(static_cast<double>(first->points.size())).epsilon(0.01));
  }
}

TEST_CASE("triangulation: turned, mirrored and scaled outlines come out alike", "[triangulation]") {
  for (const auto& [name, outline] : knownOutlines()) {
    const Result<Triangulation> first = triangulate(outline);
    REQUIRE(first);
    std::vector<Vec2> turned, mirrored;
    for (const Vec2 p : outline) {
      turned.push_back(perpendicular(p));
      mirrored.push_back({-p.x, p.y});
    }
    std::reverse(mirrored.begin(), mirrored.end());
    for (const std::vector<Vec2>& other :
         {turned, mirrored, changed(outline, 1e4, {}), changed(outline, 1e-4, {})}) {
      checkSound(name, other, 1000);
      const double count = static_cast<double>(triangulate(other)->points.size());
      INFO(name << ": " << first->points.size() << " and " << count);
      CHECK(count == Approx(static_cast<double>(first->points.size())).epsilon(0.2));
    }
  }
}

TEST_CASE("triangulation: the same outline gives the same bits again", "[triangulation]") {
  for (const auto& [name, outline] : knownOutlines()) {
    const Result<Triangulation> a = triangulate(outline), b = triangulate(outline);
    INFO(name);
    CHECK(a->triangles == b->triangles);
    CHECK(a->points == b->points);
  }
}

TEST_CASE("triangulation: what is no outline is refused with a sentence", "[triangulation]") {
  CHECK(triangulate({}).status() == Status::tooFewPoints);
  CHECK(triangulate({{0, 0}, {1, 1}}).status() == Status::tooFewPoints);
  std::vector<Vec2> clockwise = discOutline(10, 30);
  std::reverse(clockwise.begin(), clockwise.end());
  CHECK(triangulate(clockwise).status() == Status::meshFailed);
  CHECK(triangulate({{0, 0}, {1, 0}, {2, 0}}).status() == Status::meshFailed);
  CHECK(triangulate({{0, 0}, {1, 0}, {std::nan(""), 1}}).status() == Status::meshFailed);
  CHECK(triangulate({{0, 0}, {1, 0}, {1, HUGE_VAL}}).status() == Status::meshFailed);
  CHECK(triangulate({{0, 0}, {5, 5}, {5, 0}, {0, 4}, {-9, 2}}).status() == Status::meshFailed);
  CHECK_FALSE(triangulate(clockwise).message().empty());
}

TEST_CASE("triangulation: any number of points may be asked for", "[triangulation]") {
  for (const int target : {-5, 0, 1, 3, 20, 20000}) {
    checkSound("disc", discOutline(10, 40), target);
    checkSound("star", starOutline(100, 30, 5), target);
  }
}

TEST_CASE("border: long edges are split evenly, drawn points stay", "[triangulation]") {
  const std::vector<Vec2> outline = starOutline(100, 40, 6);
  const std::vector<Vec2> border = fitBorder(outline, 10, 1000);
  size_t drawn = 0;
  double longest = 0, shortest = HUGE_VAL;
  for (size_t i = 0; i < border.size(); ++i) {
    drawn += std::count(outline.begin(), outline.end(), border[i]);
    const double edge = distance(border[i], border[(i + 1) % border.size()]);
    longest = std::max(longest, edge);
    shortest = std::min(shortest, edge);
  }
  CHECK(drawn == outline.size());
  CHECK(longest < 15);
  CHECK(shortest > 6);
}

TEST_CASE("border: a dense outline is thinned, its corners stay, the shape hardly changes",
          "[triangulation]") {
  std::vector<Vec2> dense;
  const std::vector<Vec2> star = starOutline(100, 40, 6);
  for (size_t i = 0; i < star.size(); ++i) {
    for (int k = 0; k < 500; ++k)
      dense.push_back(lerp(star[i], star[(i + 1) % star.size()], k / 500.0));
  }
  const std::vector<Vec2> border = fitBorder(dense, 10, 500);
  CHECK(border.size() < 120);
  CHECK(border.size() > 60);
  for (const Vec2 corner : star) {
    CHECK(distanceToBorder(border, corner) < 1);
  }
  CHECK(signedArea(border) == Approx(signedArea(star)).epsilon(0.01));
}

TEST_CASE("border: thinning never makes an outline touch itself", "[triangulation]") {
  // Two jagged walls that run a hair apart: cutting the teeth of one cuts into the other.
  Random random(13);
  for (int run = 0; run < 100; ++run) {
    std::vector<Vec2> outline;
    const int steps = 200;
    std::vector<double> height;
    for (int i = 0; i <= steps; ++i) height.push_back(random.between(0, 0.4));
    for (int i = 0; i <= steps; ++i) outline.push_back({i * 0.1, height[i]});
    for (int i = steps; i >= 0; --i) outline.push_back({i * 0.1, height[i] + 0.01});
    REQUIRE(isSimple(outline));
    for (const double spacing : {0.3, 1.0, 3.0, 10.0}) {
      const std::vector<Vec2> border = fitBorder(outline, spacing, 100);
      CHECK(isSimple(border));
      CHECK(signedArea(border) > 0);
    }
  }
}

TEST_CASE("border: a hundred thousand points come down to what was asked for", "[triangulation]") {
  Random random(14);
  std::vector<Vec2> outline = discOutline(100, 100000);
  for (Vec2& p : outline) p = p * random.between(1, 1.00002);
  const std::vector<Vec2> border = fitBorder(outline, 5, 400);
  CHECK(border.size() <= 400);
  CHECK(isSimple(border));
}
