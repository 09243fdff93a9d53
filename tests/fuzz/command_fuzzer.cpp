// Any sequence of commands, hostile numbers among them: every document on the way is sound, is read
// as it was written, and comes back byte for byte by undo and redo.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "document/history.h"
#include "fuzz/check.h"
#include "support/commands.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

/// Numbers from a fuzzer's bytes; zeros behind their end.
class Bytes {
 public:
  Bytes(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  bool atEnd() const { return at_ >= size_; }
  int byte() { return at_ < size_ ? data_[at_++] : 0; }
  int below(int count) { return byte() % count; }
  double number() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr double kOdd[] = {-0.0,      1e50,       -1e50, 1.0000001e50, 1e51,     1e-50,
                                      1e-60,     1e-160,     1e160, 1.7e308,      -1.7e308, 5e-324,
                                      kInfinity, -kInfinity, 1e-9,  1e-12,        1e25,     0.05};
    constexpr int kOddCount = sizeof kOdd / sizeof kOdd[0];
    switch (byte() % 8) {
      case 0:
        return kOdd[byte() % kOddCount];
      case 1:
        return std::numeric_limits<double>::quiet_NaN();
      case 2: {  // any bits
        uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits = 256 * bits + static_cast<uint64_t>(byte());
        double value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      case 3:
        return byte() - 128;
      default:
        return (256 * byte() + byte() - 32768) / 128.;
    }
  }
  Affine map() {
    Affine map;
    switch (byte() % 4) {
      case 0:
        map.move = vector();
        return map;
      case 1: {
        Random random(static_cast<uint64_t>(byte()));
        map = randomSimilarity(random);
        return map;
      }
      case 2: {
        map.x.x = number();
        map.y.y = number();
        map.z.z = number();
        return map;
      }
      default:
        return {vector(), vector(), vector(), vector()};
    }
  }

 private:
  Vec3 vector() { return {number(), number(), number()}; }

  const uint8_t* data_;
  size_t size_, at_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  constexpr size_t kMostSteps = 30;
  Bytes bytes(data, size);
  Random random(static_cast<uint64_t>(bytes.byte()));
  History history(randomCreature(random, bytes.below(5), {12}));
  std::vector<std::string> texts{writeDocument(history.current())};
  while (!bytes.atEnd() && texts.size() < kMostSteps) {
    const Document before = history.current();
    const Command command = AnyCommand<Bytes>(bytes, before)();
    const auto next = apply(before, command);
    if (!next) {
      check(next.message().find('\n') == std::string::npos, "one line: " + next.message());
      continue;
    }
    texts.push_back(writeDocument(*next));
    const std::string fault = ruleBrokenBy(*next);
    check(fault.empty(), describe(before, command) + " gives a sound document: " + fault);
    history.push(*next, describe(before, command));
  }
  // Every document on the way is the last one of a shorter input.
  check(faultOf(history.current()).empty(), "sound: " + faultOf(history.current()));
  for (size_t i = texts.size(); i-- > 1;) {
    history.undo();
    check(writeDocument(history.current()) == texts[i - 1], "undo brings back");
  }
  check(!history.canUndo(), "all is undone");
  while (history.canRedo()) history.redo();
  check(writeDocument(history.current()) == texts.back(), "redo brings back");
  return 0;
}
