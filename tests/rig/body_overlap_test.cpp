#include "rig/body_overlap.h"

#include "rig/rigs.h"
#include "support/catch.h"
#include "support/creatures.h"

namespace marrow {
namespace {

PartSource drawn(const std::string& id, std::vector<Vec2> stroke, Vec3 origin = {}) {
  PartSource part;
  part.id = part.name = id;
  part.stroke = std::move(stroke);
  part.frame.origin = origin;
  return part;
}

Document documentOf(std::vector<PartSource> parts) {
  Document document;
  for (PartSource& part : parts) {
    document.parts.push_back(std::make_shared<const PartSource>(std::move(part)));
  }
  return document;
}

// An arm that leaves a body near its rim, in a plane in front of the body's: the ball at the end of
// the body's bones is smaller than the body there.
const std::vector<Vec2> kBody = ellipse({0, 0}, 70, 110);
const std::vector<Vec2> kArm{{45, 70}, {120, 40}, {190, 0}, {175, -25}, {110, 8}, {35, 32}};

double share(const Assembly& creature, size_t one, size_t other) {
  return bodyOverlap(PartBody(creature.parts[one]), PartBody(creature.parts[other])).share;
}

}  // namespace

TEST_CASE("body overlap: an arm set on a body hangs on it though no joint and no ball meets it",
          "[body_overlap]") {
  Workshop workshop;
  const Assembly creature(documentOf({drawn("body", kBody), drawn("arm", kArm, {0, 0, 44})}),
                          workshop);
  CHECK(share(creature, 0, 1) > 0);
  const auto connections = creature.connections();
  REQUIRE(connections.size() == 1);
  CHECK(connections[0].child == 1);
  CHECK(connections[0].test == AttachTest::overlap);
}

TEST_CASE("body overlap: the same whichever part is asked about, and wherever both lie",
          "[body_overlap]") {
  Workshop workshop;
  Random random(5);
  for (int run = 0; run < 40; ++run) {
    PartSource body = drawn("body", kBody), arm = drawn("arm", kArm, {0, 0, 40 + 1.0 * run});
    const Assembly there(documentOf({body, arm}), workshop);
    const double found = share(there, 0, 1);
    CHECK(share(there, 1, 0) == Approx(found).margin(1e-9));
    const Affine map = randomSimilarity(random);
    for (PartSource* part : {&body, &arm}) {
      part->frame = {map(part->frame.origin), map.direction(part->frame.x),
                     map.direction(part->frame.y)};
    }
    const Assembly moved(documentOf({body, arm}), workshop);
    CHECK(share(moved, 0, 1) == Approx(found).margin(0.03));
  }
}

TEST_CASE("body overlap: bodies that are apart do not meet, however near their boxes are",
          "[body_overlap]") {
  Workshop workshop;
  // In front of the rim: within the body's box, outside the body.
  const Assembly rim(documentOf({drawn("body", ellipse({0, 0}, 100, 100)),
                                 drawn("dot", ellipse({82, 82}, 10, 10))}),
                     workshop);
  CHECK(share(rim, 0, 1) == 0);
  CHECK(rim.connections().empty());
  const Assembly front(documentOf({drawn("body", ellipse({0, 0}, 100, 100)),
                                   drawn("dot", ellipse({60, 0}, 10, 10), {0, 0, 100})}),
                       workshop);
  CHECK(share(front, 0, 1) == 0);
}

TEST_CASE("body overlap: a small part inside a large one, and a large one around a small one",
          "[body_overlap]") {
  Workshop workshop;
  const Assembly creature(documentOf({drawn("small", ellipse({20, 30}, 12, 8)),
                                      drawn("large", ellipse({0, 0}, 150, 140))}),
                          workshop);
  CHECK(share(creature, 0, 1) == Approx(1).margin(0.05));
  CHECK(share(creature, 1, 0) == Approx(1).margin(0.05));
}

TEST_CASE("connect: of twins on the verge of a body either both hang on it or none",
          "[body_overlap]") {
  Workshop workshop;
  int held = 0, apart = 0;
  for (int run = 0; run < 120; ++run) {
    PartSource arm = drawn("arm", kArm, {0.7 * run - 20, 0.31 * run, 0});
    arm.mirror = Plane{{1, 0, 0}, 0};
    const Assembly creature(documentOf({drawn("body", kBody), arm}), workshop);
    size_t on_body = 0;
    for (const Connection& connection : creature.connections()) on_body += connection.parent == 0;
    CHECK(on_body != 1);
    held += on_body == 2;
    apart += on_body == 0;
  }
  CHECK(held > 20);
  CHECK(apart > 20);
}

}  // namespace marrow
