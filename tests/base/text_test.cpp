#include "base/text.h"

#include "support/catch.h"

using namespace marrow;

TEST_CASE("text: characters of one to four bytes are told from what is no UTF-8", "[text]") {
  for (const char* one : {"a", "\x7f", "\xc2\x80", "ß", "猫", "\xed\x9f\xbf", "\xee\x80\x80", "🐈",
                          "\xf4\x8f\xbf\xbf"}) {
    CAPTURE(one);
    REQUIRE(characterLength(one) == std::string(one).size());
    REQUIRE(toUtf8(one) == one);
  }
  for (const char* one : {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xc2", "\xc2z", "\xe0\x9f\xbf",
                          "\xed\xa0\x80", "\xe7\x8c", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
                          "\xf5\x80\x80\x80", "\xf0\x9f\x90", "\xff"}) {
    CAPTURE(one);
    REQUIRE(characterLength(one) == 0);
    REQUIRE(toUtf8(one).find("\xef\xbf\xbd") == 0);
  }
  REQUIRE(characterLength("") == 0);
}

TEST_CASE("text: what is UTF-8 beside what is not is kept", "[text]") {
  REQUIRE(toUtf8("a\xffß\xc3") == "a\xef\xbf\xbdß\xef\xbf\xbd");
  REQUIRE(toUtf8("\xe7\x8c"
                 "a") ==
          "\xef\xbf\xbd\xef\xbf\xbd"
          "a");
  REQUIRE(toUtf8("").empty());
}

TEST_CASE("text: control characters become spaces, others stay", "[text]") {
  REQUIRE(onOneLine("a\nb\t\x7f ß\x01") == "a b   ß ");
}
