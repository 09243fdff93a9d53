#include "skeleton/slab_hierarchy.h"

#include <set>

#include "support/catch.h"
#include "support/random.h"

namespace marrow {
namespace {

Vec2 somewhere(Random& random) { return {random.between(-1, 1), random.between(-1, 1)}; }

bool meet(const Way& v, const Way& w) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(v.a, v.b, w.a) * side(v.a, v.b, w.b) <= 0 &&
         side(w.a, w.b, v.a) * side(w.a, w.b, v.b) <= 0;
}

}  // namespace

TEST_CASE("slab hierarchy: a visit comes to everything that lies in the way", "[skeleton]") {
  Random random(1);
  for (const size_t count : {1, 7, 8, 9, 64, 65, 513, 2000}) {
    SlabHierarchy hierarchy;
    hierarchy.reset(count);
    std::vector<Way> things;
    for (size_t i = 0; i < count; ++i) {
      const Vec2 a = somewhere(random);
      things.emplace_back(a, a + somewhere(random) * 0.1, 0);
      hierarchy.orient(i, things[i].b - things[i].a);
    }
    for (size_t i = 0; i < count; ++i) hierarchy.include(i, things[i], 1e-9);
    // Some become longer later on.
    for (size_t i = 0; i < count; i += 5) {
      things[i] = Way{things[i].a, somewhere(random), 0};
      hierarchy.include(i, things[i], 1e-9);
    }
    size_t met = 0, visited = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec2 a = somewhere(random);
      const Way way{a, a + somewhere(random) * 0.2, 1e-9};
      std::set<size_t> runs;
      hierarchy.visit(way, [&](size_t first) {
        CHECK(first % SlabHierarchy::kRun == 0);
        CHECK(first < count);
        CHECK(runs.insert(first).second);
      });
      const Sweep sweep{way, way, 0};
      size_t swept = 0;
      hierarchy.visit(sweep, [&](size_t) { ++swept; });
      CHECK(swept == runs.size());
      for (size_t i = 0; i < count; ++i) {
        if (!meet(way, things[i])) continue;
        CHECK(runs.count(i - i % SlabHierarchy::kRun) == 1);
        ++met;
      }
      visited += runs.size();
    }
    if (count > 8) CHECK(met > 0);
    CHECK(visited <= 200 * ((count + 7) / 8));
  }
}

TEST_CASE("slab hierarchy: of thin, slanting things, few that are not met are looked at",
          "[skeleton]") {
  // Needles side by side, at 45 degrees: the box around one of them has most of the others in it.
  constexpr size_t kCount = 800;
  SlabHierarchy hierarchy;
  hierarchy.reset(kCount);
  const auto needle = [](size_t i) {
    const double x = static_cast<double>(i) / kCount;
    return Way{{x, -x}, {x + 1, 1 - x}, 0};
  };
  for (size_t i = 0; i < kCount; ++i) hierarchy.orient(i, needle(i).b - needle(i).a);
  for (size_t i = 0; i < kCount; ++i) hierarchy.include(i, needle(i), 1e-9);
  for (size_t i = 0; i < kCount; i += 37) {
    size_t runs = 0;
    hierarchy.visit(needle(i), [&](size_t) { ++runs; });
    CHECK(runs >= 1);
    CHECK(runs <= 3);
  }
}

TEST_CASE("slab hierarchy: nothing is found where nothing is", "[skeleton]") {
  SlabHierarchy hierarchy;
  const Way way{{0, 0}, {1, 1}, 0};
  hierarchy.visit(way, [](size_t) { FAIL(); });
  hierarchy.reset(0);
  hierarchy.visit(way, [](size_t) { FAIL(); });
  hierarchy.reset(100);
  hierarchy.visit(way, [](size_t) { FAIL(); });
}

}  // namespace marrow
