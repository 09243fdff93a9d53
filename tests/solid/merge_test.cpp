// The union of solids in easy, hard and hostile positions.
#include "solid/merge.h"

#include <cmath>
#include <set>

#include "document/evaluation.h"
#include "part/part.h"
#include "solid/quality.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/samples.h"

using namespace marrow;

namespace {

/// What holds for every union, wherever the solids are.
SolidReport checkSound(const MergedMesh& merged) {
  const SolidReport report = inspectSolid(merged.mesh);
  CHECK(report.closed);
  CHECK(report.manifold);
  CHECK(report.self_intersections == 0);
  CHECK(merged.self_intersections == 0);
  CHECK(visibleCrossings(merged.mesh) == 0);
  CHECK(report.volume > 0);
  CHECK(merged.part_of_triangle.size() == merged.mesh.triangles.size());
  CHECK(merged.corner_normals.size() == merged.mesh.triangles.size());
  CHECK(merged.on_seam.size() == merged.mesh.positions.size());
  return report;
}

SolidReport checkUnion(const std::vector<Mesh>& meshes) {
  const MergedMesh all = merged(meshes);
  CHECK(all.left_out.empty());
  return checkSound(all);
}

Mesh partMesh(Random& random) {
  const auto part = buildPart(blobOutline(random, 40, 4, 0.4), previewOptions());
  REQUIRE(part);
  return part->mesh;
}

std::vector<SolidInput> visibleSolids(const Evaluation& evaluation) {
  std::vector<SolidInput> solids;
  for (uint32_t i = 0; i < evaluation.placed().size(); ++i) {
    const PlacedPart& placed = evaluation.placed()[i];
    const EvaluatedPart& part = evaluation.parts()[placed.source];
    if (part.part && part.source->visible) solids.push_back({&part.part->mesh, placed.frame, i});
  }
  return solids;
}

bool sameBits(const MergedMesh& a, const MergedMesh& b) {
  return a.mesh.positions == b.mesh.positions && a.mesh.triangles == b.mesh.triangles &&
         a.part_of_triangle == b.part_of_triangle && a.corner_normals == b.corner_normals;
}

const Mesh kBox = boxMesh({0, 0, 0}, {1, 1, 1});

}  // namespace

TEST_CASE("merge: what these tests look for in a union is found where nothing was merged") {
  Random random(10);
  const Mesh part = partMesh(random);
  for (const double apart : {0.3, 1e-2, 1e-4}) {
    INFO("apart by " << apart);
    Mesh two = part;
    for (const Vec3 p : part.positions) {
      two.positions.push_back(p + Vec3{1, 0.5, -0.25} * (100 * apart));
    }
    const uint32_t first = static_cast<uint32_t>(part.positions.size());
    for (const auto& [a, b, c] : part.triangles) {
      two.triangles.push_back({first + a, first + b, first + c});
    }
    CHECK(visibleCrossings(two) > 20);
  }
}

TEST_CASE("merge: a union of boxes has the volume of the cells they cover") {
  Random random(11);
  for (int round = 0; round < 40; ++round) {
    std::vector<Box3> boxes;
    std::vector<Mesh> meshes;
    const int count = 2 + random.below(5);
    const bool on_grid = round % 2 == 0;  // many common planes, edges and corners
    for (int i = 0; i < count; ++i) {
      Box3 box;
      const auto coordinate = [&] { return on_grid ? random.below(4) : random.between(0, 3); };
      box.include(Vec3{coordinate(), coordinate(), coordinate()});
      box.high = box.low + Vec3{1, 1, 1} * (on_grid ? 1 + random.below(2) : random.between(0.5, 2));
      boxes.push_back(box);
      meshes.push_back(boxMesh(box.low, box.high));
    }
    INFO("round " << round);
    CHECK(checkUnion(meshes).volume == Approx(unionOfBoxes(boxes)).epsilon(1e-6));
  }
}

TEST_CASE("merge: fine grids in common planes become one") {
  for (const int steps : {4, 12}) {
    for (const double shift : {0.6, 0.5, 0.25}) {
      INFO(steps << " squares along, shifted by " << shift);
      std::vector<Mesh> boxes;
      for (int i = 0; i < 8; ++i) {
        boxes.push_back(gridBoxMesh({shift * i, 0, 0}, {shift * i + 1, 1, 1}, steps));
      }
      const SolidReport report = checkUnion(boxes);
      CHECK(report.volume == Approx(1 + 7 * shift).epsilon(1e-6));
      CHECK(report.components == 1);
      CHECK(report.genus == 0);
    }
  }
}

TEST_CASE("merge: what only touches becomes one, what is apart stays apart") {
  const struct {
    Vec3 move;
    size_t components;
  } cases[] = {{{1, 0, 0}, 1},   {{1, 1, 0}, 1},       {{1, 1, 1}, 1},       {{1, 0.3, 0.2}, 1},
               {{1, 1, 0.5}, 1}, {{1.00001, 0, 0}, 2}, {{1, 1.00001, 0}, 2}, {{3, 0, 0}, 2}};
  for (const auto& [move, components] : cases) {
    INFO("moved by " << move.x << ' ' << move.y << ' ' << move.z);
    const SolidReport report = checkUnion({kBox, moved(kBox, move)});
    CHECK(report.components == components);
    CHECK(report.genus == 0);
    CHECK(report.volume == Approx(2).epsilon(1e-7));
  }
}

TEST_CASE("merge: copies, however many and however nearly the same, are one") {
  Random random(12);
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 3), part = partMesh(random);
  for (const Mesh* mesh : {&kBox, &ball, &part}) {
    const SolidReport one = inspectSolid(*mesh);
    const double size = mesh == &part ? 100 : 1;
    for (const double apart : {0.0, 1e-16, 1e-15, 1e-13, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7}) {
      INFO(mesh->positions.size() << " vertices, apart by " << apart);
      const Vec3 move = Vec3{1, 0.5, -0.25} * (apart * size);
      const SolidReport report = checkUnion({*mesh, moved(*mesh, move), moved(*mesh, move * -0.7)});
      CHECK(report.components == 1);
      CHECK(report.genus == 0);
      CHECK(report.volume == Approx(one.volume).epsilon(1e-6));
      CHECK(report.area == Approx(one.area).epsilon(1e-4));  // thin pleats
    }
  }
}

TEST_CASE("merge: copies in the same place are merged but once, and the last one is seen") {
  Random random(13);
  const Mesh part = partMesh(random), other = moved(part, {30, 10, 5});
  // Also where they are meshes of their own.
  std::vector<Mesh> copies(300, part);
  std::vector<SolidInput> inputs;
  for (const Mesh& copy : copies) {
    inputs.push_back({&copy, {}, static_cast<uint32_t>(inputs.size())});
  }
  inputs.push_back({&other, {}, 300});
  const MergedMesh many = mergeSolids(inputs);
  CHECK(many.left_out.empty());
  CHECK(many.distinct == 2);
  CHECK(many.pairs == 1);
  checkSound(many);
  const MergedMesh two = mergeSolids({{&part, {}, 299}, {&other, {}, 300}});
  CHECK(two.distinct == 2);
  CHECK(sameBits(many, two));
  // Elsewhere, or turned over, it is another one.
  Frame turned;
  turned.y = -turned.y;
  CHECK(mergeSolids({{&part, {}, 0}, {&part, turned, 1}, {&part, {}, 2}}).distinct == 2);
}

TEST_CASE("merge: a body that is placed often is looked at once, and merged wherever it is") {
  Random random(14);
  const Mesh part = partMesh(random), same = part;
  std::vector<SolidInput> inputs;
  std::vector<Mesh> placed;
  for (uint32_t i = 0; i < 24; ++i) {
    Frame frame;
    frame.origin = {70.0 * i, 9.0 * (i % 3), 4.0 * (i % 5)};
    if (i % 4 == 1) frame = {frame.origin, {0, 1.5, 0}, {-1.5, 0, 0}};
    if (i % 4 == 2) frame.y = -frame.y;
    inputs.push_back({i % 2 ? &part : &same, frame, i});
    placed.push_back(mapped(part, [&](Vec3 p) { return frame.toWorld(p); }));
  }
  const MergedMesh all = mergeSolids(inputs), one_by_one = merged(placed);
  CHECK(all.shapes == 1);
  CHECK(one_by_one.shapes == 24);
  CHECK(all.distinct == 24);
  const SolidReport report = checkSound(all), expected = checkSound(one_by_one);
  CHECK(all.crossings == one_by_one.crossings);
  CHECK(report.volume == Approx(expected.volume).epsilon(1e-7));
  CHECK(report.area == Approx(expected.area).epsilon(1e-5));
  CHECK(report.components == expected.components);
  for (size_t t = 0; t < all.mesh.triangles.size(); ++t) {
    for (const Vec3 normal : all.corner_normals[t]) {
      if (std::abs(length(normal) - 1) > 1e-12) FAIL("a normal of triangle " << t);
    }
  }
}

TEST_CASE("merge: of a chain each link is tested against its neighbours alone") {
  const auto chain = [](uint32_t links) {
    const Mesh ball = sphereMesh({0, 0, 0}, 1, 3);
    std::vector<SolidInput> inputs;
    for (uint32_t i = 0; i < links; ++i) {
      inputs.push_back({&ball, {{1.8 * i, 0.01 * (i % 7), 0}, {1, 0, 0}, {0, 1, 0}}, i});
    }
    return mergeSolids(inputs);
  };
  const MergedMesh few = chain(20), many = chain(200);
  checkSound(many);
  CHECK(few.pairs == 19);
  CHECK(many.pairs == 199);
  CHECK(static_cast<double>(many.examined) < 10.6 * static_cast<double>(few.examined));
  CHECK(static_cast<double>(many.crossings) < 10.6 * static_cast<double>(few.crossings));
  // Most of a link is nobody's business.
  const size_t triangles = 200 * sphereMesh({0, 0, 0}, 1, 3).triangles.size();
  CHECK(2 * many.examined < triangles);
}

TEST_CASE("merge: what lies inside another is gone, wherever it touches from within") {
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 3);
  const auto shrunk = [&](double scale, Vec3 move) {
    return mapped(ball, [&](Vec3 p) { return p * scale + move; });
  };
  for (const Vec3 move : {Vec3{0, 0, 0}, Vec3{0.2, 0.1, 0}, Vec3{0.5, 0, 0}}) {
    const MergedMesh all = merged({ball, shrunk(0.5, move)});
    CHECK(checkSound(all).volume == Approx(signedVolume(ball)).epsilon(1e-6));
  }
  const MergedMesh nested = merged({shrunk(0.2, {}), shrunk(0.5, {}), ball});
  CHECK(std::set<uint32_t>(nested.part_of_triangle.begin(), nested.part_of_triangle.end()) ==
        std::set<uint32_t>{2});
}

TEST_CASE("merge: mirrored solids join at the mirror, also where rounding made them differ") {
  Random random(13);
  for (int round = 0; round < 12; ++round) {
    INFO("round " << round);
    const Mesh part = mapped(partMesh(random), randomSimilarity(random, 0));
    const int at = random.below(static_cast<int>(part.positions.size()));
    const Plane plane = randomPlane(random, part.positions[static_cast<size_t>(at)]);
    const Mesh twin = mapped(part, [&](Vec3 p) { return mirrored(p, plane); });
    const Mesh back = mapped(twin, [&](Vec3 p) { return mirrored(p, plane); });
    const SolidReport two = checkUnion({part, twin});
    CHECK(two.components == 1);
    CHECK(two.volume > std::fabs(signedVolume(part)));
    const SolidReport four = checkUnion({part, twin, back, twin});
    CHECK(four.volume == Approx(two.volume).epsilon(1e-6));
    CHECK(four.genus == two.genus);
  }
}

TEST_CASE("merge: solids shifted by the steps of their own lattice are no harder") {
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 3), ring = torusMesh({0, 0, 0}, 2, 0.5, 24, 12);
  for (const double step : {2.0, 1.0, 0.5, 0.25, 0.125}) {
    INFO("step " << step);
    checkUnion({ball, moved(ball, {step, 0, 0}), moved(ball, {0, step, 0}),
                moved(ball, {step, step, 0}), moved(ball, {0, 0, step})});
    checkUnion({ring, moved(ring, {0, 0, step})});
    checkUnion({ring, moved(ring, {step, 0, 0}), mapped(ring, [](Vec3 p) {
                  return Vec3{p.x, p.z, -p.y};
                })});
  }
  const MergedMesh links = merged({ring, mapped(ring, [](Vec3 p) {
                                     return Vec3{p.x + 2, -p.z, p.y};
                                   })});
  CHECK(checkSound(links).components == 2);
  CHECK(checkSound(links).genus == 2);
}

TEST_CASE("merge: two and three balls have the volume that their caps tell") {
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 5);
  const double all = signedVolume(ball), round = 4 * kPi / 3;
  for (const double apart : {0.3, 0.9, 1.3, 1.7}) {
    // Two caps of height 1 − apart/2.
    const double high = 1 - apart / 2, common = 2 * kPi * high * high * (3 - high) / 3;
    CHECK(checkUnion({ball, moved(ball, {apart, 0, 0})}).volume / all ==
          Approx((2 * round - common) / round).epsilon(3e-3));
  }
}

TEST_CASE("merge: order, orientation and repetition of the solids do not matter") {
  Random random(14);
  for (int round = 0; round < 6; ++round) {
    INFO("round " << round);
    std::vector<Mesh> meshes;
    for (int i = 0; i < 5; ++i) {
      Affine place = randomRotation(random);
      place.move = Vec3{random.unit(), random.unit(), random.unit()} * 80;
      meshes.push_back(mapped(partMesh(random), place));
    }
    const SolidReport first = checkUnion(meshes);
    std::vector<Mesh> other(meshes.rbegin(), meshes.rend());
    for (auto& triangle : other[1].triangles) std::swap(triangle[0], triangle[2]);
    other.push_back(meshes[2]);
    const SolidReport second = checkUnion(other);
    CHECK(second.volume == Approx(first.volume).epsilon(2e-6));
    CHECK(second.area == Approx(first.area).epsilon(1e-3));
    CHECK(second.genus == first.genus);
    CHECK(second.components == first.components);
  }
}

TEST_CASE("merge: slivers go and the volume stays") {
  Random random(15);
  size_t before = 0, after = 0;
  const auto flat = [](const Mesh& mesh) {
    size_t count = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
      const Vec3 a = mesh.positions[i], b = mesh.positions[j], c = mesh.positions[k];
      const double edges = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
      count += length(cross(b - a, c - a)) < 0.02 * edges ? 1 : 0;
    }
    return count;
  };
  for (int round = 0; round < 8; ++round) {
    std::vector<Mesh> meshes;
    for (int i = 0; i < 4; ++i) {
      Affine place = randomRotation(random);
      place.move = Vec3{random.unit(), random.unit(), random.unit()} * 80;
      meshes.push_back(mapped(partMesh(random), place));
    }
    MergeOptions raw;
    raw.collapse_slivers = false;
    const MergedMesh with = merged(meshes, raw), without = merged(meshes);
    CHECK(checkSound(without).volume == Approx(checkSound(with).volume).epsilon(2e-6));
    before += flat(with.mesh);
    after += flat(without.mesh);
  }
  INFO(before << " slivers before, " << after << " after");
  CHECK(after * 3 < before);
}

TEST_CASE("merge: corners keep the smooth normals of their own part") {
  const Mesh ball = sphereMesh({0, 0, 0}, 1, 4);
  const MergedMesh both = merged({ball, moved(ball, {1, 0.2, 0})});
  for (size_t t = 0; t < both.mesh.triangles.size(); ++t) {
    const Vec3 centre = both.part_of_triangle[t] == 0 ? Vec3{} : Vec3{1, 0.2, 0};
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 p = both.mesh.positions[both.mesh.triangles[t][i]] - centre;
      if (dot(p / length(p), both.corner_normals[t][i]) < 0.99) {
        FAIL_CHECK("triangle " << t << " corner " << i);
      }
    }
  }
}

TEST_CASE("merge: what is no solid is left out with the reason, and the rest is merged") {
  Mesh open = moved(kBox, {0.5, 0, 0});
  open.triangles.pop_back();
  Mesh wild = kBox;
  wild.triangles[0][1] = 99;
  Mesh endless = kBox;
  endless.positions[3].x = std::numeric_limits<double>::infinity();
  const Mesh flat = mapped(kBox, [](Vec3 p) { return Vec3{p.x, p.y, 0}; });
  const Mesh second = moved(kBox, {0.5, 0.5, 0.5});
  std::vector<SolidInput> inputs = {{&open, {}, 10},    {&kBox, {}, 11}, {&wild, {}, 12},
                                    {&endless, {}, 13}, {&flat, {}, 14}, {&second, {}, 15},
                                    {nullptr, {}, 16}};
  const MergedMesh rest = mergeSolids(inputs);
  CHECK(checkSound(rest).volume == Approx(1.875).epsilon(1e-7));
  std::set<uint32_t> ids;
  for (const MergedMesh::LeftOut& part : rest.left_out) {
    ids.insert(part.id);
    CHECK_FALSE(part.why.empty());
  }
  CHECK(ids == std::set<uint32_t>{10, 12, 13, 14, 16});
  CHECK(mergeSolids({}).mesh.triangles.empty());
  CHECK(mergeSolids({{&open, {}, 1}}).left_out.size() == 1);
}

TEST_CASE("merge: foreign meshes that cross or pinch themselves are left out") {
  const Mesh second = moved(kBox, {0.5, 0.5, 0.5}), far = moved(kBox, {5, 0, 0});
  const auto together = [](Mesh mesh, const Mesh& other) {
    const uint32_t base = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c] : other.triangles) {
      mesh.triangles.push_back({base + a, base + b, base + c});
    }
    return mesh;
  };
  const Mesh crossing = together(kBox, second), sound = together(second, far);
  Mesh pinched = together(kBox, moved(kBox, {1, 1, 1}));
  for (auto& triangle : pinched.triangles) {
    for (uint32_t& corner : triangle) corner = corner == 8 ? 7 : corner;  // their common corner
  }
  const MergedMesh all = mergeSolids({{&crossing, {}, 1, true},
                                      {&pinched, {}, 2, true},
                                      {&sound, {}, 3, true},
                                      {&kBox, {}, 4, true}});
  REQUIRE(all.left_out.size() == 2);
  CHECK(all.left_out[0].id == 1);
  CHECK(all.left_out[1].id == 2);
  const SolidReport report = checkSound(all);
  CHECK(report.components == 2);
  CHECK(report.volume == Approx(2.875).epsilon(1e-6));
}

TEST_CASE("merge: needles and folds as thin as rounding in a part do no harm") {
  Random random(17);
  for (int round = 0; round < 20; ++round) {
    INFO("round " << round);
    // Boxes one face of which has a point on its edge and one on its diagonal: triangles without
    // any area.
    Mesh needles = kBox;
    const auto split = [&](uint32_t a, uint32_t b, double share) {
      const uint32_t middle = static_cast<uint32_t>(needles.positions.size());
      needles.positions.push_back(lerp(needles.positions[a], needles.positions[b], share));
      const auto triangles = needles.triangles;
      needles.triangles.clear();
      for (const auto& triangle : triangles) {
        bool is_split = false;
        for (size_t i = 0; i < 3 && !is_split; ++i) {
          const uint32_t p = triangle[i], q = triangle[(i + 1) % 3], r = triangle[(i + 2) % 3];
          is_split = (p == a && q == b) || (p == b && q == a);
          if (is_split)
            needles.triangles.insert(needles.triangles.end(), {{p, middle, r}, {middle, q, r}});
        }
        if (!is_split) needles.triangles.push_back(triangle);
      }
      return middle;
    };
    const uint32_t middle = split(0, 1, random.unit());
    split(0, middle, random.unit() * 1e-9);
    split(0, 3, random.unit() * 1e-12);
    REQUIRE(isClosed(needles));
    const Vec3 move = Vec3{random.unit(), random.unit(), random.unit()} * (round % 2 ? 1.0 : 1e-12);
    const MergedMesh all = merged({needles, moved(needles, move)});
    CHECK(all.left_out.empty());
    const SolidReport report = inspectSolid(all.mesh);
    CHECK(report.closed);
    CHECK(report.manifold);
    const double common = (1 - move.x) * (1 - move.y) * (1 - move.z);
    CHECK(report.volume == Approx(2 - common).epsilon(1e-6));
  }
}

TEST_CASE("merge: a large face that many small solids pierce keeps all of them") {
  const Mesh ball = sphereMesh({0, 0, 0}, 0.3, 2);
  std::vector<Mesh> meshes = {boxMesh({0, 0, -5}, {12, 12, 0})};
  for (int i = 0; i < 11; ++i) {
    for (int j = 0; j < 11; ++j) meshes.push_back(moved(ball, {i + 1.0, j + 1.0, 0.1}));
  }
  const SolidReport report = checkUnion(meshes);
  CHECK(report.components == 1);
  CHECK(report.genus == 0);
  // A ball with a ring cut out leaves holes in the face's triangles: a handle for each.
  const Mesh ring = mapped(torusMesh({0, 0, 0}, 0.3, 0.1, 12, 8), [](Vec3 p) {
    return Vec3{p.x, p.z, p.y};
  });
  for (size_t i = 1; i < meshes.size(); ++i) {
    meshes[i] = moved(ring, meshes[i].positions[0] - ball.positions[0]);
  }
  CHECK(checkUnion(meshes).genus == 121);
}

TEST_CASE("merge: small and large models, near and far, are all the same to it") {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const double far : {0.0, 1.0, 1e3}) {
      INFO("scale " << scale << ", " << far << " sizes from the origin");
      const auto place = [&](Vec3 p) { return (p + Vec3{far, -far, far}) * scale; };
      const SolidReport report =
          checkUnion({mapped(kBox, place), mapped(moved(kBox, {0.5, 0.5, 0.5}), place),
                      mapped(moved(kBox, {1, 0, 0}), place)});
      CHECK(report.volume / (scale * scale * scale) == Approx(2.75).epsilon(1e-6));
    }
  }
}

TEST_CASE("merge: every sample becomes a solid") {
  CHECK(sampleFiles().size() >= 12);
  for (const SampleFile& sample : sampleFiles()) {
    INFO(sample.name);
    Evaluation evaluation;
    evaluation.update(sample.document);
    const std::vector<SolidInput> solids = visibleSolids(evaluation);
    const MergedMesh all = mergeSolids(solids);
    CHECK(all.left_out.empty());
    checkSound(all);
    CHECK(sameBits(all, mergeSolids(solids)));
  }
}

TEST_CASE("merge: random creatures of up to sixty parts become solids, none is lost") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    INFO("creature " << seed);
    CreatureOptions options;
    options.mirrored = 0.5;
    Evaluation evaluation(previewOptions());
    evaluation.update(randomCreature(random, seed % 10 == 0 ? 60 : 8, options));
    const MergedMesh all = mergeSolids(visibleSolids(evaluation));
    CHECK(all.left_out.empty());
    checkSound(all);
  }
}
