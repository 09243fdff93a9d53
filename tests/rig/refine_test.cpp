#include "rig/refine.h"

#include <limits>

#include "rig/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

using Threshold = std::optional<double> Refinement::*;
constexpr Threshold kThresholds[] = {&Refinement::simplify, &Refinement::merge, &Refinement::prune,
                                     &Refinement::collapse};

double randomThreshold(Random& random) {
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return random.between(0, 3);
    case 2:
      return random.between(0, 2000);
    default:
      return random.between(0, 80);
  }
}

Refinement randomThresholds(Random& random) {
  Refinement refine;
  for (const Threshold threshold : kThresholds) {
    if (random.below(4) > 0) refine.*threshold = randomThreshold(random);
  }
  return refine;
}

void setThresholdsOf(Document& document, size_t part, const Refinement& refine) {
  auto source = std::make_shared<PartSource>(*document.parts[part]);
  source->refine = refine;
  document.parts[part] = source;
}

/// Every joint of the coarser rig is one of the finer, by id and by name.
void checkCoarser(const Rig& coarse, const Rig& fine) {
  CHECK(coarse.joints.size() <= fine.joints.size());
  std::map<std::string, std::string> names;
  for (const auto& joint : fine.joints) names[joint.id] = joint.name;
  for (const auto& joint : coarse.joints) {
    INFO(joint.id);
    const auto found = names.find(joint.id);
    REQUIRE(found != names.end());
    CHECK(found->second == joint.name);
  }
  REQUIRE(coarse.roots.size() == fine.roots.size());
  for (size_t i = 0; i < fine.roots.size(); ++i) {
    CHECK(coarse.joints[coarse.roots[i]].id == fine.joints[fine.roots[i]].id);
  }
}

/// A random creature whose thresholds are the model's alone.
Document withoutOwnThresholds(Random& random, int parts) {
  Document document = randomCreature(random, parts);
  for (size_t i = 0; i < document.parts.size(); ++i) setThresholdsOf(document, i, {});
  return document;
}

}  // namespace

TEST_CASE("rig: any creature gives a forest, whatever the thresholds", "[rig]") {
  Random random(1);
  for (int run = 0; run < 150; ++run) {
    CAPTURE(run);
    Workshop workshop;
    const Assembly creature(randomCreature(random, 2 + random.below(run % 10 == 0 ? 59 : 12)),
                            workshop);
    CHECK(faultOf(creature.rig(), creature) == "");
    CHECK(faultOf(creature.rig(unrefined()), creature) == "");
    for (int i = 0; i < 5; ++i) {
      CHECK(faultOf(creature.rig(randomThresholds(random)), creature) == "");
    }
  }
}

TEST_CASE("rig: a larger threshold never gives more joints, and keeps ids, names and roots",
          "[rig]") {
  Random random(2);
  for (int run = 0; run < 120; ++run) {
    CAPTURE(run);
    Workshop workshop;
    Document document = randomCreature(random, 2 + random.below(12));
    const std::vector<Connection> connections = Assembly(document, workshop).connections();
    for (int i = 0; i < 12; ++i) {
      document.refine = randomThresholds(random);
      const int part = random.below(static_cast<int>(document.parts.size()) + 1) - 1;
      Refinement refine = part < 0 ? document.refine : document.parts[part]->refine;
      const Threshold threshold = kThresholds[random.below(4)];
      Rig last;
      for (double value = 0.01; value < 3000; value *= 1 + 4 * random.unit()) {
        CAPTURE(part, value);
        refine.*threshold = value;
        if (part < 0) {
          document.refine = refine;
        } else {
          setThresholdsOf(document, static_cast<size_t>(part), refine);
        }
        const Assembly creature(document, workshop);
        const Rig rig = refineRig(creature.parts, connections, document.refine);
        if (!last.joints.empty()) checkCoarser(rig, last);
        last = rig;
      }
    }
  }
}

TEST_CASE("rig: a larger threshold of one branch never gives more joints", "[rig]") {
  Random random(3);
  int changed = 0;
  for (int run = 0; run < 60; ++run) {
    Workshop workshop;
    Document document = randomCreature(random, 2 + random.below(6));
    document.refine = thresholds(randomThreshold(random), random.between(0, 10), 0, 0);
    auto source = std::make_shared<PartSource>(*document.parts[0]);
    document.parts[0] = source;
    Rig last;
    for (double value = 0; value < 300; value = value * 1.7 + 0.2) {
      source->branches["b" + std::to_string(run % 3)] = value;
      source->branches["no branch"] = 7;
      const Rig rig = Assembly(document, workshop).rig();
      if (!last.joints.empty()) {
        checkCoarser(rig, last);
        changed += rig.joints.size() < last.joints.size();
      }
      last = rig;
    }
  }
  CHECK(changed > 60);
}

TEST_CASE("rig: a threshold pulled up and back gives the identical rig", "[rig]") {
  Random random(4);
  for (int run = 0; run < 20; ++run) {
    Workshop workshop;
    const Document document = randomCreature(random, 2 + random.below(10));
    const Rig before = Assembly(document, workshop).rig();
    Document pulled = document;
    pulled.refine = thresholds(2000, 2000, 2000, 2000);
    CHECK(Assembly(pulled, workshop).rig().joints.size() <= before.joints.size());
    pulled.refine = document.refine;
    CHECK(Assembly(pulled, workshop).rig() == before);
  }
}

TEST_CASE("rig: unset thresholds are the next wider scope's, then the defaults", "[rig]") {
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    Workshop workshop;
    const Document document = withoutOwnThresholds(random, 2 + random.below(10));
    const Refinement defaults = thresholds(5, 30, 30, 10);
    CHECK(Assembly(document, workshop).rig({}) == Assembly(document, workshop).rig(defaults));

    const Refinement coarse = randomThresholds(random);
    Document in_parts = document;
    for (size_t i = 0; i < document.parts.size(); ++i) setThresholdsOf(in_parts, i, coarse);
    CHECK(Assembly(document, workshop).rig(coarse) ==
          Assembly(in_parts, workshop).rig(thresholds(5, 30, 30, 10)));

    Document in_branches = document;
    const double simplify = randomThreshold(random);
    for (auto& part : in_branches.parts) {
      auto source = std::make_shared<PartSource>(*part);
      for (int b = 0; b < 20; ++b) source->branches[branchKey(b)] = simplify;
      source->refine.simplify = 77;
      part = source;
    }
    Refinement model;
    model.simplify = simplify;
    CHECK(Assembly(document, workshop).rig(model) == Assembly(in_branches, workshop).rig({}));
  }
}

TEST_CASE("rig: senseless thresholds do no harm", "[rig]") {
  Random random(6);
  Workshop workshop;
  const Assembly creature(randomCreature(random, 8), workshop);
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double value : {-1.0, 0.0, 1e-300, 1e300, inf, -inf, nan}) {
    for (const Threshold threshold : kThresholds) {
      Refinement refine;
      refine.*threshold = value;
      CHECK(faultOf(creature.rig(refine), creature) == "");
    }
  }
}

TEST_CASE("rig: without thresholds every joint of every part is there", "[rig]") {
  Random random(7);
  for (int run = 0; run < 40; ++run) {
    Workshop workshop;
    const Document document = withoutOwnThresholds(random, 2 + random.below(10));
    const Assembly creature(document, workshop);
    const Rig rig = creature.rig(unrefined());
    std::map<std::string, Vec3> positions;
    for (const auto& joint : rig.joints) positions[joint.id] = joint.position;
    // ε_s is measured on the part that nobody holds.
    const auto epsilonOf = [&](uint32_t part) {
      uint32_t top = part;
      while (const Connection* held = connectionOf(rig.connections, top)) top = held->parent;
      return Refinement::kSimplify * creature.parts[top].part->outline.scale() *
             creature.placed[top].frame.scale() / creature.placed[part].frame.scale();
    };
    size_t expected = 0;
    for (uint32_t i = 0; i < creature.parts.size(); ++i) {
      if (!creature.hasBones(i)) continue;
      const PartSkeleton& skeleton = creature.parts[i].part->skeleton;
      const double epsilon = epsilonOf(i);
      for (const auto& branch : skeleton.branches) {
        for (size_t k = 1; k + 1 < branch.levels.size(); ++k) {
          expected += isKept(branch.levels[k], epsilon);
        }
      }
      for (const auto& joint : skeleton.joints) expected += joint.kind != JointKind::sleeve;
      for (size_t j = 0; j < skeleton.joints.size(); ++j) {
        if (skeleton.joints[j].kind == JointKind::sleeve) continue;
        const auto found = positions.find(creature.placed[i].id + "/n" + std::to_string(j));
        REQUIRE(found != positions.end());
        CHECK(found->second == creature.placed[i].frame.toWorld(skeleton.joints[j].position));
      }
    }
    const auto isSleeve = [&](uint32_t part, uint32_t joint) {
      return creature.parts[part].part->skeleton.joints[joint].kind == JointKind::sleeve;
    };
    std::set<std::array<double, 3>> splits;
    for (const Connection& c : rig.connections) {
      const Vec3 p = c.parent_position, q = c.child_position;
      if (c.event == AttachEvent::split || isSleeve(c.parent, c.parent_joint)) {
        splits.insert({p.x, p.y, p.z});
      }
      if (c.child_split || isSleeve(c.child, c.child_joint)) splits.insert({q.x, q.y, q.z});
    }
    CHECK(rig.joints.size() <= expected + splits.size());
    // Places on the samples of a branch are joints already.
    CHECK(rig.joints.size() + 2 * rig.connections.size() >= expected + splits.size());
    // Each child's bone goes from where it hangs to its own joint.
    for (const Connection& c : rig.connections) {
      const auto is_there = [&](const std::array<uint32_t, 2>& bone) {
        const double near = 1e-5 * creature.placed[c.parent].frame.scale() * 1000;
        const Vec3 a = rig.joints[bone[0]].position, b = rig.joints[bone[1]].position;
        return (distance(a, c.parent_position) < near && distance(b, c.child_position) < near) ||
               (distance(b, c.parent_position) < near && distance(a, c.child_position) < near);
      };
      CHECK(std::any_of(rig.bones.begin(), rig.bones.end(), is_there));
    }
  }
}

TEST_CASE("rig: pruning leaves every part a bone", "[rig]") {
  Random random(8);
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Workshop workshop;
    const Document document = withoutOwnThresholds(random, 2 + random.below(10));
    const Assembly creature(document, workshop);
    const Rig rig = creature.rig(thresholds(random.between(0, 20), 0, 2000, 0));
    std::set<uint32_t> own;  // parts with a bone between two of their joints
    for (const auto& [a, b] : rig.bones) {
      if (rig.joints[a].part == rig.joints[b].part) own.insert(rig.joints[a].part);
    }
    for (uint32_t i = 0; i < creature.parts.size(); ++i) {
      if (creature.hasBones(i)) CHECK(own.count(i) == 1);
    }
  }
}

TEST_CASE("rig: no bone between inner joints stays below the collapse threshold", "[rig]") {
  Random random(9);
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Workshop workshop;
    const Document document = withoutOwnThresholds(random, 1 + random.below(2));
    const Assembly creature(document, workshop);
    const double room = random.between(5, 60);
    const Rig rig = creature.rig(thresholds(0.5, 0, 0, room));
    for (const auto& [a, b] : rig.bones) {
      const Rig::Joint &from = rig.joints[a], &to = rig.joints[b];
      if (from.kind == JointKind::terminal || to.kind == JointKind::terminal) continue;
      // Along a branch, between sleeves, the samples say how far; lengths are never larger.
      if (from.part != to.part || from.branch != to.branch) continue;
      if (from.kind != JointKind::sleeve || to.kind != JointKind::sleeve) continue;
      const auto& branch = creature.parts[to.part].part->skeleton.branches[to.branch];
      const auto sampleOf = [&](const Rig::Joint& joint) {
        const size_t dot_at = joint.id.rfind(".");
        const size_t slash = joint.id.rfind("/b");
        return dot_at == std::string::npos || slash == std::string::npos
                   ? -1
                   : std::stoi(joint.id.substr(dot_at + 1));
      };
      const int i = sampleOf(from), k = sampleOf(to);
      if (i < 0 || k < 0) continue;
      const double apart = std::abs(branch.samples[static_cast<size_t>(i)].along -
                                    branch.samples[static_cast<size_t>(k)].along) *
                           creature.placed[to.part].frame.scale();
      uint32_t root = b;
      while (rig.joints[root].parent >= 0) root = static_cast<uint32_t>(rig.joints[root].parent);
      const uint32_t part = rig.joints[root].part;
      CHECK(apart >= room * 0.999 * creature.parts[part].part->outline.scale() *
                         creature.placed[part].frame.scale());
    }
  }
}

}  // namespace marrow
