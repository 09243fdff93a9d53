#include "solid/sides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/sets.h"

namespace marrow {
namespace {

constexpr double kSameAngle = 1e-6;  // of those below
constexpr double kFullTurn = 4;

/// Grows with the angle from x to the direction, from 0 to kFullTurn.
double angleOf(double x, double y) {
  const double sum = std::fabs(x) + std::fabs(y);
  if (!(sum > 0)) return 0;
  const double part = y / sum;
  const double angle = x < 0 ? 2 - part : part < 0 ? kFullTurn + part : part;
  return angle > kFullTurn - kSameAngle ? 0 : angle;
}

/// A side of a triangle, by its vertices.
struct Edge {
  uint32_t low, high;
  uint32_t side;
  bool upward;  // from the lower vertex to the higher
};

Edge edgeAt(const Mesh& mesh, uint32_t side) {
  const auto& triangle = mesh.triangles[side / 3];
  const uint32_t a = triangle[side % 3], b = triangle[(side + 1) % 3];
  return {std::min(a, b), std::max(a, b), side, a < b};
}

void sort(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const Edge& one, const Edge& other) {
    if (one.low != other.low) return one.low < other.low;
    return one.high != other.high ? one.high < other.high : one.side < other.side;
  });
}

/// Calls found(first, count) for the edges between the same vertices, until it gives false.
template <typename Found>
bool forEachGroup(const std::vector<Edge>& edges, const Found& found) {
  for (size_t i = 0; i < edges.size();) {
    size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low &&
           edges[end].high == edges[i].high) {
      ++end;
    }
    if (!found(&edges[i], end - i)) return false;
    i = end;
  }
  return true;
}

void pair(Across& across, uint32_t side, uint32_t other) {
  across[side] = other;
  across[other] = side;
}

/// Pairs triangles around an edge: one that a solid begins with goes with the next, which must be
/// one that it ends with. Seen along the edge, it ends with those that run upward.
bool pairAround(const Mesh& mesh, const Edge* edges, size_t count, Across& across) {
  const Vec3 low = mesh.positions[edges[0].low], way = mesh.positions[edges[0].high] - low;
  const double squared = dot(way, way);
  struct Leaf {
    double angle;
    Edge edge;
  };
  std::vector<Leaf> leaves;
  Vec3 x, y;
  for (size_t i = 0; i < count; ++i) {
    const uint32_t apex = mesh.triangles[edges[i].side / 3][(edges[i].side + 2) % 3];
    const Vec3 to = mesh.positions[apex] - low;
    const Vec3 out = to - way * (dot(to, way) / squared);
    const double size = length(out);
    if (!(size > 0)) return false;
    if (i == 0) {
      x = out / size;
      y = cross(way, x) / std::sqrt(squared);
    }
    leaves.push_back({angleOf(dot(out, x), dot(out, y)), edges[i]});
  }
  const auto bySide = [](const Leaf& one, const Leaf& other) {
    return one.edge.side < other.edge.side;
  };
  std::sort(leaves.begin(), leaves.end(), [&](const Leaf& one, const Leaf& other) {
    return one.angle != other.angle ? one.angle < other.angle : bySide(one, other);
  });
  // Where two lie on each other a solid ends there before the next begins.
  for (size_t i = 0; i < count;) {
    size_t end = i + 1;
    while (end < count && leaves[end].angle - leaves[i].angle < kSameAngle) ++end;
    std::sort(leaves.begin() + static_cast<std::ptrdiff_t>(i),
              leaves.begin() + static_cast<std::ptrdiff_t>(end),
              [&](const Leaf& one, const Leaf& other) {
                return one.edge.upward != other.edge.upward ? one.edge.upward : bySide(one, other);
              });
    i = end;
  }
  const size_t first = leaves[0].edge.upward ? 1 : 0;
  for (size_t i = 0; i < count; i += 2) {
    const Edge &begin = leaves[(first + i) % count].edge,
               &end = leaves[(first + i + 1) % count].edge;
    if (begin.upward || !end.upward) return false;
    pair(across, begin.side, end.side);
  }
  return true;
}

/// The ways along the borders.
class Borders {
 public:
  Borders(const Mesh& mesh, const Across& across) : mesh_(mesh), sets_(mesh.triangles.size()) {
    for (uint32_t side = 0; side < across.size(); ++side) {
      if (across[side] != kNoSide) sets_.join(side / 3, across[side] / 3);
    }
    for (uint32_t side = 0; side < across.size(); ++side) {
      if (across[side] != kNoSide) continue;
      const auto& triangle = mesh.triangles[side / 3];
      steps_.push_back({triangle[(side + 1) % 3], sets_.find(side / 3), triangle[side % 3]});
    }
    std::sort(steps_.begin(), steps_.end());
    used_.assign(steps_.size(), 0);
    findNormals();
  }

  std::vector<std::vector<uint32_t>> loops() {
    std::vector<std::vector<uint32_t>> found;
    std::vector<uint32_t> path;  // vertices
    std::vector<size_t> at(mesh_.positions.size(), kNone);
    for (size_t start = 0; start < steps_.size(); ++start) {
      for (size_t step = used_[start] ? kNone : start; step != kNone; step = nextOf(step)) {
        used_[step] = 1;
        at[steps_[step].from] = path.size();
        path.push_back(steps_[step].from);
        const size_t back = at[steps_[step].to];
        if (back == kNone) continue;
        const auto begin = path.begin() + static_cast<std::ptrdiff_t>(back);
        found.emplace_back(begin, path.end());
        for (const uint32_t v : found.back()) at[v] = kNone;
        path.erase(begin, path.end());
        if (path.empty()) break;
      }
    }
    return found;
  }

 private:
  static constexpr size_t kNone = ~size_t{0};

  struct Step {
    uint32_t from;
    uint32_t piece;  // of the surface, as it is joined by sides
    uint32_t to;
    bool operator<(const Step& other) const {
      if (from != other.from) return from < other.from;
      return piece != other.piece ? piece < other.piece : to < other.to;
    }
  };

  /// The steps that go on from a vertex along the same piece.
  std::pair<size_t, size_t> from(uint32_t vertex, uint32_t piece) const {
    const auto first = std::lower_bound(steps_.begin(), steps_.end(), Step{vertex, piece, 0});
    auto last = first;
    while (last != steps_.end() && last->from == vertex && last->piece == piece) ++last;
    return {first - steps_.begin(), last - steps_.begin()};
  }

  /// At vertices where there is a choice.
  void findNormals() {
    for (size_t i = 1; i < steps_.size(); ++i) {
      if (steps_[i].from == steps_[i - 1].from && steps_[i].piece == steps_[i - 1].piece) {
        normals_[{steps_[i].from, steps_[i].piece}];
      }
    }
    if (normals_.empty()) return;
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [a, b, c] = mesh_.triangles[t];
      const Vec3 p = mesh_.positions[a];
      const Vec3 normal = cross(mesh_.positions[b] - p, mesh_.positions[c] - p);
      const double size = length(normal);
      if (!(size > 0)) continue;
      for (const uint32_t corner : mesh_.triangles[t]) {
        const auto found = normals_.find({corner, sets_.find(t)});
        if (found != normals_.end()) found->second = found->second + normal / size;
      }
    }
  }

  /// The step along the same hole: the first one clockwise from the way back.
  size_t nextOf(size_t step) {
    const Step& come = steps_[step];
    const auto [first, last] = from(come.to, come.piece);
    const auto normal = normals_.find({come.to, come.piece});
    Vec3 back = mesh_.positions[come.from] - mesh_.positions[come.to], right;
    if (normal != normals_.end()) right = cross(back, normal->second);
    const double along = length(back), across = length(right);
    size_t best = kNone;
    double least = 0;
    for (size_t i = first; i < last; ++i) {
      if (used_[i]) continue;
      const Vec3 way = mesh_.positions[steps_[i].to] - mesh_.positions[come.to];
      const bool turns = along > 0 && across > 0;
      // `back` leans on the normal: its part across it is as long as `right` is.
      const Vec3 flat = turns ? cross(normal->second, right) / across : Vec3{};
      const double angle =
          turns ? angleOf(dot(way, flat) / length(flat), dot(way, right) / across) : 0;
      if (best != kNone && !(angle < least)) continue;
      best = i;
      least = angle;
    }
    return best;
  }

  const Mesh& mesh_;
  Sets sets_;                // of triangles
  std::vector<Step> steps_;  // sorted
  std::vector<char> used_;
  std::map<std::pair<uint32_t, uint32_t>, Vec3> normals_;  // of a vertex on a piece; any length
};

}  // namespace

std::optional<Across> pairSides(const Mesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (uint32_t side = 0; side < 3 * mesh.triangles.size(); ++side) {
    edges.push_back(edgeAt(mesh, side));
  }
  sort(edges);
  Across across(edges.size(), kNoSide);
  const bool paired = forEachGroup(edges, [&](const Edge* group, size_t count) {
    if (count == 2) pair(across, group[0].side, group[1].side);
    if (count <= 2) return true;
    return count % 2 == 0 && pairAround(mesh, group, count, across);
  });
  if (!paired) return std::nullopt;
  return across;
}

bool pairAdded(const Mesh& mesh, Across& across) {
  across.resize(3 * mesh.triangles.size(), kNoSide);
  std::vector<Edge> edges;
  for (uint32_t side = 0; side < across.size(); ++side) {
    if (across[side] == kNoSide) edges.push_back(edgeAt(mesh, side));
  }
  sort(edges);
  return forEachGroup(edges, [&](const Edge* group, size_t count) {
    if (count != 2 || group[0].upward == group[1].upward) return false;
    pair(across, group[0].side, group[1].side);
    return true;
  });
}

std::vector<std::vector<uint32_t>> borderLoops(const Mesh& mesh, const Across& across) {
  return Borders(mesh, across).loops();
}

}  // namespace marrow
