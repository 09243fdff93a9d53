// What the weight brush does to weights. (tests/document: what becomes of the strokes themselves.)
#include <limits>

#include "support/catch.h"
#include "weights/bodies.h"
#include "weights/weight_strokes.h"

using namespace marrow;

namespace {

using Kind = WeightStroke::Kind;
using Weights = std::vector<JointWeights>;

Rig rigOf(const std::vector<std::string>& ids) {
  Rig rig;
  for (const std::string& id : ids) {
    rig.joints.emplace_back();
    rig.joints.back().id = id;
  }
  return rig;
}

double weightOf(const JointWeights& weights, uint32_t joint) {
  for (const JointWeight& one : weights) {
    if (one.joint == joint) return one.weight;
  }
  return 0;
}

std::string faultOf(const JointWeights& weights, size_t joints) {
  double sum = 0;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i].weight > 0 && weights[i].weight <= 1 + 1e-15)) return "bounds";
    if (weights[i].joint >= joints) return "no such joint";
    if (i > 0 && weights[i].joint <= weights[i - 1].joint) return "order";
    sum += weights[i].weight;
  }
  return std::abs(sum - 1) < 1e-12 ? "" : "sum";
}

bool areSame(const Weights& a, const Weights& b) {
  if (a.size() != b.size()) return false;
  for (size_t v = 0; v < a.size(); ++v) {
    if (a[v].size() != b[v].size()) return false;
    for (size_t i = 0; i < a[v].size(); ++i) {
      if (a[v][i].joint != b[v][i].joint || a[v][i].weight != b[v][i].weight) return false;
    }
  }
  return true;
}

/// A limb along x from 0 to 240, 15 thick, that three joints hold one after the other; between
/// them they share.
struct Limb {
  Mesh mesh = tube(straight({0, 0, 0}, {240, 0, 0}, 96), 15, 24);
  Rig rig = rigOf({"a", "b", "c"});
  Weights weights;

  Limb() {
    for (const Vec3 p : mesh.positions) {
      const double at = std::min(std::max((p.x - 40) / 80, 0.0), 2.0);
      JointWeights own;
      for (uint32_t joint = 0; joint < 3; ++joint) {
        const double weight = 1 - std::abs(at - joint);
        if (weight > 0) own.push_back({joint, weight});
      }
      weights.push_back(own);
    }
  }

  Weights painted(const std::vector<PlacedWeightStroke>& strokes) const {
    Weights result = weights;
    const WeightPainter painter(mesh, rig);
    for (const auto& stroke : strokes) painter.paint(stroke, result);
    for (const JointWeights& own : result) {
      if (const std::string fault = faultOf(own, 3); !fault.empty()) FAIL(fault);
    }
    return result;
  }
};

PlacedWeightStroke stroke(Kind kind, const std::string& joint, double strength = 1,
                          double radius = 30) {
  return {kind, strength, {{joint, radius, {{70, 15, 0}, {110, 15, 0}, {125, 14, 5}}}}};
}

PlacedWeightStroke randomStroke(Random& random) {
  const char* joints[] = {"a", "b", "c", "gone"};
  PlacedWeightStroke one{static_cast<Kind>(random.below(3)), random.unit(), {}};
  for (int trails = 1 + random.below(2); trails > 0; --trails) {
    PlacedWeightStroke::Trail trail{joints[random.below(4)], random.between(2, 60), {}};
    Vec3 at{random.between(-20, 260), random.between(-25, 25), random.between(-25, 25)};
    for (int count = 1 + random.below(12); count > 0; --count) {
      trail.points.push_back(at);
      at = at + Vec3{random.between(-20, 20), random.between(-9, 9), random.between(-9, 9)};
    }
    one.trails.push_back(trail);
  }
  return one;
}

}  // namespace

TEST_CASE("painted weights: whatever was painted, they are positive and sum to one",
          "[painted_weights]") {
  const Limb limb;
  Random random(1);
  for (int run = 0; run < 60; ++run) {
    std::vector<PlacedWeightStroke> strokes;
    for (int count = 1 + random.below(6); count > 0; --count) {
      strokes.push_back(randomStroke(random));
    }
    limb.painted(strokes);
  }
}

TEST_CASE("painted weights: more is added and taken the nearer and the stronger",
          "[painted_weights]") {
  const Limb limb;
  for (const Kind kind : {Kind::add, Kind::take}) {
    Weights last = limb.weights;
    for (const double strength : {0.1, 0.3, 0.6, 1.0}) {
      const Weights now = limb.painted({stroke(kind, "b", strength)});
      size_t changed = 0;
      for (size_t v = 0; v < now.size(); ++v) {
        const double more = weightOf(now[v], 1) - weightOf(last[v], 1);
        if (kind == Kind::add ? more < 0 : more > 0) FAIL("the other way, by " << more);
        changed += more != 0;
        // The others keep their proportion.
        const double a = weightOf(limb.weights[v], 0), c = weightOf(limb.weights[v], 2);
        if (std::abs(weightOf(now[v], 0) * c - weightOf(now[v], 2) * a) > 1e-9) FAIL("others");
      }
      CHECK(changed > 100);
      last = now;
    }
    // On the middle of the stroke it is all, or nothing.
    for (size_t v = 0; v < last.size(); ++v) {
      const Vec3 p = limb.mesh.positions[v];
      if (p.x < 75 || p.x > 105 || p.y < 14.99) continue;
      CHECK(weightOf(last[v], 1) == (kind == Kind::add ? 1 : 0));
    }
  }
}

TEST_CASE("painted weights: nothing is taken where nothing else holds, and little where little",
          "[painted_weights]") {
  Limb limb;
  limb.weights.assign(limb.mesh.positions.size(), {{1, 1}});
  CHECK(areSame(limb.painted({stroke(Kind::take, "b")}), limb.weights));
  limb.weights.assign(limb.mesh.positions.size(), {{0, 1e-5}, {1, 1 - 1e-5}});
  for (const JointWeights& own : limb.painted({stroke(Kind::take, "b")})) {
    CHECK(weightOf(own, 0) < 1e-3);
  }
}

TEST_CASE("painted weights: what was added can be taken again", "[painted_weights]") {
  const Limb limb;
  const PlacedWeightStroke taken = stroke(Kind::take, "c");
  const Weights after = limb.painted({stroke(Kind::add, "c", 0.9), taken, taken, taken, taken});
  for (size_t v = 0; v < after.size(); ++v) {
    const Vec3 p = limb.mesh.positions[v];
    if (p.x > 70 && p.x < 110 && p.y > 14.9) CHECK(weightOf(after[v], 2) < 0.01);
  }
}

TEST_CASE("painted weights: what was painted last counts most", "[painted_weights]") {
  const Limb limb;
  const Weights a = limb.painted({stroke(Kind::add, "b", 0.9), stroke(Kind::add, "a", 0.9)});
  const Weights b = limb.painted({stroke(Kind::add, "a", 0.9), stroke(Kind::add, "b", 0.9)});
  size_t differ = 0;
  for (size_t v = 0; v < a.size(); ++v) {
    CHECK(weightOf(a[v], 0) >= weightOf(b[v], 0));
    CHECK(weightOf(a[v], 1) <= weightOf(b[v], 1));
    differ += weightOf(a[v], 0) != weightOf(b[v], 0);
  }
  CHECK(differ > 100);
}

TEST_CASE("painted weights: smoothing evens out, and a body of one joint stays",
          "[painted_weights]") {
  Limb limb;
  for (size_t v = 0; v < limb.weights.size(); ++v) {
    limb.weights[v] = {{limb.mesh.positions[v].x < 90 ? 0u : 2u, 1}};
  }
  const auto steepest = [&](const Weights& weights) {  // between neighbours near the stroke
    double most = 0;
    for (const auto& triangle : limb.mesh.triangles) {
      for (const uint32_t v : triangle) {
        const Vec3 p = limb.mesh.positions[v];
        if (p.x < 75 || p.x > 105 || p.y < 13) continue;
        most =
            std::max(most, std::abs(weightOf(weights[v], 0) - weightOf(weights[triangle[0]], 0)));
      }
    }
    return most;
  };
  double last = steepest(limb.weights);
  CHECK(last == 1);
  for (const double strength : {0.2, 0.5, 1.0}) {
    const double now = steepest(limb.painted({stroke(Kind::smooth, "", strength)}));
    CHECK(now < last);
    last = now;
  }
  CHECK(last < 0.25);
  limb.weights.assign(limb.mesh.positions.size(), {{1, 1}});
  CHECK(areSame(limb.painted({stroke(Kind::smooth, "")}), limb.weights));
}

TEST_CASE("painted weights: smoothing does as much on a finer mesh", "[painted_weights]") {
  std::array<double, 2> away{};
  for (const int finer : {1, 2}) {
    const Mesh mesh = tube(straight({0, 0, 0}, {240, 0, 0}, 60 * finer), 15, 16 * finer);
    Weights weights;
    for (const Vec3 p : mesh.positions) weights.push_back({{p.x < 91 ? 0u : 2u, 1}});
    const Rig rig = rigOf({"a", "b", "c"});
    WeightPainter(mesh, rig).paint(stroke(Kind::smooth, ""), weights);
    // How far from the border the weight went to a tenth, on top.
    for (size_t v = 0; v < weights.size(); ++v) {
      const Vec3 p = mesh.positions[v];
      if (p.y < 14.9 || weightOf(weights[v], 2) < 0.1) continue;
      away[static_cast<size_t>(finer - 1)] =
          std::max(away[static_cast<size_t>(finer - 1)], 91 - p.x);
    }
  }
  CAPTURE(away[0], away[1]);
  CHECK(away[0] > 5);
  CHECK(std::abs(away[0] - away[1]) <= 4);
}

TEST_CASE("painted weights: a stroke and its mirror image are painted alike", "[painted_weights]") {
  // The limb's other half is its mirror image in x; joints a and c are opposite.
  Limb limb;
  std::vector<uint32_t> image;
  for (const Vec3 p : limb.mesh.positions) {
    uint32_t nearest = 0;
    for (uint32_t v = 0; v < limb.mesh.positions.size(); ++v) {
      const auto off = [&](uint32_t i) {
        return distance(limb.mesh.positions[i], {240 - p.x, p.y, p.z});
      };
      if (off(v) < off(nearest)) nearest = v;
    }
    image.push_back(nearest);
  }
  // So that it is one to the last edge, too.
  std::vector<std::array<uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : limb.mesh.triangles) {
    const auto isLeft = [&](uint32_t v) { return limb.mesh.positions[v].x < 120 + 1e-9; };
    if (!isLeft(a) || !isLeft(b) || !isLeft(c)) continue;
    triangles.push_back({a, b, c});
    triangles.push_back({image[a], image[c], image[b]});
  }
  REQUIRE(triangles.size() == limb.mesh.triangles.size());
  limb.mesh.triangles = triangles;
  Random random(3);
  const char* joints[] = {"a", "b", "c"};
  for (int run = 0; run < 20; ++run) {
    std::vector<PlacedWeightStroke> strokes;
    for (int count = 3; count > 0; --count) {
      PlacedWeightStroke one = randomStroke(random);
      const int joint = random.below(3);
      one.trails.resize(1);
      one.trails[0].joint = joints[joint];
      one.trails.push_back(one.trails[0]);
      one.trails[1].joint = joints[2 - joint];
      for (Vec3& p : one.trails[1].points) p.x = 240 - p.x;
      strokes.push_back(one);
    }
    const Weights after = limb.painted(strokes);
    for (size_t v = 0; v < after.size(); ++v) {
      for (uint32_t joint = 0; joint < 3; ++joint) {
        const double off = weightOf(after[v], joint) - weightOf(after[image[v]], 2 - joint);
        if (std::abs(off) > 1e-9) FAIL(run << ": " << off);
      }
    }
  }
}

TEST_CASE("painted weights: the brush does not reach another limb through the air",
          "[painted_weights]") {
  Mesh both = tube(straight({0, 0, 0}, {200, 0, 0}, 80), 15, 24);
  const size_t first = both.positions.size();
  append(both, tube(straight({0, 40, 0}, {200, 40, 0}, 80), 15, 24));
  Weights weights(both.positions.size(), {{0, 0.5}, {1, 0.5}});
  const Rig rig = rigOf({"a", "b"});
  const PlacedWeightStroke one{Kind::add, 1, {{"a", 30, {{60, 15, 0}, {140, 15, 0}}}}};
  const auto reached = WeightPainter(both, rig).paint(one, weights);
  CHECK(reached.size() > 200);
  for (const uint32_t v : reached) CHECK(v < first);
}

TEST_CASE("painted weights: what does nothing changes no bit", "[painted_weights]") {
  const Limb limb;
  const double none = std::nan(""), huge = std::numeric_limits<double>::infinity();
  std::vector<PlacedWeightStroke> idle = {
      stroke(Kind::add, "gone"),       stroke(Kind::take, ""),       stroke(Kind::add, "b", 0),
      stroke(Kind::add, "b", -1),      stroke(Kind::add, "b", none), stroke(Kind::add, "b", 1, 0),
      stroke(Kind::add, "b", 1, none), {Kind::smooth, 1, {}}};
  idle.push_back(stroke(Kind::smooth, "b"));
  idle.back().trails[0].points.clear();
  idle.push_back(stroke(Kind::add, "b"));
  for (Vec3& p : idle.back().trails[0].points) p.y += 200;
  for (const auto& one : idle) CHECK(areSame(limb.painted({one}), limb.weights));
  // A stroke changes what it reaches alone.
  Weights weights = limb.weights;
  const auto reached = WeightPainter(limb.mesh, limb.rig).paint(stroke(Kind::add, "b"), weights);
  for (const uint32_t v : reached) weights[v] = limb.weights[v];
  CHECK(areSame(weights, limb.weights));
  // Hostile ones may do anything but break the rules.
  limb.painted({stroke(Kind::add, "b", huge), stroke(Kind::take, "b", 1e300, 1e50),
                stroke(Kind::smooth, "b", 1, 1e100), stroke(Kind::smooth, "", 1, 1e-9)});
  PlacedWeightStroke far = stroke(Kind::add, "b", 1, 1e-50);
  far.trails[0].points = {{-1e50, 1e50, 0}, {1e50, -1e50, 0}, {1e50, 1e50, 1e50}};
  limb.painted({far});
  const Mesh empty;
  Weights nothing;
  CHECK(WeightPainter(empty, limb.rig).paint(stroke(Kind::add, "b"), nothing).empty());
}
