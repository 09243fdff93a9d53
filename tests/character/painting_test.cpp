// Painting on a character in whatever steps gives what painting from the first stroke would give.
#include "character/painting.h"

#include "document/command.h"
#include "support/catch.h"
#include "support/creatures.h"

namespace marrow {
namespace {

bool areSame(const std::vector<VertexSkin>& one, const std::vector<VertexSkin>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const VertexSkin& a, const VertexSkin& b) {
                      return a.joints == b.joints && a.weights == b.weights;
                    });
}

struct Subject {
  Evaluation evaluation{previewOptions()};
  Character character;

  Subject() {
    Document document;
    for (const bool leg : {false, true}) {
      AddPart part{unitCircle(40)};
      for (Vec2& p : part.stroke) p = leg ? Vec2{20 * p.x, 80 * p.y} : Vec2{150 * p.x, 60 * p.y};
      if (leg) part.frame.origin = {60, -90, 0};
      document = *apply(document, part);
    }
    evaluation.update(document);
    CharacterOptions options;
    options.weighting = quickWeightOptions();
    character = makeCharacter(evaluation, options);
  }

  PlacedWeightStroke stroke(Random& random, double radius) const {
    const auto& joints = evaluation.rig().joints;
    const auto& positions = character.merged.mesh.positions;
    const auto any = [&](size_t count) {
      return static_cast<size_t>(random.below(static_cast<int>(count)));
    };
    PlacedWeightStroke one{static_cast<WeightStroke::Kind>(random.below(3)), random.unit(), {}};
    one.trails.push_back({joints[any(joints.size())].id, radius, {}});
    for (int count = 1 + random.below(3); count > 0; --count) {
      one.trails[0].points.push_back(positions[any(positions.size())]);
    }
    return one;
  }
};

}  // namespace

TEST_CASE("painting: strokes that come, change and go leave what painting anew would",
          "[painting]") {
  const Subject subject;
  Random random(1);
  Painting painting(subject.character, subject.evaluation.rig());
  std::vector<PlacedWeightStroke> strokes;
  for (int run = 0; run < 120; ++run) {
    const auto any = [&] {
      return static_cast<std::ptrdiff_t>(random.below(static_cast<int>(strokes.size())));
    };
    const double radius = run % 7 == 0 ? 1e6 : random.between(5, 60);  // some reach everything
    const PlacedWeightStroke fresh = subject.stroke(random, radius);
    const int what = random.below(8);
    if (strokes.empty() || what < 4) {
      strokes.push_back(fresh);
    } else if (what < 6) {
      strokes.back() = fresh;
    } else if (what < 7) {
      strokes.resize(static_cast<size_t>(any()));
    } else {
      strokes.erase(strokes.begin() + any());
    }
    REQUIRE(painting.set(strokes));
    Painting anew(subject.character, subject.evaluation.rig());
    REQUIRE(anew.set(strokes));
    if (!areSame(painting.skin(), anew.skin())) FAIL("after step " << run);
  }
}

TEST_CASE("painting: what did not change is not painted again", "[painting]") {
  const Subject subject;
  Random random(2);
  std::vector<PlacedWeightStroke> strokes;
  for (int i = 0; i < 40; ++i) strokes.push_back(subject.stroke(random, i < 20 ? 1e6 : 30));
  Painting painting(subject.character, subject.evaluation.rig());
  size_t asked = 0;  // between two strokes
  const auto painted = [&] {
    asked = 0;
    REQUIRE(painting.set(strokes, [&](double) { return ++asked > 0; }));
    return asked;
  };
  CHECK(painted() == 39);
  for (int step = 0; step < 9; ++step) {  // under the brush
    strokes.back().trails[0].points.push_back({10. * step, 60, 0});
    CHECK(painted() == 0);
  }
  strokes.push_back(subject.stroke(random, 1e6));
  CHECK(painted() == 0);
  for (int step = 0; step < 5; ++step) {  // undone, one by one
    strokes.pop_back();
    CHECK(painted() == 0);
  }
  strokes.erase(strokes.end() - 4);
  CHECK(painted() == 2);
  strokes.erase(strokes.begin());
  CHECK(painted() == strokes.size() - 1);
}

TEST_CASE("painting: told to stop it stops between two strokes, and goes on there", "[painting]") {
  const Subject subject;
  Random random(3);
  std::vector<PlacedWeightStroke> strokes;
  for (int i = 0; i < 12; ++i) strokes.push_back(subject.stroke(random, 40));
  Painting painting(subject.character, subject.evaluation.rig());
  size_t asked = 0;
  CHECK_FALSE(painting.set(strokes, [&](double) { return ++asked < 5; }));
  CHECK(asked == 5);
  Painting anew(subject.character, subject.evaluation.rig());
  REQUIRE(anew.set({strokes.begin(), strokes.begin() + 5}));
  CHECK(areSame(painting.skin(), anew.skin()));
  double last = 0;
  REQUIRE(painting.set(strokes, [&](double done) {
    CHECK(done > last);
    CHECK(done < 1);
    last = done;
    return true;
  }));
  REQUIRE(anew.set(strokes));
  CHECK(areSame(painting.skin(), anew.skin()));
}

}  // namespace marrow
