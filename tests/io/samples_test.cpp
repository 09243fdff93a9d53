// The creatures of the gallery, public/samples: what a user may expect of each of them.
#include "support/samples.h"

#include <algorithm>
#include <set>

#include "document/evaluation.h"
#include "io/document_json.h"
#include "io/json.h"
#include "support/catch.h"

using namespace marrow;

namespace {

/// The way to what one tree has and the other has not, or has otherwise; empty: nothing.
std::string missing(const Json& one, const Json& other) {
  if (one.is_object()) {
    if (!other.is_object()) return "an object";
    for (const auto& item : one.items()) {
      const Json* found = field(other, item.key().c_str());
      if (!found) return item.key();
      const std::string inner = missing(item.value(), *found);
      if (!inner.empty()) return item.key() + " / " + inner;
    }
    return {};
  }
  if (one.is_array()) {
    if (!other.is_array() || one.size() != other.size()) return "a list";
    for (size_t i = 0; i < one.size(); ++i) {
      const std::string inner = missing(one[i], other[i]);
      if (!inner.empty()) return std::to_string(i) + " / " + inner;
    }
    return {};
  }
  return one == other ? "" : one.dump();
}

struct Box {
  Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};

  void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool has(Vec3 p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z &&
           p.z <= high.z;
  }
};

/// A placed part's mesh in space.
struct Solid {
  const Mesh* mesh;
  Frame frame;
  std::vector<Vec3> points;
  Box box;

  Solid(const Part& part, const Frame& where) : mesh(&part.mesh), frame(where) {
    for (Vec3 p : mesh->positions) {
      points.push_back(frame.toWorld(p));
      box.add(points.back());
    }
  }

  /// Between the front and the back over the same place in the part's plane.
  bool contains(Vec3 world) const {
    if (!box.has(world)) return false;
    const Vec3 p = frame.toLocal(world);
    for (const auto& t : mesh->triangles) {
      const Vec3 a = mesh->positions[t[0]], b = mesh->positions[t[1]], c = mesh->positions[t[2]];
      const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      if (!(area > 0)) continue;  // seen from behind
      const double u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) / area;
      const double v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      return std::fabs(p.z) < u * a.z + v * b.z + (1 - u - v) * c.z;
    }
    return false;
  }
  bool meets(const Solid& other) const {
    const auto inOther = [&](Vec3 p) { return other.contains(p); };
    const auto inThis = [&](Vec3 p) { return contains(p); };
    return std::any_of(points.begin(), points.end(), inOther) ||
           std::any_of(other.points.begin(), other.points.end(), inThis);
  }
};

std::vector<Solid> solidsOf(const Evaluation& evaluation) {
  std::vector<Solid> solids;
  for (const PlacedPart& placed : evaluation.placed()) {
    solids.emplace_back(*evaluation.parts()[placed.source].part, placed.frame);
  }
  return solids;
}

Document withoutRefinement(Document document) {
  document.refine = {};
  for (auto& part : document.parts) {
    PartSource plain = *part;
    plain.refine = {};
    plain.branches.clear();
    part = std::make_shared<const PartSource>(std::move(plain));
  }
  return document;
}

}  // namespace

TEST_CASE("samples: ten creatures or more, each with a title of its own", "[samples]") {
  REQUIRE(sampleFiles().size() >= 10);
  std::set<std::string> titles;
  for (const SampleFile& sample : sampleFiles()) {
    CAPTURE(sample.name);
    REQUIRE(sample.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") ==
            std::string::npos);
    const Json* title = field(sample.tree, "title");
    REQUIRE(title);
    REQUIRE(title->is_string());
    REQUIRE_FALSE(title->get<std::string>().empty());
    REQUIRE(titles.insert(title->get<std::string>()).second);
  }
}

TEST_CASE("samples: what is read and written again has all that the file has", "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    CAPTURE(sample.name);
    auto written = parseJson(writeDocument(sample.document));
    REQUIRE(written);
    const std::string lost = missing(sample.tree, *written);
    CAPTURE(lost);
    REQUIRE(lost.empty());
  }
}

TEST_CASE("samples: a few well named parts of light strokes, quick to load", "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    CAPTURE(sample.name);
    REQUIRE(sample.text.size() <= 25'000);
    REQUIRE(sample.document.parts.size() >= 5);
    REQUIRE(sample.document.parts.size() <= 14);
    std::set<std::string> names;
    for (size_t i = 0; i < sample.document.parts.size(); ++i) {
      const PartSource& part = *sample.document.parts[i];
      CAPTURE(part.name);
      REQUIRE(names.insert(part.name).second);
      REQUIRE(part.name != defaultPartName(i + 1));
      REQUIRE(part.stroke.size() >= 20);
      REQUIRE(part.stroke.size() <= 120);
    }
  }
}

TEST_CASE("samples: every stroke makes a shape and none crosses itself", "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    Evaluation evaluation;
    evaluation.update(sample.document);
    for (const EvaluatedPart& part : evaluation.parts()) {
      CAPTURE(sample.name, part.source->name);
      REQUIRE(part.part);
      REQUIRE_FALSE(part.part->outline.crossed_itself);
    }
  }
}

TEST_CASE("samples: all bones make one tree by themselves, and all else hangs on it", "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    for (const auto& part : sample.document.parts) {
      CAPTURE(sample.name, part->name);
      REQUIRE_FALSE((part->skeleton && part->attachment));
    }
    for (const Document& document : {sample.document, withoutRefinement(sample.document)}) {
      CAPTURE(sample.name);
      Evaluation evaluation;
      evaluation.update(document);
      const Rig& rig = evaluation.rig();
      REQUIRE(rig.roots.size() == 1);
      REQUIRE(rig.bones.size() + 1 == rig.joints.size());
      size_t with_bones = 0;
      for (const PlacedPart& placed : evaluation.placed()) {
        if (document.parts[placed.source]->skeleton) ++with_bones;
      }
      REQUIRE(rig.carried.size() + with_bones == evaluation.placed().size());
      for (const auto& [part, joint] : rig.carried) {
        CAPTURE(evaluation.placed()[part].id);
        REQUIRE(joint >= 0);
      }
    }
    Evaluation evaluation;
    evaluation.update(sample.document);
    CAPTURE(sample.name);
    REQUIRE(evaluation.rig().joints.size() >= 10);
    REQUIRE(evaluation.rig().joints.size() <= 60);
  }
}

TEST_CASE("samples: nothing floats, all solids are one heap", "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    Evaluation evaluation;
    evaluation.update(sample.document);
    const std::vector<Solid> solids = solidsOf(evaluation);
    std::vector<size_t> reached{0};
    std::vector<char> is_reached(solids.size());
    is_reached[0] = true;
    for (size_t next = 0; next < reached.size(); ++next) {
      for (size_t i = 0; i < solids.size(); ++i) {
        if (is_reached[i] || !solids[reached[next]].meets(solids[i])) continue;
        is_reached[i] = true;
        reached.push_back(i);
      }
    }
    for (size_t i = 0; i < solids.size(); ++i) {
      const PlacedPart& placed = evaluation.placed()[i];
      CAPTURE(sample.name, sample.document.parts[placed.source]->name, placed.twin);
      REQUIRE(is_reached[i]);
    }
  }
}

TEST_CASE("samples: twins have the same bones, seen in the mirror", "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    Evaluation evaluation;
    evaluation.update(sample.document);
    std::vector<std::vector<Vec3>> joints(evaluation.placed().size());
    for (const Rig::Joint& joint : evaluation.rig().joints) {
      joints[joint.part].push_back(joint.position);
    }
    for (uint32_t i = 0; i < evaluation.placed().size(); ++i) {
      const PlacedPart& placed = evaluation.placed()[i];
      if (!placed.twin) continue;
      const PartSource& part = *sample.document.parts[placed.source];
      CAPTURE(sample.name, part.name);
      REQUIRE(joints[i].size() == joints[i - 1].size());
      for (const Vec3 p : joints[i - 1]) {
        const Vec3 image = mirrored(p, *part.mirror);
        REQUIRE(std::any_of(joints[i].begin(), joints[i].end(),
                            [&](Vec3 q) { return distance(q, image) < 1e-6; }));
      }
    }
  }
}

TEST_CASE("samples: of a size to work with, standing on the ground, round from every side",
          "[samples]") {
  for (const SampleFile& sample : sampleFiles()) {
    CAPTURE(sample.name);
    Evaluation evaluation;
    evaluation.update(sample.document);
    Box box;
    for (const Solid& solid : solidsOf(evaluation)) {
      for (const Vec3 p : solid.points) box.add(p);
    }
    const Vec3 size = box.high - box.low;
    const double largest = std::max({size.x, size.y, size.z});
    REQUIRE(largest > 250);
    REQUIRE(largest < 620);
    REQUIRE(std::min({size.x, size.y, size.z}) > 0.15 * largest);
    REQUIRE(std::fabs(box.low.x + box.high.x) < 0.3 * largest);
    REQUIRE(std::fabs(box.low.z + box.high.z) < 0.3 * largest);
    REQUIRE(box.low.y > -30);
    REQUIRE(box.low.y < 80);
  }
}
