// The commands of the command line; each returns the program's exit code.
#pragma once

#include <string>
#include <vector>

namespace marrow {

constexpr int kFine = 0;
constexpr int kRefused = 2;
constexpr size_t kLargestFile = 64u << 20;  // bytes

/// `words`: what follows the command's name.
int runPart(const std::vector<std::string>& words);
int runRig(const std::vector<std::string>& words);
int runPose(const std::vector<std::string>& words);

/// One line on stderr, whatever control characters a file's name holds. Returns kRefused.
int refuse(const std::string& fault);

/// Milliseconds from any fixed moment.
double milliseconds();

}  // namespace marrow
