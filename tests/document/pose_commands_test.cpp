// Poses are kept, changed, named and deleted like everything else.
#include <cmath>
#include <limits>

#include "document/command.h"
#include "io/document_json.h"
#include "support/catch.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

Document must(const Result<Document>& result) {
  REQUIRE(result);
  REQUIRE(faultOf(*result).empty());
  return *result;
}

const Pose kWave = {{"part-1/n0", {{0, 0, 0.6, 0.8}, {}}}, {"part-2/n1", {{}, {1, 2, 3}}}};

}  // namespace

TEST_CASE("poses: a pose is added at the end, or takes the place of the one of its name",
          "[poses]") {
  Document document = must(apply({}, SetPose{"Wave", kWave}));
  document = must(apply(document, SetPose{"Sit", {}}));
  REQUIRE(document.poses.size() == 2);
  REQUIRE(document.findPose("Wave")->joints == kWave);
  REQUIRE(document.findPose("wave") == nullptr);
  const Pose other = {{"part-1/n0", {{1, 0, 0, 0}, {}}}};
  document = must(apply(document, SetPose{"Wave", other}));
  REQUIRE(document.poses.size() == 2);
  REQUIRE(document.poses[0]->name == "Wave");
  REQUIRE(document.poses[0]->joints == other);
  // What changes nothing gives the same pose.
  const auto before = document.poses[0];
  REQUIRE(must(apply(document, SetPose{"Wave", other})).poses[0] == before);
}

TEST_CASE("poses: rotations become unit ones, what is none is refused", "[poses]") {
  const Document document = must(apply({}, SetPose{"Long", {{"a", {{0, 3, 0, 4}, {}}}}}));
  const Quaternion q = document.poses[0]->joints.at("a").rotation;
  REQUIRE(std::abs(q.y - 0.6) < 1e-15);
  REQUIRE(std::abs(q.w - 0.8) < 1e-15);
  const double huge = std::numeric_limits<double>::infinity(), none = std::nan("");
  for (const JointMotion& bad : {JointMotion{{0, 0, 0, 0}, {}}, JointMotion{{none, 0, 0, 1}, {}},
                                 JointMotion{{huge, 0, 0, 1}, {}}, JointMotion{{}, {0, 1e60, 0}},
                                 JointMotion{{}, {none, 0, 0}}}) {
    REQUIRE(apply(document, SetPose{"Bad", {{"a", bad}}}).status() == Status::noArea);
  }
  REQUIRE(apply(document, SetPose{"", {}}).status() == Status::notFound);
}

TEST_CASE("poses: they are renamed and deleted by name, fields of later versions stay", "[poses]") {
  const auto read =
      readDocument(R"({"format": "marrow", "version": 1, "poses": [{"name": "A", "mood": 1,)"
                   R"("joints": {"a": {"move": [1, 2, 3], "soft": true}}}, {"name": "B"}]})");
  Document document = must(read);
  document = must(apply(document, RenamePose{"A", "C"}));
  REQUIRE(document.findPose("A") == nullptr);
  document = must(apply(document, SetPose{"C", {{"a", {{0, 0, 1, 0}, {}}}}}));
  const std::string text = writeDocument(document);
  REQUIRE(text.find(R"({"name":"C","joints":{"a":{"rotation":[0,0,1,0],"soft":true}},"mood":1})") !=
          std::string::npos);
  REQUIRE(apply(document, RenamePose{"C", "B"}).message() == "There is a pose \"B\" already.");
  REQUIRE(apply(document, RenamePose{"A", "D"}).message() == "There is no pose \"A\".");
  REQUIRE(writeDocument(must(apply(document, RenamePose{"C", ""}))) == text);
  document = must(apply(document, DeletePose{"C"}));
  REQUIRE(document.poses.size() == 1);
  REQUIRE(apply(document, DeletePose{"C"}).status() == Status::notFound);
}

TEST_CASE("poses: a document holds so many and no more", "[poses]") {
  Document document;
  for (size_t i = 0; i < Document::kMostPoses; ++i) {
    document = *apply(document, SetPose{"Pose " + std::to_string(i), {}});
  }
  REQUIRE(apply(document, SetPose{"One more", {}}).status() == Status::tooMany);
  REQUIRE(apply(document, SetPose{"Pose 5", kWave}));
}

TEST_CASE("poses: steps are called by what they do", "[poses]") {
  const Document document = must(apply({}, SetPose{"Wave", kWave}));
  REQUIRE(describe({}, SetPose{"Wave", kWave}) == "Add pose Wave");
  REQUIRE(describe(document, SetPose{"Wave", {}}) == "Change pose Wave");
  REQUIRE(describe(document, RenamePose{"Wave", "Hello"}) == "Rename pose Wave");
  REQUIRE(describe(document, DeletePose{"Wave"}) == "Delete pose Wave");
}
