#include "solid/close.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "base/box.h"
#include "solid/cap.h"
#include "solid/quality.h"
#include "solid/slivers.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = ~0u;
constexpr double kNear = 1e-5;     // of the model's size
constexpr double kNothing = 1e-6;  // volume ÷ area^1.5 of what encloses nothing; 0.094 for a ball
constexpr double kSmallHole = 0.05;  // of the model's size

enum class Weld { none, same, near };

/// A union of sets of numbers from 0.
class Sets {
 public:
  explicit Sets(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), uint32_t{0});
  }
  uint32_t find(uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  /// The smaller number stands for both.
  void join(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parent_;
};

Error notSolid(const char* sentence) { return {Status::notSolid, sentence}; }

double sizeOf(const Mesh& mesh) {
  Box3 box;
  for (const Vec3 p : mesh.positions) box.include(p);
  if (box.isEmpty()) return 0;
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

/// For each vertex the first one in the same place.
std::vector<uint32_t> sameAs(const std::vector<Vec3>& positions) {
  std::vector<uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  std::sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) {
    const Vec3 a = positions[i], b = positions[j];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z != b.z ? a.z < b.z : i < j;
  });
  for (size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && positions[order[k]] == positions[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

/// For each vertex the first one that is no further than `reach`, among those that stay.
std::vector<uint32_t> nearTo(const std::vector<Vec3>& positions, double reach) {
  struct Cell {
    int64_t x, y, z;
    bool operator==(const Cell& other) const {
      return x == other.x && y == other.y && z == other.z;
    }
  };
  struct Hash {
    size_t operator()(const Cell& cell) const {
      uint64_t h = 0;
      for (const int64_t c : {cell.x, cell.y, cell.z}) {
        h = (h ^ static_cast<uint64_t>(c)) * 0x9E3779B97F4A7C15u;
        h ^= h >> 29;
      }
      return static_cast<size_t>(h);
    }
  };
  // Those that stay are further apart than `reach`, so a cell holds few of them.
  std::unordered_map<Cell, std::vector<uint32_t>, Hash> cells;
  std::vector<uint32_t> first = sameAs(positions);
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (first[i] != i) {
      first[i] = first[first[i]];
      continue;
    }
    const Vec3 p = positions[i];
    const Cell own{static_cast<int64_t>(std::floor(p.x / reach)),
                   static_cast<int64_t>(std::floor(p.y / reach)),
                   static_cast<int64_t>(std::floor(p.z / reach))};
    uint32_t nearest = kNone;
    for (int64_t x = own.x - 1; x <= own.x + 1; ++x) {
      for (int64_t y = own.y - 1; y <= own.y + 1; ++y) {
        for (int64_t z = own.z - 1; z <= own.z + 1; ++z) {
          const auto found = cells.find({x, y, z});
          if (found == cells.end()) continue;
          for (const uint32_t other : found->second) {
            if (distance(positions[other], p) <= reach) nearest = std::min(nearest, other);
          }
        }
      }
    }
    if (nearest != kNone) {
      first[i] = nearest;
    } else {
      cells[own].push_back(i);
    }
  }
  return first;
}

/// A side of a triangle.
struct Side {
  uint32_t low, high;  // vertices
  uint32_t corner;     // 3 × triangle + where it begins
  bool upward;         // from the lower vertex to the higher
};

class Closing {
 public:
  Closing(const Mesh& surface, Weld weld, bool unfolds) : size_(sizeOf(surface)) {
    mesh_.positions = surface.positions;
    std::vector<uint32_t> first;
    if (weld == Weld::same) first = sameAs(surface.positions);
    if (weld == Weld::near) first = nearTo(surface.positions, kNear * size_);
    for (auto triangle : surface.triangles) {
      if (!first.empty()) {
        for (uint32_t& corner : triangle) corner = first[corner];
      }
      const auto [a, b, c] = triangle;
      if (a != b && b != c && c != a) mesh_.triangles.push_back(triangle);
    }
    dropDoubles(unfolds);
  }

  /// Whether triangles lie on each other's backs.
  bool folds() const { return folds_; }

  Result<Mesh> run(bool fills) {
    if (mesh_.triangles.empty()) return notSolid("It holds no surface.");
    if (auto error = orient()) return *error;
    splitFans();
    const auto holes = findHoles();
    if (!holes.empty() && !fills) return notSolid("It has a hole.");
    const auto edges = holes.empty() ? std::vector<std::pair<uint32_t, uint32_t>>{} : sortedEdges();
    for (const auto& hole : holes) {
      if (!fillHole(mesh_, hole, edges, kSmallHole * size_)) {
        return notSolid("It has a hole too large or too uneven to be closed by a flat cap.");
      }
    }
    keepSolids();
    if (mesh_.triangles.empty()) return notSolid("It encloses nothing.");
    const MeshReport report = inspect(mesh_);
    if (!report.closed || !report.manifold || !(report.volume > 0)) {
      return notSolid("It is no closed surface.");
    }
    return std::move(mesh_);
  }

 private:
  /// Whether the corners run as they do when sorted.
  static bool isUpward(const std::array<uint32_t, 3>& triangle) {
    const auto [a, b, c] = triangle;
    return (a < b && b < c) || (b < c && c < a) || (c < a && a < b);
  }

  void dropDoubles(bool unfolds) {
    std::vector<std::pair<std::array<uint32_t, 3>, uint32_t>> keys;
    keys.reserve(mesh_.triangles.size());
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      auto corners = mesh_.triangles[t];
      std::sort(corners.begin(), corners.end());
      keys.push_back({corners, t});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<char> doubled(mesh_.triangles.size(), 0);
    for (size_t i = 0; i < keys.size();) {
      size_t end = i + 1;
      while (end < keys.size() && keys[end].first == keys[i].first) ++end;
      size_t upward = 0;
      for (size_t k = i; k < end; ++k) upward += isUpward(mesh_.triangles[keys[k].second]) ? 1 : 0;
      const bool folded = upward > 0 && upward < end - i;
      folds_ |= folded;
      const bool none_stays = folded && unfolds && 2 * upward == end - i;
      for (size_t k = none_stays ? i : i + 1; k < end; ++k) doubled[keys[k].second] = 1;
      i = end;
    }
    size_t kept = 0;
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!doubled[t]) mesh_.triangles[kept++] = mesh_.triangles[t];
    }
    mesh_.triangles.resize(kept);
  }

  std::vector<Side> sortedSides() const {
    std::vector<Side> sides;
    sides.reserve(3 * mesh_.triangles.size());
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k, a < b});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& one, const Side& other) {
      if (one.low != other.low) return one.low < other.low;
      return one.high != other.high ? one.high < other.high : one.corner < other.corner;
    });
    return sides;
  }

  std::vector<std::pair<uint32_t, uint32_t>> sortedEdges() const {
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    for (const Side& side : sortedSides()) edges.push_back({side.low, side.high});
    return edges;
  }

  /// Turns triangles so that neighbours run along their common side in opposite directions.
  std::optional<Error> orient() {
    const std::vector<Side> sides = sortedSides();
    std::vector<uint32_t> across(3 * mesh_.triangles.size(), kNone);  // by corner: the other one
    std::vector<char> agrees(across.size(), 1);
    for (size_t i = 0; i < sides.size();) {
      size_t end = i + 1;
      while (end < sides.size() && sides[end].low == sides[i].low &&
             sides[end].high == sides[i].high) {
        ++end;
      }
      if (end - i > 2) return notSolid("More than two of its faces meet at an edge.");
      if (end - i == 2) {
        const Side &one = sides[i], &other = sides[i + 1];
        across[one.corner] = other.corner;
        across[other.corner] = one.corner;
        agrees[one.corner] = agrees[other.corner] = one.upward != other.upward;
      }
      i = end;
    }
    std::vector<char> turned(mesh_.triangles.size(), 0), seen(mesh_.triangles.size(), 0);
    std::vector<uint32_t> todo;
    for (uint32_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (seen[first]) continue;
      seen[first] = 1;
      todo.push_back(first);
      while (!todo.empty()) {
        const uint32_t t = todo.back();
        todo.pop_back();
        for (uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
          if (across[corner] == kNone) continue;
          const uint32_t other = across[corner] / 3;
          const char turn = agrees[corner] ? turned[t] : !turned[t];
          if (!seen[other]) {
            seen[other] = 1;
            turned[other] = turn;
            todo.push_back(other);
          } else if (turned[other] != turn) {
            return notSolid("Its surface has one side only, like a twisted strip.");
          }
        }
      }
    }
    for (size_t t = 0; t < turned.size(); ++t) {
      if (turned[t]) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
    }
    return std::nullopt;
  }

  /// A vertex for each fan of triangles; those that none uses go.
  void splitFans() {
    Sets fans(3 * mesh_.triangles.size());
    const std::vector<Side> sides = sortedSides();
    for (size_t i = 1; i < sides.size(); ++i) {
      const Side &one = sides[i - 1], &other = sides[i];
      if (one.low != other.low || one.high != other.high) continue;
      // One begins where the other ends.
      const auto end = [](uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
      fans.join(one.corner, end(other.corner));
      fans.join(end(one.corner), other.corner);
    }
    std::vector<uint32_t> index(3 * mesh_.triangles.size(), kNone);
    std::vector<Vec3> positions;
    for (uint32_t corner = 0; corner < index.size(); ++corner) {
      uint32_t& vertex = mesh_.triangles[corner / 3][corner % 3];
      uint32_t& number = index[fans.find(corner)];
      if (number == kNone) {
        number = static_cast<uint32_t>(positions.size());
        positions.push_back(mesh_.positions[vertex]);
      }
      vertex = number;
    }
    mesh_.positions = std::move(positions);
  }

  /// Loops of vertices, each in the direction in which its cap runs.
  std::vector<std::vector<uint32_t>> findHoles() const {
    std::vector<uint32_t> next(mesh_.positions.size(), kNone);
    const std::vector<Side> sides = sortedSides();
    for (size_t i = 0; i < sides.size(); ++i) {
      const auto same = [&](const Side& other) {
        return sides[i].low == other.low && sides[i].high == other.high;
      };
      if ((i > 0 && same(sides[i - 1])) || (i + 1 < sides.size() && same(sides[i + 1]))) continue;
      const auto [low, high, corner, upward] = sides[i];
      next[upward ? high : low] = upward ? low : high;
    }
    std::vector<std::vector<uint32_t>> holes;
    for (uint32_t first = 0; first < next.size(); ++first) {
      std::vector<uint32_t> loop;
      for (uint32_t v = first; next[v] != kNone; v = std::exchange(next[v], kNone)) {
        loop.push_back(v);
      }
      if (!loop.empty()) holes.push_back(std::move(loop));
    }
    return holes;
  }

  /// Turns each piece outward; those that enclose nothing go.
  void keepSolids() {
    Mesh kept;
    for (Mesh& piece : piecesOf(mesh_)) {
      const MeshReport report = inspect(piece);
      if (!(std::fabs(report.volume) > kNothing * report.area * std::sqrt(report.area))) continue;
      const auto offset = static_cast<uint32_t>(kept.positions.size());
      kept.positions.insert(kept.positions.end(), piece.positions.begin(), piece.positions.end());
      for (auto [a, b, c] : piece.triangles) {
        if (report.volume < 0) std::swap(b, c);
        kept.triangles.push_back({a + offset, b + offset, c + offset});
      }
    }
    mesh_ = std::move(kept);
  }

  Mesh mesh_;
  double size_;
  bool folds_ = false;
};

}  // namespace

Result<Mesh> closeSurface(const Mesh& surface) {
  // What the file says belongs together comes first: parts that touch each other are told apart.
  constexpr struct {
    Weld weld;
    bool fills;
  } kWays[] = {{Weld::none, false},
               {Weld::same, false},
               {Weld::near, false},
               {Weld::near, true},
               {Weld::same, true}};
  Error error;
  std::optional<Mesh> with_slivers;
  for (const auto& [weld, fills] : kWays) {
    if (fills && with_slivers) break;
    // A fold as thin as that is nothing; but some files hold every face a second time, turned.
    for (const bool unfolds : {true, false}) {
      Closing closing(surface, weld, unfolds);
      if (!unfolds && !closing.folds()) break;
      auto mesh = closing.run(fills);
      if (!mesh) {
        error = mesh.error();
      } else if (flipSlivers(*mesh) == 0) {
        return mesh;
      } else if (!with_slivers) {
        with_slivers = std::move(*mesh);
      }
    }
  }
  if (with_slivers) return std::move(*with_slivers);
  return error;
}

bool crossesItself(const Mesh& mesh) {
  const std::vector<Mesh> pieces = piecesOf(mesh);
  return std::any_of(pieces.begin(), pieces.end(), hasSelfIntersection);
}

std::vector<Mesh> piecesOf(const Mesh& mesh) {
  Sets sets(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(b, c);
  }
  std::vector<Mesh> pieces;
  std::vector<uint32_t> piece_of(mesh.positions.size(), kNone);
  std::vector<uint32_t> index(mesh.positions.size(), kNone);
  for (const auto& triangle : mesh.triangles) {
    uint32_t& piece = piece_of[sets.find(triangle[0])];
    if (piece == kNone) {
      piece = static_cast<uint32_t>(pieces.size());
      pieces.emplace_back();
    }
    Mesh& own = pieces[piece];
    std::array<uint32_t, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& number = index[triangle[k]];
      if (number == kNone) {
        number = static_cast<uint32_t>(own.positions.size());
        own.positions.push_back(mesh.positions[triangle[k]]);
      }
      corners[k] = number;
    }
    own.triangles.push_back(corners);
  }
  return pieces;
}

}  // namespace marrow
