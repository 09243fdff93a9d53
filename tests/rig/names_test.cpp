#include "rig/names.h"

#include "rig/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

std::set<std::string> namesOf(const Rig& rig) {
  std::set<std::string> names;
  for (const auto& joint : rig.joints) names.insert(joint.name);
  return names;
}

/// A part called so, with a twin or without, and the names it gives to the joints' prefixes.
std::vector<std::string> named(const std::vector<std::string>& names, bool twins = false) {
  Document document;
  for (const std::string& name : names) {
    addPart(document, name, ellipse({50, 0}, 20, 40), 0,
            twins ? std::optional<Plane>(Plane{{1, 0, 0}, 0}) : std::nullopt);
  }
  Workshop workshop;
  return uniqueNames(Assembly(document, workshop).parts);
}

}  // namespace

TEST_CASE("names: part, side, number along the branch from the root", "[rig]") {
  Workshop workshop;
  const Assembly creature(quadruped(), workshop);
  const Rig rig = creature.rig(unrefined());
  const std::set<std::string> names = namesOf(rig);
  for (const char* name : {"Body.1", "Body.2", "Leg.L.1", "Leg.R.1", "Leg 2.L.1", "Leg 2.R.1",
                           "Neck.1", "Head.1", "Tail.1"}) {
    CHECK(names.count(name) == 1);
  }
  // Along each part with one branch the numbers grow from the root, none is missing.
  std::map<uint32_t, int> last;
  for (const auto& joint : rig.joints) {
    if (joint.part == 0) continue;
    const int number = std::stoi(joint.name.substr(joint.name.rfind('.') + 1));
    if (joint.part != creature.indexOf("part-4")) CHECK(number == last[joint.part] + 1);
    last[joint.part] = number;
  }
}

TEST_CASE("names: further branches have letters", "[rig]") {
  Workshop workshop;
  Document document;
  std::vector<Vec2> star;
  for (const Vec2 p : unitCircle(200)) {
    Vec2 turned{1, 0};
    for (int i = 0; i < 5; ++i)
      turned = {turned.x * p.x - turned.y * p.y, turned.x * p.y + turned.y * p.x};
    star.push_back(p * (100 * (1 + 0.5 * turned.x)));
  }
  addPart(document, "Star", star);
  const Rig rig = Assembly(document, workshop).rig(unrefined());
  const std::set<std::string> names = namesOf(rig);
  for (const char* name : {"Star.1", "Star.2", "Star.B1", "Star.C1", "Star.D1", "Star.E1"}) {
    CHECK(names.count(name) == 1);
  }
  CHECK(rig.joints[0].name == "Star.1");
}

TEST_CASE("names: a finer skeleton adds names and renames nothing", "[rig]") {
  Workshop workshop;
  const Assembly creature(quadruped(), workshop);
  const std::set<std::string> coarse = namesOf(creature.rig(unrefined()));
  const std::set<std::string> fine = namesOf(creature.rig(thresholds(0.05, 0, 0, 0)));
  CHECK(fine.size() > coarse.size());
  CHECK(std::includes(fine.begin(), fine.end(), coarse.begin(), coarse.end()));
}

TEST_CASE("names: what people type becomes sensible and unique", "[rig]") {
  CHECK(named({"Leg", "Leg", "Leg 2", "Leg"}) ==
        std::vector<std::string>{"Leg", "Leg 2", "Leg 2 2", "Leg 3"});
  CHECK(named({"", "  ", "\t\n"}) == std::vector<std::string>{"Part", "Part 2", "Part 3"});
  CHECK(named({"  left \n hand "}) == std::vector<std::string>{"left hand"});
  CHECK(named({"Arm", "Arm"}, true) ==
        std::vector<std::string>{"Arm.L", "Arm.R", "Arm 2.L", "Arm 2.R"});
  CHECK(named({std::string("a\0b\x01\xff"
                           "c",
                           6)}) == std::vector<std::string>{"a b c"});
  CHECK(named({"Fl\xc3\xbcgel \xe7\xbf\xbc"}) ==
        std::vector<std::string>{"Fl\xc3\xbcgel \xe7\xbf\xbc"});
  // Cut between characters.
  std::string umlauts = "a";
  for (int i = 0; i < 5000; ++i) umlauts += "\xc3\xbc";
  const std::string cut = named({umlauts})[0];
  CHECK(cut.size() == 39);
  CHECK(cut == umlauts.substr(0, 39));
  // A part whose name looks like a twin's.
  const auto tricky = [&] {
    Document document;
    addPart(document, "Leg.L", ellipse({50, 0}, 20, 40));
    addPart(document, "Leg", ellipse({50, 0}, 20, 40), 0, Plane{{1, 0, 0}, 0});
    Workshop workshop;
    return uniqueNames(Assembly(document, workshop).parts);
  }();
  CHECK(std::set<std::string>(tricky.begin(), tricky.end()).size() == 3);
}

TEST_CASE("names: hostile names and ids leave the rig's unique", "[rig]") {
  const std::vector<std::string> hostile = {"",      "Leg",  "Leg.L", "Leg.L.1", "Leg.B1",
                                            "Leg 2", "a/n0", "/",     "Leg.1",   "Leg.2_17"};
  Random random(31);
  for (int run = 0; run < 40; ++run) {
    Workshop workshop;
    Document document = randomCreature(random, 8);
    std::set<std::string> ids;
    for (auto& part : document.parts) {
      auto source = std::make_shared<PartSource>(*part);
      source->name = hostile[static_cast<size_t>(random.below(static_cast<int>(hostile.size())))];
      const char* ends[] = {"", "/", "/n0", "/b0.3", "//"};
      source->id = "p" + std::string(ends[random.below(5)]);
      while (!ids.insert(source->id).second) source->id += random.below(2) ? "/" : "n0";
      part = source;
    }
    const Assembly creature(document, workshop);
    CHECK(faultOf(creature.rig(), creature) == "");
    CHECK(faultOf(creature.rig(thresholds(0, 0, 0, 0)), creature) == "");
  }
}

}  // namespace marrow
