// Files of the character: when they are made, what becomes of them, and how large they are.
#include "figure/file_maker.h"

#include "document/command.h"
#include "figure/workshop.h"
#include "support/catch.h"
#include "support/samples.h"

namespace marrow {
namespace {

std::string bytesOf(const std::string& content) { return toBytes(MadeFile{{"An ear."}, content}); }

FileOptions namedDog() {
  FileOptions options;
  options.name = "dog";
  return options;
}

}  // namespace

TEST_CASE("file: it travels whole, or not at all") {
  const std::string content = std::string("a\0\n{", 4) + "\xFF";
  const std::string bytes = bytesOf(content);
  const auto file = fileFromBytes(bytes);
  REQUIRE(file);
  CHECK(file->bytes == content);
  CHECK(file->left_out == std::vector<std::string>{"An ear."});
  for (size_t cut = 0; cut < bytes.size(); ++cut) CHECK_FALSE(fileFromBytes(bytes.substr(0, cut)));
  CHECK_FALSE(fileFromBytes(bytes + "x"));
  CHECK_FALSE(fileFromBytes("[]\n"));
}

TEST_CASE("file maker: a file waits for what is under way, then is made and given once") {
  FileMaker maker;
  CHECK_FALSE(maker.update(false));
  maker.ask({}, namedDog(), "dog.glb");
  CHECK(maker.waiting());
  CHECK_FALSE(maker.update(true));
  const auto order = maker.update(false);
  REQUIRE(order);
  CHECK(order->request == fileRequest({}, namedDog()));
  CHECK(order->number > FileMaker::kFirstNumber);
  CHECK(maker.working());
  CHECK_FALSE(maker.update(false));
  maker.progress(order->number, 0.25);
  CHECK(maker.done() == 0.25);
  maker.progress(order->number + 1, 0.5);
  CHECK(maker.done() == 0.25);
  maker.made(order->number, bytesOf("solid"));
  CHECK_FALSE(maker.take());  // not before its end
  maker.ended(order->number, "");
  CHECK_FALSE(maker.busy());
  const auto ready = maker.take();
  REQUIRE(ready);
  CHECK(ready->name == "dog.glb");
  CHECK(ready->bytes == "solid");
  CHECK(maker.leftOut().size() == 1);
  CHECK_FALSE(maker.take());
}

TEST_CASE("file maker: what is given up ends the work, and nothing comes of it") {
  FileMaker maker;
  maker.ask({}, namedDog(), "dog.glb");
  maker.giveUp();
  CHECK_FALSE(maker.busy());
  CHECK_FALSE(maker.update(false));

  maker.ask({}, namedDog(), "dog.glb");
  const auto order = maker.update(false);
  REQUIRE(order);
  maker.giveUp();
  maker.made(order->number, bytesOf("solid"));
  maker.ended(order->number, "");
  CHECK_FALSE(maker.take());
  const auto stop = maker.update(true);
  REQUIRE(stop);
  CHECK(stop->request.empty());
  CHECK_FALSE(maker.busy());
  CHECK_FALSE(maker.update(false));
}

TEST_CASE("file maker: another file takes the place of the one under way") {
  FileMaker maker;
  maker.ask({}, namedDog(), "dog.glb");
  const auto first = maker.update(false);
  REQUIRE(first);
  FileOptions shape = namedDog();
  shape.format = FileOptions::Format::stl;
  maker.ask({}, shape, "dog.stl");
  const auto stop = maker.update(false);
  REQUIRE(stop);
  CHECK(stop->request.empty());
  const auto second = maker.update(false);
  REQUIRE(second);
  CHECK(second->request == fileRequest({}, shape));
  maker.made(first->number, bytesOf("old"));
  maker.ended(first->number, "");
  CHECK_FALSE(maker.take());
  maker.made(second->number, bytesOf("new"));
  maker.ended(second->number, "");
  const auto ready = maker.take();
  REQUIRE(ready);
  CHECK(ready->name == "dog.stl");
  CHECK(ready->bytes == "new");
}

TEST_CASE("file maker: what fails says why until another file is asked for") {
  FileMaker maker;
  maker.ask({}, namedDog(), "dog.glb");
  const auto order = maker.update(false);
  REQUIRE(order);
  maker.ended(order->number, "No.");
  CHECK(maker.failure() == "No.");
  CHECK_FALSE(maker.busy());
  CHECK_FALSE(maker.take());
  maker.ask({}, namedDog(), "dog.glb");
  CHECK(maker.failure().empty());
  const auto again = maker.update(false);
  REQUIRE(again);
  maker.made(again->number, "half");
  maker.ended(again->number, "");
  CHECK_FALSE(maker.failure().empty());
  CHECK_FALSE(maker.take());
}

TEST_CASE("file: as high as chosen, whatever is hidden counts for nothing") {
  CHECK(shownBox(Evaluation()).isEmpty());
  CHECK(metresPerUnit({}, 1) == 0.01);
  for (const SampleFile& sample : sampleFiles()) {
    Evaluation evaluation;
    evaluation.update(sample.document);
    const Box3 box = shownBox(evaluation);
    REQUIRE_FALSE(box.isEmpty());
    CHECK(metresPerUnit(box, 0) == 0.01);
    CHECK(std::abs(metresPerUnit(box, 2) * box.size().y - 2) < 1e-9);
  }
  Document dog = sampleFiles().front().document;
  std::vector<std::string> ids;
  for (const auto& part : dog.parts) ids.push_back(part->id);
  const auto hidden = apply(dog, SetVisible{ids, false});
  REQUIRE(hidden);
  Evaluation evaluation;
  evaluation.update(*hidden);
  CHECK(shownBox(evaluation).isEmpty());
}

}  // namespace marrow
