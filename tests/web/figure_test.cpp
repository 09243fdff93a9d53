// What pose mode shows: the figure, the bytes it travels in, and when another one is asked for.
#include "figure/figure.h"

#include <array>
#include <map>

#include "document/command.h"
#include "figure/figure_keeper.h"
#include "figure/workshop.h"
#include "io/document_json.h"
#include "pose/rigs.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/samples.h"
#include "support/weight_strokes.h"
#include "weights/bodies.h"

namespace marrow {
namespace {

double noTime() { return 0; }

struct Made {
  std::vector<Figure> figures;
  std::vector<double> progress;
  Result<bool> result = false;
};

Made make(const std::string& request) {
  Made made;
  WorkTeller teller;
  teller.made = [&](const std::string& bytes) {
    auto figure = figureFromBytes(bytes);
    REQUIRE(figure);
    made.figures.push_back(std::move(*figure));
  };
  teller.progress = [&](double done) {
    made.progress.push_back(done);
    return true;
  };
  made.result = Workshop().work(request, teller, noTime);
  return made;
}

/// What work tells; it is told to stop at the given step.
struct Listener {
  std::string last;  // what was made last
  size_t steps = 0, stops_at = SIZE_MAX;

  WorkTeller teller() {
    WorkTeller teller;
    teller.made = [this](const std::string& bytes) { last = bytes; };
    teller.progress = [this](double) { return ++steps < stops_at; };
    return teller;
  }
};

const Document& sample(const std::string& name) {
  for (const SampleFile& one : sampleFiles()) {
    if (one.name == name) return one.document;
  }
  FAIL("no sample " << name);
  return sampleFiles().front().document;
}

}  // namespace

TEST_CASE("figure: a guess comes first, then the weights, of the same mesh and joints") {
  const Document& dog = sample("dog");
  const Made made = make(figureRequest(dog));
  REQUIRE(made.result);
  REQUIRE(made.figures.size() == 2);
  CHECK(made.figures[0].guessed);
  CHECK_FALSE(made.figures[1].guessed);
  CHECK(made.figures[0].vertices.size() == made.figures[1].vertices.size());
  CHECK(made.figures[0].triangles == made.figures[1].triangles);
  CHECK(std::is_sorted(made.progress.begin(), made.progress.end()));
  CHECK(made.progress.size() > 3);

  const Figure& figure = made.figures[1];
  Evaluation evaluation;
  evaluation.update(dog);
  REQUIRE(figure.joints.size() == evaluation.rig().joints.size());
  uint32_t next = 0;
  for (const Figure::Stretch& stretch : figure.stretches) {
    CHECK(stretch.first == next);
    next += stretch.count;
    CHECK(findPlaced(evaluation.placed(), stretch.part));
  }
  CHECK(next == figure.triangles.size());
  std::map<std::array<float, 3>, std::array<float, 3>> hulls;  // by the vertex's place
  for (const Figure::Vertex& vertex : figure.vertices) {
    if (hulls.try_emplace(vertex.position, vertex.hull).first->second != vertex.hull) {
      FAIL("the outline has a gap");
    }
    float sum = 0;
    for (size_t k = 0; k < vertex.weights.size(); ++k) {
      sum += vertex.weights[k];
      if (vertex.joints[k] >= figure.joints.size()) FAIL("joint " << vertex.joints[k]);
    }
    if (!(std::abs(sum - 1) < 1e-5)) FAIL("sum " << sum);
  }
}

TEST_CASE("figure: work that is told to stop comes to nothing but a guess") {
  size_t made = 0;
  WorkTeller teller;
  teller.made = [&](const std::string&) { ++made; };
  teller.progress = [](double) { return false; };
  CHECK_FALSE(Workshop().work(figureRequest(sample("dog")), teller, noTime));
  CHECK(made == 1);
}

TEST_CASE("workshop: other strokes need no new weights, and give what all anew would give") {
  Workshop workshop;
  Listener heard;
  Document dog = sample("dog");
  REQUIRE(workshop.work(figureRequest(dog), heard.teller(), noTime));
  const std::string plain = heard.last;
  CHECK(heard.steps > 3);
  auto painted = apply(dog, AddWeightStroke{strokeAtJoint(dog, 5, 40)});
  REQUIRE(painted);
  heard.steps = 0;
  REQUIRE(workshop.work(figureRequest(*painted), heard.teller(), noTime));
  CHECK(heard.steps == 0);
  CHECK(heard.last != plain);
  const std::string repainted = heard.last;
  REQUIRE(Workshop().work(figureRequest(*painted), heard.teller(), noTime));
  CHECK(heard.last == repainted);
  heard.steps = 0;
  REQUIRE(workshop.work(figureRequest(dog), heard.teller(), noTime));
  CHECK(heard.steps == 0);
  CHECK(heard.last == plain);

  FileOptions file;
  file.name = "dog";
  REQUIRE(workshop.work(fileRequest(dog, file), heard.teller(), noTime));
  CHECK(heard.steps == 0);
  const auto glb = fileFromBytes(heard.last);
  REQUIRE(glb);
  CHECK(glb->bytes.substr(0, 4) == "glTF");
}

TEST_CASE("workshop: while a stroke is painted the others are not painted again") {
  Workshop workshop;
  Listener heard;
  const Document fish = sample("fish");
  Evaluation evaluation;
  evaluation.update(fish);
  const size_t joints = evaluation.rig().joints.size();
  const auto addStroke = [&](const Document& document, size_t i) {
    WeightStroke stroke = strokeAtJoint(fish, i % joints, 30);
    stroke.points.push_back(stroke.points[0] + Vec3{2. * static_cast<double>(i), 0, 0});
    auto next = apply(document, AddWeightStroke{stroke});
    REQUIRE(next);
    return *next;
  };
  REQUIRE(workshop.work(figureRequest(fish), heard.teller(), noTime));
  const std::string plain = heard.last;
  Document painted = fish;
  for (size_t i = 0; i < 10; ++i) painted = addStroke(painted, i);
  heard.steps = 0;
  REQUIRE(workshop.work(figureRequest(painted), heard.teller(), noTime));
  CHECK(heard.steps == 9);
  for (size_t i = 0; i < 4; ++i) {
    heard.steps = 0;
    REQUIRE(workshop.work(figureRequest(addStroke(painted, i)), heard.teller(), noTime));
    CHECK(heard.steps == 0);
  }
  // Told to stop it does, and keeps the weights.
  Document more = addStroke(fish, 9);
  for (size_t i = 0; i < 10; ++i) more = addStroke(more, i);
  heard = {};
  heard.stops_at = 1;
  CHECK_FALSE(workshop.work(figureRequest(more), heard.teller(), noTime));
  CHECK(heard.last.empty());
  CHECK(heard.steps == 1);
  heard = {};
  REQUIRE(workshop.work(figureRequest(fish), heard.teller(), noTime));
  CHECK(heard.steps == 0);
  CHECK(heard.last == plain);
}

TEST_CASE("workshop: told to stop while the guess is painted, it makes nothing") {
  Document fish = sample("fish");
  const WeightStroke stroke = strokeAtJoint(fish, 1, 30);
  for (int i = 0; i < 3; ++i) fish = *apply(fish, AddWeightStroke{stroke});
  Listener heard;
  heard.stops_at = 2;
  CHECK_FALSE(Workshop().work(figureRequest(fish), heard.teller(), noTime));
  CHECK(heard.last.empty());
  CHECK(heard.steps == 2);
  // So does a file of parts, behind the weights.
  FileOptions file;
  file.parts = true;
  size_t at_end = 0;
  WorkTeller teller = heard.teller();
  teller.progress = [&](double done) { return done < 1 || ++at_end < 3; };
  CHECK_FALSE(Workshop().work(fileRequest(fish, file), teller, noTime));
  CHECK(at_end == 3);
  CHECK(heard.last.empty());
}

TEST_CASE("workshop: strokes on a body that was imported need no new weights") {
  Workshop workshop;
  Listener heard;
  const auto limb = std::make_shared<const Mesh>(
      inSinglePrecision(tube(straight({0, 0, 0}, {240, 0, 0}, 24), 15)));
  auto document = apply({}, ImportPart{limb, "Limb", {}});
  REQUIRE(document);
  REQUIRE(workshop.work(figureRequest(*document), heard.teller(), noTime));
  CHECK(heard.steps > 0);
  document = apply(*document, AddWeightStroke{strokeAtJoint(*document, 0, 30)});
  REQUIRE(document);
  heard.steps = 0;
  REQUIRE(workshop.work(figureRequest(*document), heard.teller(), noTime));
  CHECK(heard.steps == 0);
}

TEST_CASE("workshop: pictures go along only with what holds the whole drawing") {
  Document dog = sample("dog");
  Reference reference;
  reference.image =
      std::make_shared<const std::string>("data:image/png;base64," + std::string(100'000, 'A'));
  const std::string without = figureRequest(dog);
  FileOptions file;
  file.format = FileOptions::Format::obj;
  const std::string file_without = fileRequest(dog, file);
  dog.references.push_back(std::make_shared<const Reference>(reference));
  CHECK(figureRequest(dog) == without);
  CHECK(fileRequest(dog, file) == file_without);
  file.format = FileOptions::Format::glb;
  CHECK(fileRequest(dog, file).size() > 100'000);
  dog.poses.push_back(std::make_shared<const NamedPose>(NamedPose{"Sit", {{"a", {}}}}));
  CHECK(figureRequest(dog) == without);
}

TEST_CASE("workshop: where every part is left out no file is made, and the reason is said") {
  Mesh knot = sphereMesh({}, 50, 2);
  knot.positions[0] = knot.positions[0] * -1.5;  // through the other side
  const auto document = apply({}, ImportPart{std::make_shared<const Mesh>(knot), "Knot"});
  REQUIRE(document);
  WorkTeller teller;
  teller.made = [](const std::string&) { FAIL("something was made"); };
  teller.progress = [](double) { return true; };
  for (const auto format : {FileOptions::Format::glb, FileOptions::Format::obj}) {
    FileOptions file;
    file.format = format;
    const auto made = Workshop().work(fileRequest(*document, file), teller, noTime);
    REQUIRE_FALSE(made);
    CHECK(made.message().find("Knot is left out") == 0);
  }
}

TEST_CASE("workshop: every kind of file is made, and an empty drawing is refused") {
  Workshop workshop;
  std::string last;
  WorkTeller teller;
  teller.made = [&](const std::string& bytes) { last = bytes; };
  teller.progress = [](double) { return true; };
  using Format = FileOptions::Format;
  const Document& fish = sample("fish");
  for (const Format format : {Format::glb, Format::gltf, Format::obj, Format::stl, Format::ply}) {
    for (const bool parts : {false, true}) {
      FileOptions file;
      file.format = format;
      file.parts = parts;
      last.clear();
      REQUIRE(workshop.work(fileRequest(fish, file), teller, noTime));
      CHECK(last.size() > 10'000);
      CHECK_FALSE(workshop.work(fileRequest({}, file), teller, noTime));
    }
  }
}

TEST_CASE("figure: what is no drawing, or shows nothing, is refused in a sentence") {
  CHECK_FALSE(make("").result);
  CHECK_FALSE(make("{").result);
  const Made empty = make(writeDocument({}));
  CHECK_FALSE(empty.result);
  CHECK(empty.figures.empty());
  CHECK_FALSE(empty.result.message().empty());
}

TEST_CASE("figure: bytes that are cut off or too many are no figure") {
  const std::string whole = [] {
    std::string last;
    WorkTeller teller;
    teller.made = [&](const std::string& bytes) { last = bytes; };
    teller.progress = [](double) { return true; };
    REQUIRE(Workshop().work(figureRequest(sample("fish")), teller, noTime));
    return last;
  }();
  REQUIRE(figureFromBytes(whole));
  CHECK(toBytes(*figureFromBytes(whole)) == whole);
  Random random(1);
  for (int run = 0; run < 200; ++run) {
    const auto cut = static_cast<size_t>(random.between(0, static_cast<double>(whole.size())));
    CHECK_FALSE(figureFromBytes(whole.substr(0, cut)));
  }
  CHECK_FALSE(figureFromBytes(whole + "x"));
}

TEST_CASE("figure: joints that the rig no longer has follow the one above them") {
  Random random(2);
  const Rig rig = randomRig(random, 20);
  Figure figure;
  for (const Rig::Joint& joint : rig.joints) figure.joints.push_back({joint.id, joint.parent});
  Figure finer = figure;
  for (size_t i = 1; i < finer.joints.size(); i += 3) finer.joints[i].id += "gone";
  const std::vector<Rigid> motions = posed(rig, randomPose(random, rig));
  const std::vector<Rigid> same = motionsOf(figure, rig, motions);
  const std::vector<Rigid> fewer = motionsOf(finer, rig, motions);
  const Vec3 p{1, 2, 3};
  for (size_t i = 0; i < rig.joints.size(); ++i) {
    CHECK(same[i](p) == motions[i](p));
    const bool gone = i % 3 == 1;
    const int32_t above = rig.joints[i].parent;
    if (!gone) CHECK(fewer[i](p) == motions[i](p));
    if (gone && above >= 0) CHECK(fewer[i](p) == fewer[static_cast<size_t>(above)](p));
    if (gone && above < 0) CHECK(fewer[i](p) == p);
  }
}

TEST_CASE("figure: its outermost vertices reach as far as all, in any pose") {
  const Document& snail = sample("snail");
  const Made made = make(figureRequest(snail));
  REQUIRE(made.figures.size() == 2);
  const Figure& figure = made.figures[1];
  const Figure hull = outermost(figure);
  CHECK(hull.vertices.size() < 27 * (figure.joints.size() + 1));
  Evaluation evaluation;
  evaluation.update(snail);
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    Pose pose;
    for (const Rig::Joint& joint : evaluation.rig().joints) {
      const Affine turn = randomRotation(random);
      const Quaternion whole = rotationTo(turn.x, turn.y, turn.z);
      pose[joint.id].rotation = run == 0 ? Quaternion{} : mixed(Quaternion{}, whole, 0.3);
    }
    const auto motions = motionsOf(figure, evaluation.rig(), posed(evaluation.rig(), pose));
    const auto boxOfPosed = [&](const Figure& one) {
      return boxOf(posedVertices(one, motions, Skinning::linear).positions);
    };
    const Box3 all = boxOfPosed(figure), few = boxOfPosed(hull);
    const double slack = 0.03 * length(all.size());
    CHECK(distance(all.low, few.low) < slack);
    CHECK(distance(all.high, few.high) < slack);
  }
}

TEST_CASE("figure: its vertices in a pose are where skinning by its weights has them") {
  const Made made = make(figureRequest(sample("dog")));
  REQUIRE(made.result);
  Figure figure = made.figures.back();
  Evaluation evaluation;
  evaluation.update(sample("dog"));
  const Rig& rig = evaluation.rig();
  const auto unmoved =
      posedVertices(figure, motionsOf(figure, rig, posed(rig, Pose{})), Skinning::linear);
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    const auto& p = figure.vertices[i].position;
    if (distance(unmoved.positions[i], figure.origin + Vec3{p[0], p[1], p[2]}) > 1e-3) FAIL(i);
  }
  Random random(3);
  const auto motions = motionsOf(figure, rig, posed(rig, randomPose(random, rig)));
  figure.vertices[7].weights = {};
  figure.vertices[7].joints = {};
  const auto linear = posedVertices(figure, motions, Skinning::linear);
  const auto dual = posedVertices(figure, motions, Skinning::dualQuaternions);
  CHECK(distance(linear.positions[7], unmoved.positions[7]) < 1e-3);
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    const Figure::Vertex& vertex = figure.vertices[i];
    if (i == 7) continue;
    const Vec3 rest =
        figure.origin + Vec3{vertex.position[0], vertex.position[1], vertex.position[2]};
    Vec3 expected;
    for (size_t k = 0; k < VertexSkin::kMost; ++k) {
      expected = expected + motions[vertex.joints[k]](rest) * vertex.weights[k];
    }
    if (distance(linear.positions[i], expected) > 1e-3) FAIL(i);
    // What one joint holds alone moves the same either way.
    if (vertex.weights[0] == 1 && distance(linear.positions[i], dual.positions[i]) > 1e-3) FAIL(i);
  }
}

namespace {

/// A keeper and the drawing it looks at.
struct Desk {
  FigureKeeper keeper;
  Evaluation evaluation;
  Document document;
  double now_ms = 0;

  void show(const Document& next) {
    document = next;
    evaluation.update(document);
    keeper.see(document, evaluation, now_ms);
  }
  std::optional<WorkOrder> wait(double ms, bool posing = false, bool busy = false) {
    now_ms += ms;
    return keeper.update(document, busy, posing, now_ms);
  }
  /// Shows it, and the figure is made.
  void finish(const Document& next) {
    show(next);
    const auto order = wait(100, true);
    REQUIRE(order);
    keeper.made(order->number, bytes(false));
    keeper.ended(order->number, "");
  }
  std::string bytes(bool guessed) {
    Figure figure;
    figure.guessed = guessed;
    figure.vertices.resize(3);
    figure.triangles.push_back({0, 1, 2});
    return toBytes(figure);
  }
};

}  // namespace

TEST_CASE("figure keeper: work begins once the drawing has been still for a while") {
  Desk desk;
  CHECK_FALSE(desk.wait(5000));  // nothing is drawn
  desk.show(sample("dog"));
  CHECK_FALSE(desk.wait(FigureKeeper::kCalmWhilePosing_ms + 1));
  CHECK(desk.keeper.due_ms() <= FigureKeeper::kCalm_ms + 5000);
  CHECK_FALSE(desk.wait(5000, false, true));  // a hand is at work
  const auto order = desk.wait(1);
  REQUIRE(order);
  CHECK(order->request == figureRequest(desk.document));
  CHECK_FALSE(desk.wait(5000));  // once

  desk.keeper.made(order->number, desk.bytes(true));
  REQUIRE(desk.keeper.figure());
  CHECK_FALSE(desk.keeper.ready());
  desk.keeper.progress(order->number, 0.5);
  CHECK(desk.keeper.done() == 0.5);
  const uint64_t guess = desk.keeper.meshId();
  desk.keeper.made(order->number, desk.bytes(false));
  desk.keeper.ended(order->number, "");
  CHECK(desk.keeper.ready());
  CHECK(desk.keeper.meshId() != guess);
  CHECK(desk.keeper.done() == -1);
}

TEST_CASE("figure keeper: the newest drawing wins, and what an older one made is not shown") {
  Desk desk;
  desk.show(sample("dog"));
  const auto first = desk.wait(100, true);
  REQUIRE(first);
  desk.show(sample("bear"));
  const auto stop = desk.wait(1, true);
  REQUIRE(stop);
  CHECK(stop->request.empty());
  const auto second = desk.wait(100, true);
  REQUIRE(second);
  CHECK(second->number != first->number);
  desk.keeper.made(first->number, desk.bytes(false));
  CHECK_FALSE(desk.keeper.figure());
  desk.keeper.made(second->number, desk.bytes(false));
  CHECK(desk.keeper.ready());
  desk.show(sample("dog"));
  CHECK_FALSE(desk.keeper.figure());
}

TEST_CASE("figure keeper: a coarser rig keeps the old weights until its own are there") {
  Desk desk;
  desk.finish(sample("dog"));
  const uint64_t old = desk.keeper.meshId();
  Document coarser = sample("dog");
  coarser.refine.simplify = 0.3;
  desk.show(coarser);
  CHECK(desk.keeper.figure());
  CHECK_FALSE(desk.keeper.ready());
  const auto second = desk.wait(100, true);
  REQUIRE(second);
  desk.keeper.made(second->number, desk.bytes(true));
  CHECK(desk.keeper.meshId() == old);  // better than a guess
  desk.keeper.made(second->number, desk.bytes(false));
  CHECK(desk.keeper.meshId() != old);
  CHECK(desk.keeper.ready());
}

TEST_CASE("figure keeper: while seams get softer the figure of before is shown") {
  Desk desk;
  desk.finish(sample("dog"));
  auto soft = apply(desk.document, SetBlend{20});
  REQUIRE(soft);
  desk.show(*soft);
  CHECK(desk.keeper.figure());
  CHECK_FALSE(desk.keeper.ready());
  const uint64_t sharp = desk.keeper.meshId();
  const auto second = desk.wait(100, true);
  REQUIRE(second);
  desk.keeper.made(second->number, desk.bytes(true));
  CHECK(desk.keeper.meshId() != sharp);  // a guess of the new shape is better than the old one
  desk.keeper.made(second->number, desk.bytes(false));
  CHECK(desk.keeper.ready());
}

TEST_CASE("figure keeper: names, colours and poses ask for nothing") {
  Desk desk;
  desk.finish(sample("dog"));
  Document other = sample("dog");
  auto part = std::make_shared<PartSource>(*other.parts[0]);
  part->name = "Trunk";
  part->color = {1, 2, 3};
  other.parts[0] = part;
  other.poses.push_back(std::make_shared<NamedPose>());
  desk.show(other);
  CHECK_FALSE(desk.wait(5000, true));
  CHECK(desk.keeper.ready());
}

TEST_CASE("figure keeper: what fails is not tried again until the drawing changes") {
  Desk desk;
  desk.show(sample("dog"));
  const auto first = desk.wait(100, true);
  REQUIRE(first);
  desk.keeper.ended(first->number, "No.");
  CHECK(desk.keeper.failure() == "No.");
  CHECK_FALSE(desk.wait(5000, true));
  desk.show(sample("bear"));
  CHECK(desk.keeper.failure().empty());
  CHECK(desk.wait(100, true));
}

}  // namespace marrow
