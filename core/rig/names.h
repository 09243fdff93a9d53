// What the joints of a rig are called. Internal to refining.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rig/joined.h"

namespace marrow {

/// Names of joints (see Rig::Joint::name). They do not hang on thresholds. epsilons: by part, the
/// default ε_s in its plane.
class JointNames {
 public:
  JointNames(const std::vector<RigPart>& parts, const JoinedSkeleton& joined,
             const std::vector<double>& epsilons);

  /// Of a node; and the own branch of its part on which it lies.
  std::string ofNode(uint32_t node) const;
  uint32_t branchOf(uint32_t node) const;
  /// Of a sample of a branch that is no node.
  std::string ofSample(uint32_t part, uint32_t branch, uint32_t sample) const;

 private:
  /// A branch as it is counted: from the root side.
  struct Line {
    std::string prefix;  // "Leg.L.", "Body.B"
    bool visited = false;
    bool backwards = false;      // the root is on the side of its last sample
    bool from_start = false;     // its first joint counts, being no other branch's
    std::vector<double> places;  // u of the nodes on it, ascending
    std::vector<uint32_t> at;    // samples that are joints by default
  };
  const Line& line(uint32_t part, uint32_t branch) const {
    return lines_[first_line_[part] + branch];
  }
  std::string name(uint32_t part, uint32_t branch, double u) const;

  const JoinedSkeleton& joined_;
  std::vector<uint32_t> first_line_;  // by part
  std::vector<Line> lines_;
  std::vector<uint32_t> branch_of_;  // by node
};

/// The names of parts as they can stand before a joint's number: printable, of moderate length, not
/// empty, with their side, and each but once.
std::vector<std::string> uniqueNames(const std::vector<RigPart>& parts);

}  // namespace marrow
