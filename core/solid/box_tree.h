// Which of many boxes meet each other.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/box.h"

namespace marrow {

/// A binary tree over boxes in the order of a space-filling curve.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box3> boxes);

  /// Of all boxes.
  const Box3& box() const { return nodes_[1]; }

  /// Calls visit(i, j) for each box i of this and j of the other tree that meet.
  template <typename Visit>
  void pairs(const BoxTree& other, const Visit& visit) const {
    std::vector<std::pair<uint32_t, uint32_t>> stack = {{1, 1}};
    while (!stack.empty()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      if (!nodes_[a].meets(other.nodes_[b])) continue;
      const bool a_ends = a >= leaves_, b_ends = b >= other.leaves_;
      if (a_ends && b_ends) {
        leafPairs(other, a, b, visit);
      } else if (a_ends) {
        stack.push_back({a, 2 * b});
        stack.push_back({a, 2 * b + 1});
      } else if (b_ends) {
        stack.push_back({2 * a, b});
        stack.push_back({2 * a + 1, b});
      } else {
        for (const uint32_t i : {2 * a, 2 * a + 1}) {
          for (const uint32_t j : {2 * b, 2 * b + 1}) stack.push_back({i, j});
        }
      }
    }
  }

  /// Calls visit(i, j) once for each two boxes of this tree that meet, i < j.
  template <typename Visit>
  void pairs(const Visit& visit) const {
    pairsWhile([] { return true; }, visit);
  }
  /// The same, until goes_on() is false; asked every now and then.
  template <typename GoesOn, typename Visit>
  void pairsWhile(const GoesOn& goes_on, const Visit& visit) const {
    std::vector<std::pair<uint32_t, uint32_t>> stack = {{1, 1}};
    while (!stack.empty() && goes_on()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      if (!nodes_[a].meets(nodes_[b])) continue;
      if (a >= leaves_) {
        leafPairs(*this, a, b, [&, same = a == b](uint32_t i, uint32_t j) {
          if (!same || i < j) visit(std::min(i, j), std::max(i, j));
        });
      } else if (a == b) {
        stack.push_back({2 * a, 2 * a});
        stack.push_back({2 * a, 2 * a + 1});
        stack.push_back({2 * a + 1, 2 * a + 1});
      } else {
        for (const uint32_t i : {2 * a, 2 * a + 1}) {
          for (const uint32_t j : {2 * b, 2 * b + 1}) stack.push_back({i, j});
        }
      }
    }
  }

 private:
  static constexpr uint32_t kLeafSize = 4;

  /// Without a jump for each comparison: nobody can foretell how they go.
  static bool meet(const Box3& a, const Box3& b) {
    return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
           (b.low.y <= a.high.y) & (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
  }

  template <typename Visit>
  void leafPairs(const BoxTree& other, uint32_t a, uint32_t b, const Visit& visit) const {
    const auto range = [](const BoxTree& tree, uint32_t node) {
      const size_t first = size_t{node - tree.leaves_} * kLeafSize;
      return std::make_pair(std::min(first, tree.order_.size()),
                            std::min(first + kLeafSize, tree.order_.size()));
    };
    const auto [a_first, a_end] = range(*this, a);
    const auto [b_first, b_end] = range(other, b);
    for (size_t i = a_first; i < a_end; ++i) {
      const Box3& box = boxes_[i];
      if (!meet(box, other.nodes_[b])) continue;
      for (size_t j = b_first; j < b_end; ++j) {
        if (meet(box, other.boxes_[j])) visit(order_[i], other.order_[j]);
      }
    }
  }

  std::vector<uint32_t> order_;
  std::vector<Box3> boxes_;  // in that order
  std::vector<Box3> nodes_;  // the children of k are 2k and 2k + 1, the root is 1
  uint32_t leaves_ = 1;      // a power of two; nodes from this one on are leaves
};

}  // namespace marrow
