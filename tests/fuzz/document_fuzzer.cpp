// Any bytes are an error in one sentence or a sound document, which is written and read again to
// the same bytes; and they are JSON where nlohmann/json says so.
#include <cstdint>

#include "fuzz/check.h"
#include "io/document_json.h"
#include "io/json.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

void compareParsers(const std::string& text) {
  if (text.find('\0') != std::string::npos) return;  // to them the end of the text
  const auto ours = parseJson(text);
  const Json theirs = Json::parse(text, nullptr, false);
  if (ours) {
    check(!theirs.is_discarded(), "what we read is JSON");
    check(toText(*ours) == toText(theirs), "we read what they read");
    return;
  }
  const bool limit = ours.message().find("too many") != std::string::npos ||
                     ours.message().find("too deeply") != std::string::npos;
  check(limit || theirs.is_discarded(), "what we refuse is no JSON: " + ours.message());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (!text.empty()) compareParsers(text);
  const auto document = readDocument(text);
  if (document) {
    check(faultOf(*document).empty(), "sound: " + faultOf(*document));
    return 0;
  }
  const Status status = document.status();
  check(status == Status::unreadable || status == Status::newerVersion, "a reader's error");
  const std::string sentence = document.message();
  check(!sentence.empty() && sentence.back() == '.', "a sentence: " + sentence);
  check(sentence.find('\n') == std::string::npos, "one line: " + sentence);
  return 0;
}
