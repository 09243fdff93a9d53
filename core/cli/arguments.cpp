#include "cli/arguments.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "cli/files.h"

namespace marrow {
namespace {

/// A plain decimal number in the range.
std::optional<double> parseNumber(const std::string& text, Range range) {
  if (text.empty() || text.find_first_not_of("0123456789.eE+-") != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !(value >= range.low && value <= range.high)) return std::nullopt;
  return value;
}

std::string toText(Range range) {
  std::ostringstream text;
  text << range.low << " to " << range.high;
  return text.str();
}

bool isOption(const std::string& word) { return word.compare(0, 2, "--") == 0; }

std::optional<Error> sharedFile(const Arguments& arguments, const std::string& input) {
  std::vector<std::string> paths{arguments.path};
  for (const auto& [option, path] : arguments.paths) paths.push_back(path);
  for (size_t i = 0; i < paths.size(); ++i) {
    for (size_t k = i + 1; k < paths.size(); ++k) {
      if (!sameFile(paths[i], paths[k])) continue;
      return Error{Status::unreadable,
                   paths[k] + ": one file cannot be two of " + input + " and outputs"};
    }
  }
  return std::nullopt;
}

}  // namespace

Result<Arguments> parseArguments(const std::vector<std::string>& words, const Options& options) {
  const auto fault = [](const std::string& what) {
    return Error{Status::unreadable, what + " (marrow --help tells more)"};
  };
  Arguments arguments;
  bool only_paths = false, has_path = false;
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (only_paths || !isOption(word)) {
      if (has_path) return fault("one " + options.input + " at a time: " + word);
      arguments.path = word;
      has_path = true;
      continue;
    }
    if (word == "--") {
      only_paths = true;
      continue;
    }
    const size_t equals = word.find('=');
    const std::string option = word.substr(0, equals);
    std::string value;
    if (std::count(options.switches.begin(), options.switches.end(), option)) {
      if (equals != std::string::npos) return fault(option + " takes no value");
      arguments.switches.insert(option);
      continue;
    }
    if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (i + 1 < words.size() && !isOption(words[i + 1])) {
      value = words[++i];
    }
    if (std::count(options.paths.begin(), options.paths.end(), option)) {
      if (value.empty()) return fault(option + " needs a file name");
      arguments.paths[option] = value;
      continue;
    }
    if (std::count(options.texts.begin(), options.texts.end(), option)) {
      if (value.empty()) return fault(option + " needs a name");
      arguments.texts[option] = value;
      continue;
    }
    const auto range = options.numbers.find(option);
    if (range == options.numbers.end()) return fault("unknown option " + option);
    const auto number = parseNumber(value, range->second);
    if (!number) return fault(option + " needs a number from " + toText(range->second));
    arguments.numbers[option] = *number;
  }
  if (!has_path) return fault("no " + options.input + " given");
  if (auto error = sharedFile(arguments, options.input)) return *error;
  return arguments;
}

}  // namespace marrow
