#include "solid/slivers.h"

#include <algorithm>
#include <unordered_set>
#include <utility>
#include <vector>

namespace marrow {
namespace {

constexpr double kFlat = 1e-5;  // height ÷ longest side
constexpr int kMostRounds = 20;

uint64_t edgeOf(uint32_t a, uint32_t b) {
  return static_cast<uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

class Flipping {
 public:
  explicit Flipping(Mesh& mesh) : mesh_(mesh) {}

  size_t run() {
    std::vector<uint32_t> flat;
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (isFlat(mesh_.triangles[t])) flat.push_back(t);
    }
    if (flat.empty()) return 0;
    link();
    // What is flat beside others that are may have to wait for them.
    for (int round = 0; round < kMostRounds && !flat.empty(); ++round) {
      std::vector<uint32_t> left;
      bool flipped = false;
      for (const uint32_t t : flat) {
        if (!isFlat(mesh_.triangles[t])) continue;
        const uint32_t other = flip(t);
        flipped |= other != kNone;
        if (isFlat(mesh_.triangles[t])) left.push_back(t);
        if (other != kNone && isFlat(mesh_.triangles[other])) left.push_back(other);
      }
      std::sort(left.begin(), left.end());
      left.erase(std::unique(left.begin(), left.end()), left.end());
      flat = std::move(left);
      if (!flipped) break;
    }
    return flat.size();
  }

 private:
  static constexpr uint32_t kNone = ~0u;
  using Triangle = std::array<uint32_t, 3>;

  bool isFlat(const Triangle& triangle) const {
    const Vec3 a = mesh_.positions[triangle[0]], b = mesh_.positions[triangle[1]],
               c = mesh_.positions[triangle[2]];
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    return !(length(cross(b - a, c - a)) > kFlat * longest);
  }

  void link() {
    std::vector<std::pair<uint64_t, uint32_t>> sides;
    for (uint32_t corner = 0; corner < 3 * mesh_.triangles.size(); ++corner) {
      sides.push_back({edgeOf(from(corner), to(corner)), corner});
    }
    std::sort(sides.begin(), sides.end());
    across_.assign(sides.size(), kNone);
    for (size_t i = 1; i < sides.size(); ++i) {
      edges_.insert(sides[i].first);
      if (sides[i].first != sides[i - 1].first) continue;
      across_[sides[i].second] = sides[i - 1].second;
      across_[sides[i - 1].second] = sides[i].second;
    }
  }

  // A side has the number of the corner where it begins.
  uint32_t from(uint32_t side) const { return mesh_.triangles[side / 3][side % 3]; }
  uint32_t to(uint32_t side) const { return from(nextSide(side)); }

  void join(uint32_t side, uint32_t other) {
    across_[side] = other;
    across_[other] = side;
  }

  /// The triangle on the other side of the longest one, which changed as well; kNone where nothing
  /// did.
  uint32_t flip(uint32_t t) {
    uint32_t longest = 3 * t;
    double most = -1;
    for (uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
      const Vec3 way = mesh_.positions[to(side)] - mesh_.positions[from(side)];
      if (!(dot(way, way) > most)) continue;
      most = dot(way, way);
      longest = side;
    }
    const uint32_t twin = across_[longest];
    if (twin == kNone) return kNone;
    const uint32_t a = from(longest), b = to(longest), c = to(nextSide(longest));
    const uint32_t d = to(nextSide(twin)), other = twin / 3;
    if (c == d || edges_.count(edgeOf(c, d)) > 0) return kNone;
    const bool was_flat = isFlat(mesh_.triangles[other]);
    const Triangle one{c, a, d}, two{d, b, c};
    const int flat_now = (isFlat(one) ? 1 : 0) + (isFlat(two) ? 1 : 0);
    if (flat_now > (was_flat ? 1 : 0)) return kNone;
    const uint32_t bc = across_[nextSide(longest)], ca = across_[nextSide(nextSide(longest))];
    const uint32_t ad = across_[nextSide(twin)], db = across_[nextSide(nextSide(twin))];
    edges_.erase(edgeOf(a, b));
    edges_.insert(edgeOf(c, d));
    mesh_.triangles[t] = one;
    mesh_.triangles[other] = two;
    join(3 * t, ca);
    join(3 * t + 1, ad);
    join(3 * t + 2, 3 * other + 2);
    join(3 * other, db);
    join(3 * other + 1, bc);
    return other;
  }

  Mesh& mesh_;
  std::vector<uint32_t> across_;  // by side
  std::unordered_set<uint64_t> edges_;
};

}  // namespace

size_t flipSlivers(Mesh& mesh) { return Flipping(mesh).run(); }

}  // namespace marrow
