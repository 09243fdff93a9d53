#include <cstring>
#include <nlohmann/json.hpp>

#include "io/decimal.h"
#include "io/json.h"
#include "support/catch.h"
#include "support/random.h"

using namespace marrow;

namespace {

uint64_t bitsOf(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

std::string digits(Random& random, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += static_cast<char>('0' + random.below(10));
  return text;
}

/// What nlohmann/json makes of it, or what stands for a fault.
std::string theirs(const std::string& text) {
  const Json tree = Json::parse(text, nullptr, false);
  return tree.is_discarded() ? "fault" : toText(tree);
}
std::string ours(const std::string& text) {
  const auto tree = parseJson(text);
  return tree ? toText(*tree) : "fault";
}

}  // namespace

TEST_CASE("decimal: the quick way gives the nearest double, or leaves it", "[parse_json]") {
  Random random(5);
  int quick = 0;
  for (int run = 0; run < 60000; ++run) {
    std::string text = random.below(2) ? "-" : "";
    switch (random.below(4)) {
      case 0:  // as written by us
        text += toText(toJson(random.between(0, 1000)));
        break;
      case 1:
        text += std::to_string(1 + random.below(9)) + digits(random, random.below(19)) + "." +
                digits(random, 1 + random.below(6));
        break;
      case 2:
        text += std::to_string(random.below(10)) + "." + digits(random, 1 + random.below(21)) +
                "e" + std::to_string(random.below(60) - 30);
        break;
      case 3: {  // between two doubles
        const double value = std::floor(random.between(1, 0x1p20)) * 0x1p-6;
        text += toText(toJson(value)) + (random.below(2) ? "e22" : "0e-22");
        if (text.find('.') == std::string::npos) text.insert(text.find('e'), ".0");
        break;
      }
    }
    const auto value = quickDouble(text);
    if (!value) continue;
    ++quick;
    CAPTURE(text);
    REQUIRE(bitsOf(*value) == bitsOf(Json::parse(text).get<double>()));
  }
  REQUIRE(quick > 40000);
}

TEST_CASE("decimal: halfway between two doubles is left", "[parse_json]") {
  REQUIRE_FALSE(quickDouble("9007199254740993.0"));
  REQUIRE_FALSE(quickDouble("1.00000000000000011102230246251565404"));
  REQUIRE_FALSE(quickDouble("1e23"));
  REQUIRE_FALSE(quickDouble("1e-400"));
  REQUIRE_FALSE(quickDouble("1e99999999999999999999"));
  REQUIRE(bitsOf(quickDouble("-0e99").value_or(1)) == bitsOf(-0.0));
  REQUIRE(quickDouble("0.00000000000000000000000001e26") == 1);
  REQUIRE(quickDouble("1e22") == 1e22);
}

TEST_CASE("json: texts are read as nlohmann/json reads them", "[parse_json]") {
  const std::string seeds[] = {
      R"({"a":[1,-2.5,3e2,null],"b":{"c":"d\n\"\u00e9\ud83d\ude00/"},"a":true})",
      "[0,-0,0.0,-0.0,1e5,1E+2,1.5e-7,18446744073709551615,18446744073709551616,-"
      "9223372036854775808,"
      "-9223372036854775809,1234567890123456789,9007199254740993.5]",
      " \t\r\n[ [ ] , { } , \"\" , false ]\n", "\"Größe 猫 🐈 \x7f\"",
      "[\"\xed\x9f\xbf\xee\x80\x80\xf4\x8f\xbf\xbf\xf0\x90\x80\x80\xe0\xa0\x80\xc2\x80\"]"};
  const std::string pieces[] = {"\\u",
                                "\\ud800",
                                "\\udc00",
                                "\xc0",
                                "\xed\xa0\x80",
                                "\xf5",
                                "\xf4\x90\x80\x80",
                                "\xe0\x80\x80",
                                "e",
                                ".",
                                "-",
                                "+",
                                "0",
                                "1e999",
                                "tru",
                                "nul",
                                "]",
                                "}",
                                ",",
                                ":",
                                "\"",
                                "\\",
                                "\x01",
                                "\xef\xbb\xbf",
                                "NaN",
                                "//",
                                "[",
                                "{",
                                std::string(1, '\0')};
  Random random(17);
  int fine = 0;
  for (const std::string& seed : seeds) {
    REQUIRE(ours(seed) == theirs(seed));
    REQUIRE(ours(seed) != "fault");
    for (int run = 0; run < 6000; ++run) {
      std::string text = seed;
      for (int edits = 1 + random.below(2); edits > 0; --edits) {
        const auto at = static_cast<size_t>(random.below(static_cast<int>(text.size()) + 1));
        switch (random.below(4)) {
          case 0:
            text.erase(at, 1 + static_cast<size_t>(random.below(3)));
            break;
          case 1:
            text.insert(at, pieces[random.below(static_cast<int>(std::size(pieces)))]);
            break;
          case 2:
            if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
            break;
          case 3:
            text.resize(at);
            break;
        }
      }
      if (text.empty()) continue;
      CAPTURE(text);
      // Theirs takes a NUL for the end of the text.
      const std::string expected = text.find('\0') == std::string::npos ? theirs(text) : "fault";
      REQUIRE(ours(text) == expected);
      if (expected != "fault") ++fine;
    }
  }
  REQUIRE(fine > 1000);
}
