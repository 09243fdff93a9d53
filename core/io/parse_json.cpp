#include <cmath>
#include <cstdint>
#include <utility>

#include "base/text.h"
#include "io/decimal.h"
#include "io/json.h"

namespace marrow {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Text → tree, by recursive descent; stops at the first fault. Numbers take no long way: where the
/// C library reads decimals by software, as it does in WebAssembly, they take most of the time.
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  bool parseAll(Json& tree) {
    if (text_.compare(0, 3, "\xef\xbb\xbf") == 0) at_ = 3;
    return parseValue(tree) && (skipSpace(), at_ == text_.size() || invalid());
  }
  const std::string& fault() const { return fault_; }

 private:
  bool fail(std::string sentence) {
    fault_ = std::move(sentence);
    return false;
  }
  /// What is at `at_` does not belong there.
  bool invalid() { return fail("It is not valid JSON" + place() + "."); }
  std::string place() const {
    size_t line = 1, column = 1;
    for (size_t i = 0; i < at_; ++i) {
      ++column;
      if (text_[i] != '\n') continue;
      ++line;
      column = 1;
    }
    return " (line " + std::to_string(line) + ", column " + std::to_string(column) + ")";
  }

  /// The next character, or NUL, which no text of JSON holds.
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }
  void skipSpace() {
    while (peek() == ' ' || peek() == '\n' || peek() == '\t' || peek() == '\r') ++at_;
  }

  bool parseValue(Json& into) {
    skipSpace();
    if (++values_ > kMostValues) return fail("It holds too many values.");
    switch (peek()) {
      case '{':
      case '[': {
        if (depth_ == kDeepestNesting) return fail("It is nested too deeply.");
        ++depth_;
        const bool fine = take('{') ? parseObject(into) : (++at_, parseArray(into));
        --depth_;
        return fine;
      }
      case '"': {
        std::string value;
        if (!parseString(value)) return false;
        into = std::move(value);
        return true;
      }
      case 't':
        into = true;
        return parseWord("true");
      case 'f':
        into = false;
        return parseWord("false");
      case 'n':
        into = nullptr;
        return parseWord("null");
      default:
        return parseNumber(into);
    }
  }

  bool parseWord(const char* word) {
    for (; *word != '\0'; ++word) {
      if (!take(*word)) return invalid();
    }
    return true;
  }

  bool parseObject(Json& into) {
    into = Json::object();
    skipSpace();
    if (take('}')) return true;
    for (size_t fields = 1;; ++fields) {
      if (fields > kMostFields) return fail("An object in it has too many fields.");
      skipSpace();
      std::string key;
      if (!parseString(key)) return false;
      skipSpace();
      if (!take(':')) return invalid();
      if (!parseValue(into[key])) return false;
      skipSpace();
      if (take('}')) return true;
      if (!take(',')) return invalid();
    }
  }

  bool parseArray(Json& into) {
    into = Json::array();
    auto& list = into.get_ref<Json::array_t&>();
    skipSpace();
    if (take(']')) return true;
    list.reserve(2);
    for (;;) {
      list.emplace_back();
      if (!parseValue(list.back())) return false;
      skipSpace();
      if (take(']')) return true;
      if (!take(',')) return invalid();
    }
  }

  bool parseNumber(Json& into) {
    const size_t begin = at_;
    const auto digits = [&] {
      const size_t first = at_;
      while (isDigit(peek())) ++at_;
      return at_ > first || invalid();
    };
    take('-');
    if (!take('0') && !digits()) return false;
    bool whole = true;
    if (take('.')) {
      whole = false;
      if (!digits()) return false;
    }
    if (take('e') || take('E')) {
      whole = false;
      if (!take('+')) take('-');
      if (!digits()) return false;
    }
    const std::string_view number(text_.data() + begin, at_ - begin);
    if (whole && takeWhole(number, into)) return true;
    const auto value = whole ? std::nullopt : quickDouble(number);
    if (value) {
      into = *value;
      return true;
    }
    into = Json::parse(number.begin(), number.end(), nullptr, /*allow_exceptions=*/false);
    if (into.is_number()) return true;
    --at_;
    return fail("It holds a number that is too large" + place() + ".");
  }

  /// As an integer, where 64 bits hold it.
  static bool takeWhole(std::string_view number, Json& into) {
    constexpr size_t kSurely = 18;  // digits that always fit
    const bool negative = number[0] == '-';
    if (number.size() - (negative ? 1 : 0) > kSurely) return false;
    int64_t value = 0;
    for (size_t i = negative ? 1 : 0; i < number.size(); ++i)
      value = 10 * value + (number[i] - '0');
    if (negative) {
      into = -value;
    } else {
      into = static_cast<uint64_t>(value);
    }
    return true;
  }

  bool parseString(std::string& into) {
    if (!take('"')) return invalid();
    for (;;) {
      const size_t begin = at_;
      while (at_ < text_.size() && isPlain(text_[at_])) ++at_;
      into.append(text_, begin, at_ - begin);
      if (take('"')) return true;
      const bool fine = take('\\') ? parseEscape(into) : parseMultibyte(into);
      if (!fine) return false;
    }
  }
  static bool isPlain(char c) {
    return static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x80 &&
           c != '"' && c != '\\';
  }

  bool parseEscape(std::string& into) {
    constexpr char kEscapes[] = "\"\\/bfnrt", kMeanings[] = "\"\\/\b\f\n\r\t";
    if (take('u')) return parseUnicode(into);
    for (size_t i = 0; kEscapes[i] != '\0'; ++i) {
      if (!take(kEscapes[i])) continue;
      into += kMeanings[i];
      return true;
    }
    return invalid();
  }

  bool parseHex(uint32_t& unit) {
    unit = 0;
    for (int i = 0; i < 4; ++i) {
      const char c = peek();
      uint32_t digit = 0;
      if (isDigit(c)) {
        digit = static_cast<uint32_t>(c - '0');
      } else if (c >= 'a' && c <= 'f') {
        digit = static_cast<uint32_t>(c - 'a' + 10);
      } else if (c >= 'A' && c <= 'F') {
        digit = static_cast<uint32_t>(c - 'A' + 10);
      } else {
        return invalid();
      }
      unit = 16 * unit + digit;
      ++at_;
    }
    return true;
  }

  bool parseUnicode(std::string& into) {
    uint32_t point = 0;
    if (!parseHex(point)) return false;
    if (point >= 0xdc00 && point <= 0xdfff) return invalid();
    if (point >= 0xd800 && point <= 0xdbff) {
      uint32_t low = 0;
      if (!take('\\') || !take('u')) return invalid();
      if (!parseHex(low)) return false;
      if (low < 0xdc00 || low > 0xdfff) return invalid();
      point = 0x10000 + ((point - 0xd800) << 10) + (low - 0xdc00);
    }
    const auto add = [&](uint32_t byte) { into += static_cast<char>(byte); };
    if (point < 0x80) {
      add(point);
    } else if (point < 0x800) {
      add(0xc0 | (point >> 6));
      add(0x80 | (point & 0x3f));
    } else if (point < 0x10000) {
      add(0xe0 | (point >> 12));
      add(0x80 | ((point >> 6) & 0x3f));
      add(0x80 | (point & 0x3f));
    } else {
      add(0xf0 | (point >> 18));
      add(0x80 | ((point >> 12) & 0x3f));
      add(0x80 | ((point >> 6) & 0x3f));
      add(0x80 | (point & 0x3f));
    }
    return true;
  }

  bool parseMultibyte(std::string& into) {
    const size_t length = characterLength(std::string_view(text_).substr(at_));
    if (length < 2) return invalid();
    into.append(text_, at_, length);
    at_ += length;
    return true;
  }

  const std::string& text_;
  std::string fault_;
  size_t at_ = 0, values_ = 0, depth_ = 0;
};

}  // namespace

Result<Json> parseJson(const std::string& text) {
  if (text.empty()) return {Status::unreadable, "It is empty."};
  if (text.size() > kLargestText) return {Status::unreadable, "It is larger than 64 MB."};
  Json tree;
  Parser parser(text);
  if (!parser.parseAll(tree)) return {Status::unreadable, parser.fault()};
  return tree;
}

}  // namespace marrow
