#include "surface/inflate.h"

#include <algorithm>

#include "sketch/outline.h"
#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/meshes.h"
#include "support/outlines.h"
#include "support/strokes.h"

using namespace marrow;

namespace {

struct Inflated {
  Triangulation flat;
  Mesh mesh;
};

Inflated inflated(const std::vector<Vec2>& outline, double radius, InflateOptions options = {},
                  int target = 1000) {
  TriangulationOptions triangulation;
  triangulation.target_points = target;
  Result<Triangulation> flat = triangulate(outline, triangulation);
  REQUIRE(flat);
  Result<Mesh> mesh = inflate(*flat, radius, options);
  REQUIRE(mesh);
  return {std::move(*flat), std::move(*mesh)};
}

InflateOptions plain() {
  InflateOptions options;
  options.profile = InflateOptions::Profile::plain;
  return options;
}

double highest(const Mesh& mesh) {
  double height = 0;
  for (const Vec3 p : mesh.positions) height = std::max(height, p.z);
  return height;
}

bool hasTwins(const Mesh& mesh) {
  std::vector<Vec3> points = mesh.positions;
  std::sort(points.begin(), points.end(), [](Vec3 a, Vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
  });
  for (size_t i = 1; i < points.size(); ++i) {
    if (points[i].x == points[i - 1].x && points[i].y == points[i - 1].y &&
        points[i].z == points[i - 1].z) {
      return true;
    }
  }
  return false;
}

void checkSound(const std::string& name, const std::vector<Vec2>& outline, int target = 500) {
  INFO(name);
  const Inflated part = inflated(outline, 1, {}, target);
  CHECK(validate(part.mesh) == std::vector<std::string>{});
  CHECK_FALSE(hasTwins(part.mesh));
  const uint32_t border = part.flat.border_count;
  const size_t interior = part.flat.points.size() - border;
  REQUIRE(part.mesh.positions.size() == part.flat.points.size() + interior);
  bool mirrored = true;
  for (size_t v = 0; v < interior; ++v) {
    const Vec3 front = part.mesh.positions[border + v];
    const Vec3 back = part.mesh.positions[border + interior + v];
    mirrored =
        mirrored && front.x == back.x && front.y == back.y && front.z == -back.z && front.z > 0;
  }
  for (size_t v = 0; v < border; ++v) mirrored = mirrored && part.mesh.positions[v].z == 0;
  CHECK(mirrored);
  for (const Vec3 normal : vertexNormals(part.mesh)) {
    if (!(std::fabs(length(normal) - 1) < 1e-9)) FAIL("a normal has no unit length");
  }
}

/// An ellipse as a pen draws it, with samples about `step` apart, on whole pixels or not.
std::vector<Vec2> ellipseStroke(double a, double b, double turn, double step, bool on_pixels) {
  const int count = static_cast<int>(kPi * (a + b) / step);
  std::vector<Vec2> stroke = discOutline(1, count);
  const Vec2 along = {std::cos(turn), std::sin(turn)};
  for (Vec2& p : stroke) {
    p = along * (a * p.x) + perpendicular(along) * (b * p.y);
    if (on_pixels) p = {std::round(p.x), std::round(p.y)};
  }
  return stroke;
}

/// How far triangles at the border face along it, beyond half its turn there: degrees, the worst.
/// The walls of a dent do, and of a notch in the ring of points behind the border.
double worstLean(const Inflated& part) {
  const auto degrees = [](double sine) { return std::asin(std::min(1.0, sine)) * 180 / kPi; };
  const uint32_t border = part.flat.border_count;
  double worst = 0;
  for (const auto& corners : part.flat.triangles) {
    const Vec3 a = part.mesh.positions[corners[0]];
    const Vec3 normal =
        cross(part.mesh.positions[corners[1]] - a, part.mesh.positions[corners[2]] - a);
    for (const uint32_t v : corners) {
      if (v >= border) continue;
      const Vec2 at = part.flat.points[v];
      const Vec2 before = at - part.flat.points[v == 0 ? border - 1 : v - 1];
      const Vec2 behind = part.flat.points[v + 1 == border ? 0 : v + 1] - at;
      const Vec2 along = before / length(before) + behind / length(behind);
      const double lean = std::fabs(dot(Vec2{normal.x, normal.y}, along / length(along)));
      // The sum of two unit vectors is 2 cos of half the angle between them long.
      const double half_turn = std::acos(std::min(1.0, length(along) / 2)) * 180 / kPi;
      worst = std::max(worst, degrees(lean / length(normal)) - half_turn);
    }
  }
  return worst;
}

/// The solution of −Δu = 2 in a rectangle with u = 0 on its border, as a sine series in x.
double membrane(double x, double y, double width, double height) {
  double sum = x * (width - x);
  for (int n = 1; n < 200; n += 2) {
    const double k = n * kPi / width;
    // cosh(k (y − h/2)) ÷ cosh(k h/2), without large numbers.
    const double ratio =
        (std::exp(-k * y) + std::exp(k * (y - height))) / (1 + std::exp(-k * height));
    sum -= 8 * width * width / (kPi * kPi * kPi * n * n * n) * ratio * std::sin(k * x);
  }
  return sum;
}

}  // namespace

TEST_CASE("inflate: a strip of half width w becomes a tube of radius w", "[inflate]") {
  for (const double w : {1.0, 12.5}) {
    for (const double aspect : {8.0, 15.0, 25.0}) {
      for (const auto profile : {InflateOptions::Profile::round, InflateOptions::Profile::plain}) {
        INFO("half width " << w << ", aspect " << aspect);
        InflateOptions options;
        options.profile = profile;
        const Inflated part = inflated(rectangleOutline(2 * w * aspect, 2 * w), w, options);
        CHECK(highest(part.mesh) == Approx(w).epsilon(0.02));
        // Away from the ends every vertex is on the tube.
        double worst = 0;
        for (const Vec3 p : part.mesh.positions) {
          if (p.x < 4 * w || p.x > 2 * w * (aspect - 2)) continue;
          const double off = std::sqrt((p.y - w) * (p.y - w) + p.z * p.z);
          worst = std::max(worst, std::fabs(off / w - 1));
        }
        CHECK(worst < 0.02);
      }
    }
  }
}

TEST_CASE("inflate: a slanted strip has the cross-section of a tube all along", "[inflate]") {
  // Half width 1, aspect 10, at the slope 3 : 4.
  const Vec2 along = {0.8, 0.6};
  std::vector<Vec2> outline;
  for (const Vec2 p : rectangleOutline(20, 2)) {
    outline.push_back(along * p.x + perpendicular(along) * p.y);
  }
  const Inflated part = inflated(outline, 1);
  const MeshReport report = inspect(part.mesh);
  // A half circle's ends are eaten by the closed ends of the strip: compare its middle.
  for (double s = 4; s <= 16; s += 1) {
    double area = 0, top = 0;
    for (const auto& t : part.mesh.triangles) {
      // The cut of a triangle with the plane at s adds a piece of the section's area.
      double cut[2][2];
      int found = 0;
      for (int k = 0; k < 3; ++k) {
        const Vec3 a = part.mesh.positions[t[k]], b = part.mesh.positions[t[(k + 1) % 3]];
        const double a_s = dot(Vec2{a.x, a.y}, along) - s, b_s = dot(Vec2{b.x, b.y}, along) - s;
        if ((a_s < 0) == (b_s < 0)) continue;
        const Vec3 p = a + (b - a) * (a_s / (a_s - b_s));
        // From positive to negative first, so that pieces run the same way round.
        const int end = a_s < 0 ? 0 : 1;
        cut[end][0] = dot(Vec2{p.x, p.y}, perpendicular(along)) - 1;
        cut[end][1] = p.z;
        top = std::max(top, p.z);
        ++found;
      }
      if (found == 2) area += (cut[0][0] * cut[1][1] - cut[1][0] * cut[0][1]) / 2;
    }
    CHECK(std::fabs(area) == Approx(kPi).epsilon(0.03));
    CHECK(top == Approx(1).epsilon(0.02));
  }
  CHECK(report.volume > 0);
}

TEST_CASE("inflate: a disc becomes a ball, and plainly a flat one", "[inflate]") {
  const double radius = 80;
  const std::vector<Vec2> disc = discOutline(radius, 200, {300, -50});
  const Inflated ball = inflated(disc, radius);
  const MeshReport report = inspect(ball.mesh);
  CHECK(report.volume == Approx(4 * kPi / 3 * radius * radius * radius).epsilon(0.02));
  CHECK(report.area == Approx(4 * kPi * radius * radius).epsilon(0.02));
  CHECK(highest(ball.mesh) == Approx(radius).epsilon(1e-12));
  double worst = 0;
  const std::vector<Vec3> normals = vertexNormals(ball.mesh);
  double straightest = 1;
  for (size_t v = 0; v < normals.size(); ++v) {
    const Vec3 off = ball.mesh.positions[v] - Vec3{300, -50, 0};
    worst = std::max(worst, std::fabs(length(off) / radius - 1));
    straightest = std::min(straightest, dot(off / length(off), normals[v]));
  }
  CHECK(worst < 0.02);
  CHECK(straightest > 0.99);

  CHECK(highest(inflated(disc, radius, plain()).mesh) ==
        Approx(radius / std::sqrt(2.0)).epsilon(0.005));
}

TEST_CASE("inflate: a rectangle has the heights and the volume of the series solution",
          "[inflate]") {
  for (const double height : {1.0, 0.4}) {
    const Inflated part = inflated(rectangleOutline(1, height), 1, plain(), 2500);
    double worst = 0;
    const double top = std::sqrt(membrane(0.5, height / 2, 1, height));
    for (size_t v = part.flat.border_count; v < part.flat.points.size(); ++v) {
      const Vec3 p = part.mesh.positions[v];
      worst = std::max(worst, std::fabs(p.z - std::sqrt(membrane(p.x, p.y, 1, height))) / top);
    }
    CHECK(worst < 0.02);

    double volume = 0;
    const int n = 200;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double u = membrane((i + 0.5) / n, height * (j + 0.5) / n, 1, height);
        volume += 2 * std::sqrt(u) * height / (n * n);
      }
    }
    CHECK(inspect(part.mesh).volume == Approx(volume).epsilon(0.02));
  }
}

TEST_CASE("inflate: thickness multiplies every depth exactly", "[inflate]") {
  const std::vector<Vec2> outline = starOutline(100, 50, 5);
  const Mesh one = inflated(outline, 33).mesh;
  for (const double thickness : {0.05, 0.7, 4.0}) {
    InflateOptions options;
    options.thickness = thickness;
    const Mesh other = inflated(outline, 33, options).mesh;
    bool exact = other.triangles == one.triangles;
    for (size_t v = 0; v < one.positions.size(); ++v) {
      exact = exact && other.positions[v].z == one.positions[v].z * thickness;
    }
    CHECK(exact);
    CHECK(validate(other).empty());
  }
}

TEST_CASE("inflate: the rim is round: normals there lie in the plane of the drawing", "[inflate]") {
  const Inflated part = inflated(discOutline(50, 120), 50);
  const std::vector<Vec3> normals = vertexNormals(part.mesh);
  for (uint32_t v = 0; v < part.flat.border_count; ++v) {
    CHECK(std::fabs(normals[v].z) < 1e-9);
    CHECK(dot(normals[v], part.mesh.positions[v]) > 0.99 * 50);
  }
}

TEST_CASE("inflate: along the border of a smooth shape there are no dents", "[inflate]") {
  Random random(22);
  for (int i = 0; i < 100; ++i) {
    const double a = random.between(60, 300), b = a * random.between(0.5, 1);
    const double turn = random.between(0, kPi), step = random.between(2, 12);
    const bool on_pixels = i % 4 != 0;
    const Result<Outline> outline = makeOutline(ellipseStroke(a, b, turn, step, on_pixels));
    REQUIRE(outline);
    for (const int target : {300, 1000, 2500}) {
      INFO(a << " by " << b << " turned by " << turn << ", samples " << step << " apart, "
             << (on_pixels ? "on pixels, " : "") << target << " points");
      CHECK(worstLean(inflated(outline->dense, b, {}, target)) < 12);
    }
  }
}

TEST_CASE("inflate: random outlines become closed, manifold, outward meshes", "[inflate]") {
  Random random(21);
  for (int i = 0; i < 200; ++i) {
    checkSound("jagged " + std::to_string(i), jaggedOutline(random, 3 + random.below(90)), 300);
    checkSound("comb " + std::to_string(i), combOutline(random, 1 + random.below(12)), 300);
    const std::vector<Vec2> blob =
        blobOutline(random, 20 + random.below(400), 1 + random.below(30), random.between(0, 0.6));
    if (isSimple(blob)) checkSound("blob " + std::to_string(i), blob);
  }
}

TEST_CASE("inflate: real strokes become closed, manifold, outward meshes", "[inflate]") {
  forEachRealOutline([](const std::string& name, const std::vector<Vec2>& outline) {
    for (const int target : {300, 1000, 2500}) checkSound(name, outline, target);
  });
}

TEST_CASE("inflate: whatever a pen can draw becomes a closed, manifold, outward mesh",
          "[inflate]") {
  for (const strokes::NamedStroke& stroke : strokes::strokeFamilies(6, 400)) {
    const Result<Outline> outline = makeOutline(stroke.points);
    if (outline) checkSound(stroke.name, outline->dense, 300);
  }
}

TEST_CASE("inflate: slivers, specks and continents become sound meshes", "[inflate]") {
  for (const double size : {1e-4, 1.0, 1e6}) {
    for (const double aspect : {1.0, 100.0, 1e4}) {
      checkSound("strip", rectangleOutline(size * aspect, size));
      checkSound("needle", {{0, 0}, {size * aspect, 0}, {size * aspect / 3, size}});
    }
    checkSound("triangle", {{0, 0}, {size, 0}, {0, size}}, 16);
    checkSound("far away", discOutline(size, 40, {1e4 * size, -1e4 * size}));
  }
}

TEST_CASE("inflate: a larger drawing is the same one larger", "[inflate]") {
  const std::vector<Vec2> outline = starOutline(100, 50, 7);
  const Mesh one = inflated(outline, 50).mesh;
  std::vector<Vec2> larger = outline;
  for (Vec2& p : larger) p = p * 1024;
  const Mesh other = inflated(larger, 50 * 1024).mesh;
  bool same = one.triangles == other.triangles;
  for (size_t v = 0; same && v < one.positions.size(); ++v) {
    same = other.positions[v].z == one.positions[v].z * 1024;
  }
  CHECK(same);
}

TEST_CASE("inflate: triangles that are far from Delaunay still rise everywhere", "[inflate]") {
  // Needles from the corners of a long rectangle to two points near its ends.
  Triangulation flat;
  flat.points = {{0, 0}, {100, 0}, {100, 1}, {0, 1}, {1, 0.5}, {50, 0.999}, {99, 0.5}};
  flat.border_count = 4;
  flat.triangles = {{{0, 1, 5}}, {{1, 6, 5}}, {{1, 2, 6}}, {{2, 5, 6}},
                    {{2, 3, 5}}, {{3, 4, 5}}, {{3, 0, 4}}, {{0, 5, 4}}};
  const Result<Mesh> mesh = inflate(flat, 0.5);
  REQUIRE(mesh);
  CHECK(validate(*mesh).empty());
  for (int v = 4; v < 7; ++v) CHECK(mesh->positions[v].z > 0);
}

TEST_CASE("inflate: what cannot be inflated is refused with a sentence", "[inflate]") {
  const Triangulation good = *triangulate(discOutline(10, 30));
  for (const double radius : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    CHECK(inflate(good, radius).status() == Status::meshFailed);
    CHECK(inflate(good, radius, plain()));
  }
  InflateOptions options;
  for (const double thickness : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.thickness = thickness;
    CHECK(inflate(good, 10, options).status() == Status::meshFailed);
  }
  CHECK(inflate(Triangulation{}, 10).status() == Status::meshFailed);

  // Two triangles without a point inside: front and back would be the same.
  Triangulation flat;
  flat.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  flat.border_count = 4;
  flat.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  CHECK(inflate(flat, 1).status() == Status::meshFailed);
  CHECK_FALSE(inflate(flat, 1).message().empty());
}
