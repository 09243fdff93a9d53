// The documents that tests/node/schema.test.mjs holds against the JSON Schema too.
#include <fstream>
#include <iterator>

#include "io/document_json.h"
#include "io/json.h"
#include "support/catch.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

Json load(const char* name) {
  std::ifstream file(std::string(MARROW_TEST_DATA_DIR "/documents/") + name, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  auto tree = parseJson(text);
  REQUIRE(tree);
  return *tree;
}

}  // namespace

TEST_CASE("document files: what the schema accepts is read and written again", "[document_files]") {
  const Json documents = load("good.json");
  REQUIRE(documents.size() >= 5);
  for (const auto& item : documents.items()) {
    CAPTURE(item.key());
    const auto document = readDocument(toText(item.value()));
    REQUIRE(document);
    REQUIRE(faultOf(*document).empty());
  }
}

TEST_CASE("document files: what the schema refuses is refused in one sentence",
          "[document_files]") {
  const Json documents = load("bad.json");
  REQUIRE(documents.size() >= 50);
  for (const auto& item : documents.items()) {
    CAPTURE(item.key());
    const auto document = readDocument(toText(item.value()));
    REQUIRE_FALSE(document);
    REQUIRE(document.message().back() == '.');
    REQUIRE(document.message().find('\n') == std::string::npos);
  }
}
