#include "rig/names.h"

#include <algorithm>
#include <map>
#include <set>

namespace marrow {
namespace {

constexpr uint32_t kNone = JoinedSkeleton::kNone;
constexpr size_t kLongestName = 40;  // bytes; programs that read rigs take about 60 with the rest

/// Bytes of the UTF-8 character that begins at i; 0 where none does.
size_t characterAt(const std::string& text, size_t i) {
  const auto byte = [&](size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  const unsigned first = byte(i);
  const size_t size = first < 0x80                     ? 1
                      : first >= 0xC2 && first < 0xE0  ? 2
                      : first >= 0xE0 && first < 0xF0  ? 3
                      : first >= 0xF0 && first <= 0xF4 ? 4
                                                       : 0;
  for (size_t k = 1; k < size; ++k) {
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  }
  return size;
}

std::string sensible(const std::string& name) {
  std::string result;
  bool space = false;
  for (size_t i = 0; i < name.size();) {
    const size_t size = characterAt(name, i);
    const unsigned char first = static_cast<unsigned char>(name[i]);
    if (size == 0 || first <= ' ' || first == 0x7F) {
      space = !result.empty();
      ++i;
      continue;
    }
    if (result.size() + size + (space ? 1 : 0) > kLongestName) break;
    if (space) result += ' ';
    space = false;
    result.append(name, i, size);
    i += size;
  }
  return result.empty() ? "Part" : result;
}

std::string withSide(const std::string& name, char side) { return side ? name + '.' + side : name; }

/// "", "B", "C", … "Z", "AA", …
std::string letters(size_t index) {
  if (index == 0) return "";
  std::string text;
  for (size_t k = index + 1; k > 0; k = (k - 1) / 26) {
    text.insert(text.begin(), static_cast<char>('A' + (k - 1) % 26));
  }
  return text;
}

}  // namespace

std::vector<std::string> uniqueNames(const std::vector<RigPart>& parts) {
  std::vector<std::string> names(parts.size());
  std::set<std::string> taken;
  std::map<std::string, int> tried;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (!names[i].empty()) continue;
    // A part and its twin share a name.
    const bool pair = i + 1 < parts.size() && parts[i + 1].source == parts[i].source;
    const std::string base = sensible(parts[i].source->name);
    for (int& number = ++tried[base];; ++number) {
      const std::string name = number == 1 ? base : base + ' ' + std::to_string(number);
      names[i] = withSide(name, parts[i].placed->side);
      if (pair) names[i + 1] = withSide(name, parts[i + 1].placed->side);
      if (taken.count(names[i])) continue;
      if (pair && (taken.count(names[i + 1]) || names[i + 1] == names[i])) {
        if (names[i + 1] != names[i]) continue;
        names[i + 1] += ".twin";
        if (taken.count(names[i + 1])) continue;
      }
      break;
    }
    taken.insert(names[i]);
    if (pair) taken.insert(names[i + 1]);
  }
  return names;
}

JointNames::JointNames(const std::vector<RigPart>& parts, const JoinedSkeleton& joined,
                       const std::vector<double>& epsilons)
    : joined_(joined), first_line_(parts.size()), branch_of_(joined.nodes.size(), kNone) {
  const std::vector<std::string> names = uniqueNames(parts);
  size_t count = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    first_line_[i] = static_cast<uint32_t>(count);
    if (joined.parts[i].skeleton) count += joined.parts[i].skeleton->branches.size();
  }
  lines_.resize(count);
  for (size_t i = 0; i < parts.size(); ++i) {
    if (!joined.parts[i].skeleton) continue;
    const auto& branches = joined.parts[i].skeleton->branches;
    for (size_t b = 0; b < branches.size(); ++b) {
      auto& at = lines_[first_line_[i] + b].at;
      for (uint32_t k = 0; k < branches[b].levels.size(); ++k) {
        const bool is_end = k == 0 || k + 1 == branches[b].levels.size();
        if (is_end || isKept(branches[b].levels[k], epsilons[i])) at.push_back(k);
      }
    }
  }

  std::vector<uint32_t> visited(parts.size());  // branches of each part so far
  for (const uint32_t node : joined.order) {
    const auto& at = joined.nodes[node];
    if (at.branch != kNone) branch_of_[node] = at.branch;
    if (at.edge == kNone || joined.edges[at.edge].branch == kNone) continue;
    const auto& edge = joined.edges[at.edge];
    Line& found = lines_[first_line_[at.part] + edge.branch];
    if (!found.visited) {
      found.visited = true;
      found.prefix = names[at.part] + '.' + letters(visited[at.part]++);
      found.backwards = edge.b == at.parent;
      // The part's first node counts on the branch by which it is left.
      if (branch_of_[at.parent] == kNone) {
        branch_of_[at.parent] = edge.branch;
        found.from_start = true;
      }
    }
    if (branch_of_[node] == kNone) branch_of_[node] = edge.branch;
  }
  // What a root in the middle of a branch leaves: both its ends count, from the first.
  for (size_t node = 0; node < joined.nodes.size(); ++node) {
    const auto& at = joined.nodes[node];
    if (at.branch == kNone) continue;
    Line& on = lines_[first_line_[at.part] + at.branch];
    on.places.push_back(at.u);
    if (joined.parts[at.part].entry == node) {
      on.backwards = false;
      on.from_start = true;
    }
  }
}

uint32_t JointNames::branchOf(uint32_t node) const { return branch_of_[node]; }

std::string JointNames::ofNode(uint32_t node) const {
  const auto& at = joined_.nodes[node];
  const uint32_t branch = branch_of_[node];
  if (at.branch != kNone) return name(at.part, branch, at.u);
  const auto& shape = joined_.parts[at.part].skeleton->branches[branch];
  return name(at.part, branch, shape.joints.front() == at.joint ? 0.0 : shape.at.back());
}

std::string JointNames::ofSample(uint32_t part, uint32_t branch, uint32_t sample) const {
  return name(part, branch, sample);
}

std::string JointNames::name(uint32_t part, uint32_t branch, double u) const {
  const Line& on = line(part, branch);
  const auto& at = on.at;
  // Joints at the default threshold, and places where others hang, up to u.
  size_t number = 0;
  bool counted = false;
  const auto count = [&](double place) {
    if (on.backwards ? place < u : place > u) return;
    ++number;
    counted = counted || place == u;
  };
  auto taken = on.places.begin();
  for (const uint32_t place : at) {
    while (taken != on.places.end() && *taken < place) ++taken;
    if (taken == on.places.end() || *taken != place) count(place);
  }
  for (const double place : on.places) count(place);
  if (!on.from_start) --number;
  std::string text = on.prefix + std::to_string(number);
  if (counted) return text;
  // A joint of a finer skeleton than the default: which sample it is keeps it apart.
  const uint32_t sample = static_cast<uint32_t>(u);
  return text + '_' + std::to_string(on.backwards ? at.back() - sample : sample);
}

}  // namespace marrow
