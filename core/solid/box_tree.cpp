#include "solid/box_tree.h"

#include <algorithm>

namespace marrow {
namespace {

/// Ten bits, two zeros after each.
uint32_t spread(uint32_t v) {
  v = (v | (v << 16)) & 0x030000FF;
  v = (v | (v << 8)) & 0x0300F00F;
  v = (v | (v << 4)) & 0x030C30C3;
  return (v | (v << 2)) & 0x09249249;
}

}  // namespace

BoxTree::BoxTree(std::vector<Box3> boxes) {
  Box3 middles;
  for (const Box3& box : boxes) middles.include(box.middle());
  const Vec3 size = middles.size();
  const double widest = std::max({size.x, size.y, size.z, 1e-300});
  std::vector<uint64_t> codes(boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 at = (boxes[i].middle() - middles.low) * (1023 / widest);
    const auto part = [](double value) {
      return spread(value > 0 ? static_cast<uint32_t>(std::min(value, 1023.0)) : 0);
    };
    const uint64_t code = part(at.x) | (part(at.y) << 1) | (part(at.z) << 2);
    codes[i] = (code << 32) | i;
  }
  std::sort(codes.begin(), codes.end());
  order_.reserve(boxes.size());
  boxes_.reserve(boxes.size());
  for (const uint64_t code : codes) {
    order_.push_back(static_cast<uint32_t>(code));
    boxes_.push_back(boxes[order_.back()]);
  }
  // They are large where trees are.
  std::vector<uint64_t>().swap(codes);
  std::vector<Box3>().swap(boxes);

  while (size_t{leaves_} * kLeafSize < boxes_.size()) leaves_ *= 2;
  nodes_.resize(2 * size_t{leaves_});
  for (size_t i = 0; i < boxes_.size(); ++i) {
    Box3& node = nodes_[leaves_ + i / kLeafSize];
    node.low = least(node.low, boxes_[i].low);
    node.high = most(node.high, boxes_[i].high);
  }
  for (size_t node = leaves_; node-- > 1;) {
    for (const size_t child : {2 * node, 2 * node + 1}) {
      nodes_[node].low = least(nodes_[node].low, nodes_[child].low);
      nodes_[node].high = most(nodes_[node].high, nodes_[child].high);
    }
  }
}

}  // namespace marrow
