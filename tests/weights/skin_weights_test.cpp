#include "weights/skin_weights.h"

#include <algorithm>
#include <limits>

#include "support/catch.h"
#include "support/samples.h"
#include "weights/bodies.h"

using namespace marrow;

namespace {

double weightOf(const Influences& influences, uint32_t bone) {
  double weight = 0;
  for (const Influence& one : influences) weight += one.bone == bone ? one.weight : 0;
  return weight;
}

/// What is wrong with the influences of a vertex; nothing: "".
std::string faultOf(const Influences& influences, size_t bones) {
  double sum = 0;
  for (size_t i = 0; i < influences.size(); ++i) {
    const auto [bone, weight] = influences[i];
    if (!(weight >= 0 && weight <= 1)) return "out of bounds";
    if (bone >= bones) return "no such bone";
    if (weight == 0 && bone != 0) return "an unused one that names a bone";
    if (i > 0 && weight > influences[i - 1].weight) return "order";
    if (i > 0 && weight > 0 && weight == influences[i - 1].weight &&
        bone < influences[i - 1].bone) {
      return "order of equal ones";
    }
    for (size_t k = 0; k < i; ++k) {
      if (weight > 0 && influences[k].bone == bone) return "a bone twice";
    }
    sum += weight;
  }
  return std::fabs(sum - 1) <= 1e-12 ? "" : "sum";
}

std::string faultOf(const std::vector<Influences>& all, size_t bones) {
  for (const Influences& influences : all) {
    std::string fault = faultOf(influences, bones);
    if (fault.empty()) {
      const Influences few = limited(influences, 4);
      fault = faultOf(few, bones);
      if (few[4].weight != 0) fault = "more than 4";
    }
    if (!fault.empty()) return fault;
  }
  return "";
}

WeightField fieldOf(const Mesh& body, const std::vector<Segment>& bones, double vertices = 1500) {
  WeightOptions options;
  options.volume.target_vertices = vertices;
  auto field = WeightField::make(body, bones, options);
  REQUIRE(field);
  return std::move(*field);
}

double largestDifference(const std::vector<Influences>& a, const std::vector<Influences>& b,
                         size_t bones) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (uint32_t bone = 0; bone < bones; ++bone) {
      most = std::max(most, std::fabs(weightOf(a[i], bone) - weightOf(b[i], bone)));
    }
  }
  return most;
}

struct Arm {
  std::vector<Vec3> middle = straight({0, 0, 0}, {100, 30, 20}, 40);
  Mesh body = tube(middle, 9);
  std::vector<Segment> bones = chain({middle[0], middle[10], middle[20], middle[30], middle[40]});
};

}  // namespace

TEST_CASE("skin weights: along a branch each bone's weight only falls, away from the bone") {
  const Arm arm;
  const WeightField field = fieldOf(arm.body, arm.bones);
  const std::vector<Influences> weights = field.at(arm.body);
  CHECK(faultOf(weights, arm.bones.size()) == "");
  const Vec3 along = (arm.middle[40] - arm.middle[0]) / distance(arm.middle[40], arm.middle[0]);
  constexpr double kStairs = 0.03;  // of the lattice, which lies crosswise
  const int sides = 12;
  for (uint32_t bone = 0; bone < arm.bones.size(); ++bone) {
    const double begin = dot(arm.bones[bone][0], along), end = dot(arm.bones[bone][1], along);
    for (int side = 0; side < sides; ++side) {
      double highest = 0;
      for (int ring = 0; ring <= 40; ++ring) {
        highest =
            std::max(highest, weightOf(weights[static_cast<size_t>(ring * sides + side)], bone));
      }
      CHECK(highest > 0.8);
      for (int ring = 0; ring < 40; ++ring) {
        const size_t v = static_cast<size_t>(ring * sides + side), next = v + sides;
        const double here = weightOf(weights[v], bone), there = weightOf(weights[next], bone);
        if (dot(arm.body.positions[v], along) > end) CHECK(there <= here + kStairs);
        if (dot(arm.body.positions[next], along) < begin) CHECK(here <= there + kStairs);
      }
    }
    // Two bones on there is nothing left.
    for (size_t v = 0; v < weights.size(); ++v) {
      const double x = dot(arm.body.positions[v], along), length = end - begin;
      if (x > end + 1.5 * length || x < begin - 1.5 * length) {
        CHECK(weightOf(weights[v], bone) < 0.02);
      }
    }
  }
}

TEST_CASE("skin weights: at the joint two bones of a branch have half each") {
  const Arm arm;
  const std::vector<Influences> weights = fieldOf(arm.body, arm.bones).at(arm.body);
  for (size_t v = 12 * 20; v < 12 * 21; ++v) {
    CHECK(weightOf(weights[v], 1) == Approx(0.5).margin(0.15));
    CHECK(weightOf(weights[v], 2) == Approx(0.5).margin(0.15));
  }
}

TEST_CASE("skin weights: a limb that only comes near in space is not moved") {
  // A hairpin: the hand lies beside the shoulder, a twentieth of the arm's length away.
  std::vector<Vec3> middle = straight({0, 0, 0}, {100, 0, 0}, 20);
  for (const Vec3 p : {Vec3{107, 2, 0}, {112, 8, 0}, {112, 14, 0}, {107, 20, 0}})
    middle.push_back(p);
  for (const Vec3 p : straight({100, 22, 0}, {0, 22, 0}, 20)) middle.push_back(p);
  const Mesh body = tube(middle, 8.5);
  const std::vector<Segment> bones = chain(
      {{0, 0, 0}, {50, 0, 0}, {100, 0, 0}, {112, 11, 0}, {100, 22, 0}, {50, 22, 0}, {0, 22, 0}});
  const std::vector<Influences> weights = fieldOf(body, bones, 2500).at(body);
  for (size_t v = 0; v < weights.size(); ++v) {
    const Vec3 p = body.positions[v];
    if (p.x > 80) continue;
    for (const uint32_t bone : {0u, 1u}) {
      if (p.y > 11) CHECK(weightOf(weights[v], bone) == 0);
    }
    for (const uint32_t bone : {4u, 5u}) {
      if (p.y < 11) CHECK(weightOf(weights[v], bone) == 0);
    }
  }
}

TEST_CASE("skin weights: both sides of a mirrored body have the same ones") {
  Mesh body = tube(straight({0, -40, 0}, {0, 60, 0}, 20), 16);
  std::vector<Segment> bones = chain({{0, -35, 0}, {0, 10, 0}, {0, 55, 0}});
  for (const double side : {1.0, -1.0}) {
    const std::vector<Vec3> middle{
        {0, 20, 0}, {20 * side, 22, 3}, {45 * side, 18, 5}, {75 * side, 20, 9}};
    append(body, tube(middle, 6));
    for (const Segment& bone : chain(middle)) bones.push_back(bone);
  }
  const auto mirror = [](Vec3 p) { return Vec3{-p.x, p.y, p.z}; };
  const WeightField field = fieldOf(body, bones);
  const std::vector<Influences> weights = field.at(body);
  const std::vector<Influences> other = field.at(insideOut(mapped(body, mirror)));
  const uint32_t twin[] = {0, 1, 5, 6, 7, 2, 3, 4};
  double most = 0, total = 0;
  for (size_t v = 0; v < weights.size(); ++v) {
    for (uint32_t bone = 0; bone < 8; ++bone) {
      const double off = std::fabs(weightOf(weights[v], bone) - weightOf(other[v], twin[bone]));
      most = std::max(most, off);
      total += off;
    }
  }
  CHECK(most < 0.05);
  CHECK(total / static_cast<double>(8 * weights.size()) < 1e-3);
}

TEST_CASE("skin weights: across a plane of symmetry twins have the same ones to rounding") {
  Random random(11);
  for (int run = 0; run < 4; ++run) {
    Mesh body = tube(straight({0, -40, 0}, {0, 60, 0}, 20), 16);
    std::vector<Segment> bones = chain({{0, -35, 0}, {0, 10, 0}, {0, 55, 0}});
    const double lift = random.between(-20, 20), depth = random.between(-8, 8);
    for (const double side : {1.0, -1.0}) {
      const std::vector<Vec3> middle{{0, 20, 0},
                                     {20 * side, 22, 3},
                                     {45 * side, 20 + lift / 3, 5},
                                     {75 * side, 20 + lift, depth}};
      append(body, tube(middle, 6));
      std::vector<Segment> arm = chain(middle);
      if (run % 2 && side < 0) std::swap(arm[0][0], arm[0][1]);  // a bone has no direction
      for (const Segment& bone : arm) bones.push_back(bone);
    }
    WeightOptions options;
    options.volume.target_vertices = 1500;
    options.volume.centre = Vec3{0, 3, 1};
    options.symmetry = Plane{{1, 0, 0}, 0};
    const auto field = WeightField::make(body, bones, options);
    REQUIRE(field);
    const std::vector<Influences> weights = field->at(body);
    CHECK(faultOf(weights, bones.size()) == "");
    const auto mirror = [](Vec3 p) { return Vec3{-p.x, p.y, p.z}; };
    const std::vector<Influences> other = field->at(insideOut(mapped(body, mirror)));
    const uint32_t twin[] = {0, 1, 5, 6, 7, 2, 3, 4};
    double most = 0;
    for (size_t v = 0; v < weights.size(); ++v) {
      const Influences four = limited(weights[v], 4), image = limited(other[v], 4);
      for (uint32_t bone = 0; bone < 8; ++bone) {
        most = std::max(most, std::fabs(weightOf(four, bone) - weightOf(image, twin[bone])));
      }
    }
    CHECK(most < 1e-9);
  }
}

TEST_CASE("skin weights: what has no mirror image keeps its own across a plane of symmetry") {
  Mesh body = tube(straight({0, -40, 0}, {0, 60, 0}, 20), 16);
  std::vector<Segment> bones = chain({{0, -35, 0}, {0, 10, 0}, {0, 55, 0}});
  const std::vector<Vec3> middle{{0, 20, 0}, {20, 22, 3}, {45, 18, 5}, {75, 20, 9}};
  append(body, tube(middle, 6));
  for (const Segment& bone : chain(middle)) bones.push_back(bone);
  WeightOptions options;
  options.volume.target_vertices = 1500;
  options.volume.centre = Vec3{0, 0, 0};
  const auto plain = WeightField::make(body, bones, options);
  options.symmetry = Plane{{1, 0, 0}, 0};
  const auto field = WeightField::make(body, bones, options);
  REQUIRE(plain);
  REQUIRE(field);
  const std::vector<Influences> weights = field->at(body), own = plain->at(body);
  CHECK(faultOf(weights, bones.size()) == "");
  for (size_t v = 0; v < weights.size(); ++v) {
    if (body.positions[v].x < 30) continue;
    for (uint32_t bone = 0; bone < bones.size(); ++bone) {
      CHECK(std::fabs(weightOf(weights[v], bone) - weightOf(own[v], bone)) < 1e-9);
    }
  }
}

TEST_CASE("skin weights: a leg beside another, a hairline away, is not moved by it") {
  for (const double gap : {0.05, 0.5, 2.0}) {
    Mesh body = box({-20, 0, -8}, {20, 30, 8});
    std::vector<Segment> bones{{Vec3{0, 25, 0}, Vec3{0, 12, 0}}};
    for (const double side : {1.0, -1.0}) {
      const double near = side * gap / 2, far = side * 20;
      append(body, box({std::min(near, far), -80, -8}, {std::max(near, far), 1, 8}));
      for (const Segment& bone :
           chain({{0, 12, 0}, {10 * side, 5, 0}, {10 * side, -38, 0}, {10 * side, -75, 0}})) {
        bones.push_back(bone);
      }
    }
    // The sides of the slit have vertices all along.
    const WeightField field = fieldOf(body, bones, 2000);
    Mesh skin;
    for (double y = -80; y < -20; y += 3) {
      for (const double side : {1.0, -1.0}) {
        const uint32_t first = static_cast<uint32_t>(skin.positions.size());
        for (const double z : {-5.0, 5.0}) skin.positions.push_back({side * gap / 2, y, z * side});
        skin.positions.push_back({side * gap / 2, y + 2, 0});
        skin.triangles.push_back({first, first + 1, first + 2});
      }
    }
    const std::vector<Influences> weights = field.at(skin);
    double most = 0;
    for (size_t v = 0; v < weights.size(); ++v) {
      const uint32_t first = skin.positions[v].x > 0 ? 5 : 2;  // shins and thighs of the other leg
      most = std::max(most, weightOf(weights[v], first) + weightOf(weights[v], first + 1));
    }
    CHECK(most < 0.02);
  }
}

TEST_CASE("skin weights: growing and moving the model changes nothing, turning it little") {
  const Arm arm;
  const std::vector<Influences> weights = fieldOf(arm.body, arm.bones).at(arm.body);
  const auto after = [&](const auto& map) {
    const Mesh body = mapped(arm.body, map);
    std::vector<Segment> bones;
    for (const auto& [a, b] : arm.bones) bones.push_back({map(a), map(b)});
    const std::vector<Influences> mapped_weights = fieldOf(body, bones).at(body);
    CHECK(faultOf(mapped_weights, bones.size()) == "");
    return largestDifference(weights, mapped_weights, bones.size());
  };
  CHECK(after([](Vec3 p) { return p * 1024; }) < 1e-9);
  CHECK(after([](Vec3 p) { return p * 0x1p-40; }) < 1e-9);
  CHECK(after([](Vec3 p) { return p + Vec3{512, -1024, 64}; }) < 0.2);
  Random random(21);
  for (int run = 0; run < 5; ++run) CHECK(after(randomSimilarity(random)) < 0.3);
}

TEST_CASE("skin weights: finer volumes give about the same ones") {
  const Arm arm;
  const std::vector<Influences> coarse = fieldOf(arm.body, arm.bones, 1500).at(arm.body);
  const std::vector<Influences> fine = fieldOf(arm.body, arm.bones, 4000).at(arm.body);
  CHECK(largestDifference(coarse, fine, arm.bones.size()) < 0.2);
}

TEST_CASE("skin weights: the quick ones are weights too, and not far from the others") {
  const Arm arm;
  auto quick = WeightField::make(arm.body, arm.bones, quickWeightOptions());
  REQUIRE(quick);
  const std::vector<Influences> weights = quick->at(arm.body);
  CHECK(faultOf(weights, arm.bones.size()) == "");
  CHECK(largestDifference(weights, fieldOf(arm.body, arm.bones).at(arm.body), arm.bones.size()) <
        0.4);
}

TEST_CASE("skin weights: what no bone runs through goes with the nearest place, all alike") {
  const Arm arm;
  Mesh body = arm.body;
  const Vec3 beside{50, 40, 10};
  append(body, box(beside, beside + Vec3{6, 6, 6}));
  const std::vector<Influences> weights = fieldOf(body, arm.bones).at(body);
  CHECK(faultOf(weights, arm.bones.size()) == "");
  const Influences& first = weights[arm.body.positions.size()];
  CHECK(weightOf(first, 1) + weightOf(first, 2) > 0.7);
  for (size_t v = arm.body.positions.size(); v < weights.size(); ++v) {
    for (uint32_t bone = 0; bone < 4; ++bone) {
      CHECK(weightOf(weights[v], bone) == Approx(weightOf(first, bone)).margin(1e-12));
    }
  }
}

TEST_CASE("skin weights: no bones, one, or bones in hostile places") {
  const Arm arm;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const Influences& influences : fieldOf(arm.body, {}).at(arm.body)) {
    for (const Influence& one : influences) CHECK(one.weight == 0);
  }
  for (const Segment& only :
       {Segment{Vec3{0, 0, 0}, Vec3{100, 30, 20}}, Segment{Vec3{50, 15, 10}, Vec3{50, 15, 10}},
        Segment{Vec3{0, 500, 0}, Vec3{100, 500, 0}}, Segment{Vec3{kNan, 0, 0}, Vec3{1, 1, 1}}}) {
    for (const Influences& influences : fieldOf(arm.body, {only}).at(arm.body)) {
      REQUIRE(influences[0].bone == 0);
      REQUIRE(influences[0].weight == 1);
    }
  }
  std::vector<Segment> bones = arm.bones;
  bones.push_back({Vec3{0, 500, 0}, Vec3{100, 500, 0}});
  bones.push_back({Vec3{kNan, 0, 0}, Vec3{1, 1, 1}});
  bones.push_back(bones[0]);  // twice the same
  const std::vector<Influences> weights = fieldOf(arm.body, bones).at(arm.body);
  CHECK(faultOf(weights, bones.size()) == "");
  for (const Influences& influences : weights) {
    REQUIRE(weightOf(influences, 4) == 0);
    REQUIRE(weightOf(influences, 5) == 0);
    REQUIRE(weightOf(influences, 0) == Approx(weightOf(influences, 6)).margin(1e-9));
  }
}

TEST_CASE("skin weights: hostile meshes have weights or a reason") {
  const Arm arm;
  CHECK(WeightField::make({}, arm.bones).status() == Status::meshFailed);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Mesh bad = arm.body;
  bad.positions[17].y = kNan;
  bad.triangles.push_back({0, 1, 1000000});
  const WeightField field = fieldOf(bad, arm.bones);
  CHECK(faultOf(field.at(bad), arm.bones.size()) == "");
  // Other meshes in the same field, some of them nowhere near.
  Mesh far = arm.body;
  for (Vec3& p : far.positions) p = p * 100;
  CHECK(faultOf(field.at(far), arm.bones.size()) == "");
  CHECK(field.at({}).empty());
  const Mesh tiny = box({1e-9, 1e-9, 1e-9}, {2e-9, 2e-9, 2e-9});
  CHECK(faultOf(fieldOf(tiny, arm.bones).at(tiny), arm.bones.size()) == "");
}

TEST_CASE("skin weights: whoever waits hears how far it is, and can stop it") {
  const Arm arm;
  double last = 0;
  int calls = 0;
  const auto count = [&](double done) {
    CHECK(done >= last);
    CHECK(done <= 1);
    last = done;
    ++calls;
    return true;
  };
  REQUIRE(WeightField::make(arm.body, arm.bones, {}, count));
  CHECK(calls > 4);
  for (int most = 0; most < calls; ++most) {
    int left = most;
    CHECK(!WeightField::make(arm.body, arm.bones, {}, [&](double) { return left-- > 0; }));
  }
}

TEST_CASE("skin weights: limited ones keep the largest") {
  Influences influences{};
  for (uint32_t i = 0; i < 5; ++i) influences[i] = {i + 3, 0.3 - 0.05 * i};
  const Influences four = limited(influences, 4), one = limited(influences, 0);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(four[i].bone == i + 3);
    CHECK(four[i].weight == Approx((0.3 - 0.05 * static_cast<double>(i)) / 0.9));
  }
  CHECK(four[4].weight == 0);
  CHECK(one[0].bone == 3);
  CHECK(one[0].weight == 1);
  CHECK(limited(Influences{}, 4)[0].weight == 0);
}

TEST_CASE("skin weights: of equal ones the limit keeps all or none") {
  // The fourth and the fifth are those of twins.
  Influences influences{};
  const double weights[] = {0.32, 0.2, 0.2, 0.12, 0.12};
  for (uint32_t i = 0; i < 5; ++i) influences[i] = {i, weights[i]};
  const Influences few = limited(influences, 4);
  CHECK(weightOf(few, 3) == 0);
  CHECK(weightOf(few, 4) == 0);
  CHECK(weightOf(few, 0) == Approx(0.32 / 0.72));
  CHECK(weightOf(few, 2) == Approx(0.2 / 0.72));
  CHECK(faultOf(few, 5) == "");
  // Where that would leave nothing some stay.
  for (uint32_t i = 0; i < 5; ++i) influences[i] = {i, 0.2};
  CHECK(weightOf(limited(influences, 4), 0) == 0.25);
  CHECK(shareKept(0, 0) == 1);
}

TEST_CASE("skin weights: a limit changes with the weights by no jump") {
  Random random(17);
  for (int run = 0; run < 2000; ++run) {
    // Some in order, then the last two of them a little the other way round.
    std::array<double, 6> weights{};
    for (double& one : weights) one = random.between(0.05, 0.25);
    weights[0] += 0.2;
    weights[4] = weights[3];
    const double little = 1e-7;
    const auto limitedTo4 = [&](double change) {
      std::vector<Influence> all;
      double sum = 0;
      for (uint32_t i = 0; i < 6; ++i) {
        all.push_back({i, weights[i] + (i == 3 ? change : i == 4 ? -change : 0)});
        sum += all.back().weight;
      }
      std::sort(all.begin(), all.end(), [](const Influence& a, const Influence& b) {
        return a.weight != b.weight ? a.weight > b.weight : a.bone < b.bone;
      });
      Influences influences{};
      for (size_t i = 0; i < all.size(); ++i) influences[i] = {all[i].bone, all[i].weight / sum};
      return limited(influences, 4);
    };
    const Influences one = limitedTo4(little), other = limitedTo4(-little);
    for (uint32_t bone = 0; bone < 6; ++bone) {
      CHECK(std::fabs(weightOf(one, bone) - weightOf(other, bone)) < 1e-4);
    }
  }
}

TEST_CASE("skin weights: random creatures") {
  Random random(31);
  PartOptions coarse = previewOptions();
  coarse.triangulation.target_points = 120;
  for (int run = 0; run < 25; ++run) {
    INFO("creature " << run);
    const Document document = randomCreature(random, 2 + random.below(7));
    Evaluation character(coarse);
    character.update(document);
    const Mesh body = bodyOf(character);
    const std::vector<Segment> bones = boneSegments(character.rig());
    const WeightField field = fieldOf(body, bones, 800);
    const std::vector<Influences> weights = field.at(body);
    REQUIRE(weights.size() == body.positions.size());
    CHECK(faultOf(weights, bones.size()) == "");
    for (uint32_t v = 0; v < field.volume().vertices.size(); ++v) {
      double sum = 0;
      for (const Influence* one = field.begin(v); one != field.end(v); ++one) sum += one->weight;
      REQUIRE(sum == Approx(1).epsilon(1e-9));
    }
  }
}

namespace {

/// How much the weights of what is on one side of a plane differ from those of its mirror image, on
/// average; 1 where a bone has no mirror image.
double asymmetry(const WeightField& field, const Mesh& body, const std::vector<Segment>& bones,
                 const Plane& plane) {
  const auto mirror = [&](Vec3 p) { return mirrored(p, plane); };
  std::vector<uint32_t> twins;
  for (const auto& [a, b] : bones) {
    for (uint32_t twin = 0; twin < bones.size(); ++twin) {
      const double off = distance(mirror(a), bones[twin][0]) + distance(mirror(b), bones[twin][1]);
      if (off > 1e-6) continue;
      twins.push_back(twin);
      break;
    }
  }
  if (twins.size() != bones.size()) return 1;
  const std::vector<Influences> weights = field.at(body);
  const std::vector<Influences> images = field.at(insideOut(mapped(body, mirror)));
  double total = 0;
  for (size_t v = 0; v < weights.size(); ++v) {
    for (uint32_t bone = 0; bone < bones.size(); ++bone) {
      total += std::fabs(weightOf(weights[v], bone) - weightOf(images[v], twins[bone]));
    }
  }
  return total / static_cast<double>(weights.size() * bones.size());
}

}  // namespace

TEST_CASE("skin weights: the gallery's creatures move with all their bones, both sides alike") {
  CHECK(sampleFiles().size() >= 12);
  for (const auto& [name, text, tree, document] : sampleFiles()) {
    INFO(name);
    PartOptions options;
    options.triangulation.target_points = 300;
    Evaluation character(options);
    character.update(document);
    const Mesh body = bodyOf(character);
    const std::vector<Segment> bones = boneSegments(character.rig());
    WeightOptions weight_options;
    if (document.symmetry) {
      weight_options.volume.centre = document.symmetry->normal * -document.symmetry->offset;
      weight_options.symmetry = document.symmetry;
    }
    auto field = WeightField::make(body, bones, weight_options);
    REQUIRE(field);
    CHECK(field->volume().piece_count == 1);
    CHECK(field->volume().vertices.size() >= 2500);
    CHECK(field->volume().vertices.size() < 5000);
    const std::vector<Influences> weights = field->at(body);
    CHECK(faultOf(weights, bones.size()) == "");
    for (uint32_t bone = 0; bone < bones.size(); ++bone) {
      double most = 0;
      for (const Influences& influences : weights) {
        most = std::max(most, weightOf(influences, bone));
      }
      INFO("bone " << bone);
      CHECK(most > 0.05);
    }
    if (name == "bear" || name == "dog" || name == "dragon" || name == "octopus") {
      REQUIRE(document.symmetry);
      CHECK(asymmetry(*field, body, bones, *document.symmetry) < 1e-9);
    }
  }
}
