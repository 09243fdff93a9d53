// The commands of the command line; each returns the program's exit code.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.h"
#include "document/evaluation.h"

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
/// The same of what is not as it was asked for, but no reason to stop.
void warn(const std::string& fault);

constexpr Range kBlend = {0, Document::kLargestBlend};  // of --blend

/// Whether all joints and meshes are somewhere.
bool isFinite(const Evaluation& character);

/// Milliseconds from any fixed moment.
double milliseconds();

}  // namespace marrow
