#include "bench/parted_creatures.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "document/placed_parts.h"
#include "support/random.h"
#include "support/strokes.h"

namespace marrow::bench {
namespace {

using strokes::kTau;
using strokes::Stroke;

/// Parts as one hand draws them.
class Drawing {
 public:
  explicit Drawing(Random& random) : random_(random) {}

  double about(double value) { return value * random_.between(0.8, 1.25); }
  double near(double value, double by) { return value + random_.between(-by, by); }

  Stroke ellipse(double rx, double ry) {
    Stroke stroke = strokes::disc(1, 60);
    for (Vec2& p : stroke) p = {p.x * rx, p.y * ry};
    return uneven(std::move(stroke));
  }
  /// From the origin along `way`, bent, narrower to its end.
  Stroke limb(Vec2 way, double half_width, double taper = 0.7) {
    const double bend = random_.between(-0.5, 0.5);
    Stroke left, right;
    constexpr int kSteps = 24;
    for (int i = 0; i <= kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const Vec2 at = way * t + perpendicular(way) * (bend * t * (1 - t));
      const Vec2 along = way + perpendicular(way) * (bend * (1 - 2 * t));
      const double round = std::sqrt(std::min(1.0, std::min(t, 1 - t) * 9 + 0.05));
      const Vec2 across =
          perpendicular(along) / length(along) * (half_width * (1 + (taper - 1) * t) * round);
      left.push_back(at - across);
      right.push_back(at + across);
    }
    left.insert(left.end(), right.rbegin(), right.rend());
    return uneven(std::move(left));
  }
  /// A round head from whose top two ears stand up.
  Stroke headWithEars(double radius, double ear) {
    Stroke stroke;
    for (int i = 0; i < 90; ++i) {
      const double angle = kTau * i / 90;
      double r = radius;
      for (const double middle : {kTau * 0.15, kTau * 0.35}) {
        const double off = (angle - middle) / 0.32;
        if (std::abs(off) < 1) r += ear * (1 - off * off);
      }
      stroke.push_back(strokes::polar(r, angle));
    }
    return uneven(std::move(stroke));
  }
  /// A lens from (−half, 0) to (half, 0), higher than it is deep.
  Stroke fin(double half, double height) {
    Stroke stroke;
    for (int i = 0; i < 60; ++i) {
      const double angle = kTau * i / 60, y = std::sin(angle);
      stroke.push_back(
          {half * std::cos(angle) + 0.25 * height * y, y * (y > 0 ? height : height * 0.4)});
    }
    return uneven(std::move(stroke));
  }

 private:
  Stroke uneven(Stroke stroke) {
    Vec2 low = stroke[0], high = stroke[0];
    for (const Vec2 p : stroke) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double by = 0.012 * std::min(high.x - low.x, high.y - low.y);
    stroke = strokes::jittered(random_, std::move(stroke), by);
    return strokes::startedAt(std::move(stroke), static_cast<size_t>(random_.below(20)));
  }

  Random& random_;
};

/// Collects parts with their names, and puts them in the order in which they were drawn.
class Assembling {
 public:
  Assembling(Random& random, bool limbs_first) : random_(random), limbs_first_(limbs_first) {}

  struct Placing {
    Vec3 at;
    double turn = 0;
    std::optional<Plane> mirror = {};
  };

  void add(const char* name, Stroke stroke, const Placing& placing, const char* on = nullptr) {
    auto part = std::make_shared<PartSource>();
    part->name = name;
    part->stroke = strokes::rotated(std::move(stroke), placing.turn);
    part->frame.origin = placing.at;
    part->thickness = random_.between(0.8, 1.15);
    part->mirror = placing.mirror;
    parts_.push_back(std::move(part));
    holders_.push_back(on ? on : "");
  }

  PartedCreature done(std::string name) {
    PartedCreature creature;
    creature.name = std::move(name) + (limbs_first_ ? " (limbs first)" : "");
    std::vector<size_t> order(parts_.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    if (limbs_first_) {
      // Legs, arms and fins before the body, everything else after it.
      std::stable_partition(order.begin(), order.end(), [&](size_t i) {
        const std::string& what = parts_[i]->name;
        return what == "Leg" || what == "Arm" || what == "Fin" || what == "Tail";
      });
    }
    for (const size_t i : order) {
      parts_[i]->id = partId(takePartNumber(creature.document));
      creature.document.parts.push_back(parts_[i]);
    }
    for (const size_t i : order) {
      if (holders_[i].empty()) continue;
      for (const size_t k : order) {
        if (parts_[k]->name != holders_[i]) continue;
        creature.hangs.emplace_back(parts_[i]->id, parts_[k]->id);
        if (!parts_[i]->mirror) break;
        const bool pair = parts_[k]->mirror.has_value();
        creature.hangs.emplace_back(parts_[i]->id + kTwinSuffix,
                                    parts_[k]->id + (pair ? kTwinSuffix : ""));
        break;
      }
    }
    return creature;
  }

 private:
  Random& random_;
  bool limbs_first_;
  std::vector<std::shared_ptr<PartSource>> parts_;
  std::vector<std::string> holders_;
};

const Plane kAcrossX{{1, 0, 0}, 0}, kAcrossZ{{0, 0, 1}, 0};

/// From the side: legs on either side of the body, a neck or none, a head with ears, a tail.
PartedCreature quadruped(Random& random, bool limbs_first) {
  Drawing draw(random);
  Assembling all(random, limbs_first);
  const double rx = draw.about(170), ry = draw.about(75);
  all.add("Body", draw.ellipse(rx, ry), {{0, 0, 0}});
  const double reach = draw.about(150), width = draw.about(22);
  all.add("Leg", draw.limb({draw.near(0, 20), -reach}, width),
          {{draw.near(-0.62 * rx, 10), draw.near(-0.2 * ry, 10), 0.5 * ry}, 0, kAcrossZ}, "Body");
  all.add("Leg", draw.limb({draw.near(0, 20), -reach}, width),
          {{draw.near(0.6 * rx, 10), draw.near(-0.2 * ry, 10), 0.5 * ry}, 0, kAcrossZ}, "Body");
  const bool neck = random.below(2) == 0;
  const Vec2 way{draw.near(50, 20), draw.about(95)};
  const Vec2 shoulder{0.82 * rx, 0.3 * ry};
  if (neck) {
    all.add("Neck", draw.limb(way, draw.about(26)), {{shoulder.x, shoulder.y, 0}}, "Body");
  }
  const double radius = draw.about(55);
  const Vec2 head = neck ? shoulder + way * 1.1 : Vec2{rx + 0.45 * radius, draw.near(0.6 * ry, 12)};
  all.add("Head", draw.headWithEars(radius, draw.about(40)),
          {{head.x, head.y, 0}, draw.near(-0.4, 0.4)}, neck ? "Neck" : "Body");
  all.add("Tail", draw.limb({-draw.about(150), draw.near(50, 40)}, draw.about(11)),
          {{-0.88 * rx, draw.near(0.2 * ry, 8), 0}}, "Body");
  return all.done("quadruped");
}

/// From the front: a torso, a head with ears, arms and legs that are each other's mirror images.
PartedCreature biped(Random& random, bool limbs_first) {
  Drawing draw(random);
  Assembling all(random, limbs_first);
  const double rx = draw.about(60), ry = draw.about(105);
  all.add("Body", draw.ellipse(rx, ry), {{0, 0, 0}});
  const double radius = draw.about(65);
  all.add("Head", draw.headWithEars(radius, draw.about(50)),
          {{draw.near(0, 8), ry + radius * random.between(0.55, 0.85), 0}, draw.near(0, 0.25)},
          "Body");
  all.add("Arm", draw.limb({draw.about(120), -draw.about(60)}, draw.about(19)),
          {{0.5 * rx, 0.55 * ry, draw.near(10, 10)}, 0, kAcrossX}, "Body");
  all.add("Leg", draw.limb({draw.near(15, 10), -draw.about(140)}, draw.about(24)),
          {{0.45 * rx, -0.7 * ry, draw.near(0, 8)}, 0, kAcrossX}, "Body");
  all.add("Foot", draw.ellipse(draw.about(34), draw.about(17)),
          {{0.45 * rx + 32, -0.7 * ry - 135, 8}, 0, kAcrossX}, "Leg");
  return all.done("biped");
}

/// A body with a fin along its back, one below it, a tail fin, and fins on its sides.
PartedCreature fish(Random& random, bool limbs_first) {
  Drawing draw(random);
  Assembling all(random, limbs_first);
  const double rx = draw.about(180), ry = draw.about(80);
  all.add("Body", draw.ellipse(rx, ry), {{0, 0, 0}});
  all.add("Fin", draw.fin(0.55 * rx, draw.about(60)),
          {{draw.near(0, 20), random.between(0.65, 0.9) * ry, 0}, draw.near(0, 0.1)}, "Body");
  all.add("Fin", draw.fin(0.3 * rx, draw.about(40)),
          {{draw.near(-40, 20), -0.85 * ry, 0}, kTau / 2 + draw.near(0, 0.15)}, "Body");
  all.add("Tail", draw.fin(draw.about(85), draw.about(60)),
          {{-rx - 5, 0, 0}, kTau / 4 + draw.near(0, 0.2)}, "Body");
  all.add("Flipper", draw.limb({-draw.about(80), -draw.about(50)}, draw.about(20)),
          {{draw.near(40, 15), -0.2 * ry, random.between(0.6, 0.85) * ry}, 0, kAcrossZ}, "Body");
  return all.done("fish");
}

/// Three lumps, six legs, two antennae, wings that lie on the back.
PartedCreature insect(Random& random, bool limbs_first) {
  Drawing draw(random);
  Assembling all(random, limbs_first);
  const double r = draw.about(60);
  all.add("Body", draw.ellipse(r * 1.25, r), {{0, 0, 0}});
  all.add("Abdomen", draw.ellipse(draw.about(105), draw.about(60)), {{-r * 1.2 - 75, -8, 0}},
          "Body");
  const double head = draw.about(40);
  all.add("Head", draw.ellipse(head, head * 0.9), {{1.25 * r + 0.6 * head, 14, 0}}, "Body");
  for (const double x : {-0.7, 0.0, 0.7}) {
    all.add("Leg", draw.limb({draw.near(60 * x, 15), -draw.about(115)}, draw.about(9)),
            {{x * r, -0.25 * r, 0.5 * r}, 0, kAcrossZ}, "Body");
  }
  all.add("Antenna", draw.limb({draw.about(70), draw.about(75)}, draw.about(6)),
          {{1.25 * r + 0.7 * head, 14 + 0.4 * head, 0.3 * head}, 0, kAcrossZ}, "Head");
  return all.done("insect");
}

/// A bird whose wings lie along its sides.
PartedCreature bird(Random& random, bool limbs_first) {
  Drawing draw(random);
  Assembling all(random, limbs_first);
  const double rx = draw.about(130), ry = draw.about(80);
  all.add("Body", draw.ellipse(rx, ry), {{0, 0, 0}, draw.near(0.2, 0.15)});
  const double head = draw.about(50);
  all.add("Head", draw.ellipse(head, draw.about(45)), {{0.85 * rx + 10, 0.95 * ry, 0}}, "Body");
  all.add("Beak", draw.limb({draw.about(65), draw.near(-8, 8)}, draw.about(15), 0.2),
          {{0.85 * rx + 10 + 0.7 * head, 0.95 * ry, 0}}, "Head");
  all.add("Wing", draw.fin(0.75 * rx, draw.about(50)),
          {{draw.near(-15, 15), draw.near(8, 10), random.between(0.75, 1) * ry},
           draw.near(0.1, 0.2),
           kAcrossZ},
          "Body");
  all.add("Leg", draw.limb({draw.near(5, 10), -draw.about(110)}, draw.about(10)),
          {{draw.near(0, 15), -0.55 * ry, 0.3 * ry}, 0, kAcrossZ}, "Body");
  all.add("Tail", draw.limb({-draw.about(130), draw.near(0, 30)}, draw.about(24), 1.2),
          {{-0.8 * rx, -0.1 * ry, 0}}, "Body");
  return all.done("bird");
}

/// A head with arms all around, and eyes on stalks.
PartedCreature octopus(Random& random, bool limbs_first) {
  Drawing draw(random);
  Assembling all(random, limbs_first);
  const double r = draw.about(85);
  all.add("Body", draw.ellipse(r, draw.about(95)), {{0, 0, 0}});
  for (int arm = 0; arm < 5; ++arm) {
    const double angle = kTau * (0.57 + 0.09 * arm);
    all.add("Arm", draw.limb(strokes::polar(draw.about(170), angle), draw.about(17), 0.4),
            {{0.55 * r * std::cos(angle), 0.6 * r * std::sin(angle), draw.near(0, 25)}}, "Body");
  }
  all.add("Stalk", draw.limb({draw.near(10, 10), draw.about(70)}, draw.about(11)),
          {{0.4 * r, 0.75 * r, draw.near(0, 10)}, 0, kAcrossX}, "Body");
  all.add("Eye", draw.ellipse(draw.about(17), draw.about(17)),
          {{0.4 * r + 12, 0.75 * r + 78, draw.near(0, 4)}, 0, kAcrossX}, "Stalk");
  all.add("Belt", draw.limb({draw.near(-150, 10), draw.near(30, 20)}, draw.about(16), 1),
          {{70, 0.1 * r, 0.8 * r}}, "Body");
  return all.done("octopus");
}

}  // namespace

std::vector<PartedCreature> partedCreatures(int count) {
  constexpr PartedCreature (*kKinds[])(Random&, bool) = {quadruped, biped, fish,
                                                         insect,    bird,  octopus};
  constexpr int kCount = static_cast<int>(sizeof(kKinds) / sizeof(kKinds[0]));
  std::vector<PartedCreature> creatures;
  Random random(41);
  for (int i = 0; i < count; ++i) {
    PartedCreature creature = kKinds[i % kCount](random, i / kCount % 2 == 1);
    creature.name += " " + std::to_string(i);
    creatures.push_back(std::move(creature));
  }
  return creatures;
}

}  // namespace marrow::bench
