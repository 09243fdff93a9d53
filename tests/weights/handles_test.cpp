#include "weights/handles.h"

#include <limits>
#include <map>

#include "support/catch.h"
#include "weights/bodies.h"

using namespace marrow;

namespace {

Volume volumeOf(const Mesh& body, double vertices = 1500) {
  VolumeOptions options;
  options.target_vertices = vertices;
  auto volume = makeVolume(body, options);
  REQUIRE(volume);
  return std::move(*volume);
}

double shareOf(const Handles& handles, size_t i, uint32_t bone) {
  for (uint32_t k = handles.starts[i]; k < handles.starts[i + 1]; ++k) {
    if (handles.bones[k] == bone) return handles.shares[k];
  }
  return 0;
}

}  // namespace

TEST_CASE("handles: all along every bone there are some, near it, with shares of sum 1") {
  Random random(5);
  const Volume volume = volumeOf(box({-50, -40, -30}, {50, 40, 30}));
  for (int run = 0; run < 20; ++run) {
    const auto point = [&] {
      return Vec3{random.between(-50, 50), random.between(-40, 40), random.between(-30, 30)};
    };
    std::vector<Segment> bones = chain({point(), point(), point(), point()});
    bones.push_back({bones[1][0], point()});
    const Handles handles = makeHandles(volume, bones);
    REQUIRE(handles.starts.size() == handles.vertices.size() + 1);
    std::vector<bool> holds(bones.size(), false);
    for (size_t i = 0; i < handles.vertices.size(); ++i) {
      if (i > 0) CHECK(handles.vertices[i - 1] < handles.vertices[i]);
      double sum = 0, nearest = HUGE_VAL;
      for (uint32_t k = handles.starts[i]; k < handles.starts[i + 1]; ++k) {
        CHECK(handles.shares[k] > 0);
        if (k > handles.starts[i]) CHECK(handles.bones[k - 1] < handles.bones[k]);
        sum += handles.shares[k];
        holds[handles.bones[k]] = true;
      }
      for (const Segment& bone : bones) {
        nearest = std::min(nearest, distanceTo(bone, volume.vertices[handles.vertices[i]]));
      }
      CHECK(sum == Approx(1).epsilon(1e-12));
      CHECK(nearest < 0.867 * volume.spacing);
    }
    for (size_t bone = 0; bone < bones.size(); ++bone) {
      CHECK(holds[bone]);
      for (int step = 0; step <= 20; ++step) {
        const Vec3 p = lerp(bones[bone][0], bones[bone][1], step / 20.0);
        double nearest = HUGE_VAL;
        for (const uint32_t v : handles.vertices) {
          nearest = std::min(nearest, distance(volume.vertices[v], p));
        }
        CHECK(nearest < 0.867 * volume.spacing);
      }
    }
  }
}

TEST_CASE("handles: bones of a branch go over into each other at the joint") {
  const Volume volume = volumeOf(box({-50, -10, -10}, {50, 10, 10}));
  const double h = volume.spacing;
  for (const double joint : {0.0, 0.3 * h, 0.5 * h}) {
    const std::vector<Segment> bones = chain({{-40, 0, 0}, {joint, 0, 0}, {40, 0, 0}});
    const Handles handles = makeHandles(volume, bones);
    double before = 1;
    std::map<double, double> first;  // share of the first bone, by x
    for (size_t i = 0; i < handles.vertices.size(); ++i) {
      first[volume.vertices[handles.vertices[i]].x] = shareOf(handles, i, 0);
    }
    for (const auto& [x, share] : first) {
      CHECK(share <= before);
      before = share;
      if (x < joint - 1.001 * h) CHECK(share == 1);
      if (x > joint + 1.001 * h) CHECK(share == 0);
      if (std::fabs(x - joint) < 1e-6 * h) CHECK(share == Approx(0.5));
    }
  }
}

TEST_CASE("handles: a bone outside, or one that is not finite, holds nothing") {
  const Volume volume = volumeOf(box({0, 0, 0}, {50, 10, 10}));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<Segment> outside = {
      {Vec3{0, 50, 0}, Vec3{50, 50, 0}},      {Vec3{kNan, 5, 5}, Vec3{50, 5, 5}},
      {Vec3{0, 5, 5}, Vec3{kInfinity, 5, 5}}, {Vec3{1e300, 5, 5}, Vec3{-1e300, 800, 5}},
      {Vec3{25, 14, 5}, Vec3{30, 14, 5}},
  };
  CHECK(makeHandles(volume, outside).vertices.empty());
  CHECK(makeHandles(volume, {}).vertices.empty());
  // A bone that comes in from far away, and a point.
  const Handles partly = makeHandles(volume, {{Vec3{-1e6, 5, 5}, Vec3{1e6, 5, 5}}});
  CHECK(partly.vertices.size() >= 50 / volume.spacing);
  const Handles point = makeHandles(volume, {{Vec3{20, 5, 5}, Vec3{20, 5, 5}}});
  CHECK(!point.vertices.empty());
  CHECK(point.vertices.size() <= 8);
}

TEST_CASE("handles: a bone does not hold what is across a gap") {
  Mesh bodies = box({0, 0, 0}, {100, 10, 10});
  append(bodies, box({0, 12.5, 0}, {100, 22.5, 10}));
  const Volume volume = volumeOf(bodies, 1000);
  REQUIRE(volume.piece_count == 2);
  REQUIRE(volume.spacing > 3.5);
  const Handles handles =
      makeHandles(volume, {{Vec3{5, 9.5, 5}, Vec3{95, 9.5, 5}}, {Vec3{5, 13, 5}, Vec3{95, 13, 5}}});
  for (size_t i = 0; i < handles.vertices.size(); ++i) {
    CHECK(handles.starts[i + 1] - handles.starts[i] == 1);
  }
}
