// The words of a command line: one path, options with a value, and switches without one.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace marrow {

struct Range {
  double low, high;
};

/// What a command understands, by the option's name: "--json".
struct Options {
  std::string input;  // what the path is: "stroke"
  std::vector<std::string> paths;
  std::map<std::string, Range> numbers;
  std::vector<std::string> texts = {};
  std::vector<std::string> switches = {};
};

struct Arguments {
  std::string path;
  std::map<std::string, std::string> paths;
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
  std::set<std::string> switches;

  bool has(const std::string& option) const { return switches.count(option) > 0; }
  const std::string* findPath(const std::string& option) const {
    const auto found = paths.find(option);
    return found == paths.end() ? nullptr : &found->second;
  }
  std::optional<double> findNumber(const std::string& option) const {
    const auto found = numbers.find(option);
    return found == numbers.end() ? std::nullopt : std::optional<double>(found->second);
  }
};

/// `words`: what follows the command. "--json=OUT" is "--json OUT"; after "--" there are no
/// options. Errors: unreadable, with what is wrong; also where two paths lead to one file.
Result<Arguments> parseArguments(const std::vector<std::string>& words, const Options& options);

}  // namespace marrow
