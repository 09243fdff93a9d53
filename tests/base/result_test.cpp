#include "base/result.h"

#include <memory>
#include <set>
#include <string>

#include "support/catch.h"

using namespace marrow;

TEST_CASE("result: holds what it was given", "[result]") {
  Result<std::string> result = std::string("seal");
  REQUIRE(result);
  CHECK(*result == "seal");
  CHECK(result->size() == 4);
  CHECK(result.status() == Status::ok);
}

TEST_CASE("result: an error says its own detail, or else the sentence of its code", "[result]") {
  const Result<int> plain = Status::noArea;
  CHECK_FALSE(plain);
  CHECK(plain.status() == Status::noArea);
  CHECK(plain.message() == toSentence(Status::noArea));

  const Result<int> detailed(Status::unreadable, "points[3] is not a pair of numbers.");
  CHECK(detailed.message() == "points[3] is not a pair of numbers.");

  const Result<double> passed_on = detailed.error();
  CHECK(passed_on.status() == Status::unreadable);
  CHECK(passed_on.message() == detailed.message());
}

TEST_CASE("result: carries values that can only be moved", "[result]") {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(7);
  REQUIRE(result);
  const std::unique_ptr<int> taken = std::move(*result);
  CHECK(*taken == 7);
}

TEST_CASE("result: every code has a sentence of its own that ends with a full stop", "[result]") {
  std::set<std::string> sentences;
  const auto last = static_cast<int>(Status::notFound);
  for (int code = 0; code <= last; ++code) {
    const std::string sentence = toSentence(static_cast<Status>(code));
    INFO(sentence);
    CHECK(sentence.back() == '.');
    CHECK(sentences.insert(sentence).second);
  }
}
