#include "document/depth.h"

#include <cmath>

#include "support/catch.h"
#include "support/creatures.h"

using namespace marrow;

namespace {

std::vector<Vec2> disc(double radius, Vec2 center) {
  std::vector<Vec2> stroke = unitCircle(40);
  for (Vec2& p : stroke) p = center + p * radius;
  return stroke;
}

struct Model {
  Document document;
  Evaluation evaluation;

  void add(double radius, Vec2 center, double depth, std::optional<Plane> mirror = {}) {
    Frame frame;
    frame.origin.z = depth;
    make(AddPart{disc(radius, center), frame, mirror});
  }
  void make(const Command& command) {
    document = *apply(document, command);
    evaluation.update(document);
  }
  double depth(size_t part) const { return document.parts[part]->frame.origin.z; }
  double half(size_t part) const {
    double most = 0;
    for (const Vec3 p : evaluation.parts()[part].part->mesh.positions) most = std::max(most, p.z);
    return most;
  }
  bool layer(const std::string& id, bool nearer, Vec3 viewer = {0, 0, 1}) {
    const auto move = layerMove(evaluation, {id}, viewer, nearer);
    if (!move) return false;
    TransformParts transform{{id}, {}, "Move"};
    transform.map.move = *move;
    make(transform);
    return true;
  }
};

}  // namespace

TEST_CASE("depth: a part goes past the parts it covers one by one, and back behind them") {
  Model model;
  model.add(100, {0, 0}, 0);
  model.add(60, {20, 0}, 150);
  model.add(40, {0, 10}, 0);
  model.add(50, {400, 0}, 70);  // covers nothing
  const double body = model.half(0), second = model.half(1);
  REQUIRE(model.layer("part-3", true));
  CHECK(model.depth(2) == Approx(body));
  REQUIRE(model.layer("part-3", true));
  CHECK(model.depth(2) == Approx(150 + second));
  CHECK_FALSE(model.layer("part-3", true));
  REQUIRE(model.layer("part-3", false));
  CHECK(model.depth(2) == Approx(150 - second));
  REQUIRE(model.layer("part-3", false));
  CHECK(model.depth(2) == Approx(-body));
  CHECK_FALSE(model.layer("part-3", false));
  CHECK_FALSE(model.layer("part-4", true));
}

TEST_CASE("depth: nearer is nearer to the viewer, from either side") {
  Model model;
  model.add(100, {0, 0}, 0);
  model.add(40, {0, 0}, 0);
  REQUIRE(model.layer("part-2", true, {0, 0, -1}));
  CHECK(model.depth(1) == Approx(-model.half(0)));
}

TEST_CASE("depth: hidden parts and the twin of the part are no layers") {
  Model model;
  model.add(100, {0, 0}, 0);
  model.add(40, {0, 0}, 10, Plane{{0, 0, 1}, 50});
  model.make(SetVisible{{"part-1"}, false});
  CHECK_FALSE(model.layer("part-2", true));
  CHECK_FALSE(model.layer("part-2", false));
}

TEST_CASE("depth: a slider's scale stays while the part moves along its normal") {
  Random random(11);
  for (int run = 0; run < 20; ++run) {
    Model model;
    model.add(100, {0, 0}, 0);
    model.add(30, {random.between(-80, 80), 0}, 0);
    model.add(50, {random.between(-300, 300), 40}, random.between(-100, 100));
    const Ids ids{"part-2"};
    const Vec3 viewer{0.2, 0.1, 0.9};
    const auto before = depthScale(model.evaluation, ids, viewer);
    REQUIRE(before);
    CHECK(before->level == Approx(0).margin(1e-9));
    const double way = random.between(-50, 50);
    TransformParts move{ids, {}, "Move"};
    move.map.move = before->direction * way;
    model.make(move);
    const auto after = depthScale(model.evaluation, ids, viewer);
    REQUIRE(after);
    CHECK(after->low == before->low);
    CHECK(after->high == before->high);
    CHECK(after->level == before->level);
    CHECK(after->now - before->now == Approx(way));
    CHECK(after->low < after->now);
    CHECK(after->now < after->high);
  }
}

TEST_CASE("depth: there is a scale for the only part, and none for a part that is gone") {
  Model model;
  model.add(100, {0, 0}, 0);
  const auto scale = depthScale(model.evaluation, {"part-1"}, {0, 0, 1});
  REQUIRE(scale);
  CHECK(scale->low == -scale->high);
  CHECK(scale->high > 100);
  CHECK_FALSE(depthScale(model.evaluation, {"part-9"}, {0, 0, 1}));
  CHECK_FALSE(depthScale(model.evaluation, {}, {0, 0, 1}));
  CHECK_FALSE(layerMove(model.evaluation, {"part-1"}, {0, 0, 1}, true));
}
