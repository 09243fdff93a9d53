#include "solid/close.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/box.h"
#include "base/sets.h"
#include "solid/cap.h"
#include "solid/quality.h"
#include "solid/sides.h"
#include "solid/slivers.h"
#include "solid/weld.h"
#include "surface/fans.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = ~0u;
constexpr double kNear = 1e-5;     // of the model's size
constexpr double kNothing = 1e-6;  // volume ÷ area^1.5 of what encloses nothing; 0.094 for a ball
constexpr double kSmallHole = 0.05;   // of the model's size
constexpr double kMain = 0.25;        // of the model's size
constexpr size_t kMostPieces = 2000;  // that are tried one by one

Error notSolid(const char* sentence) { return {Status::notSolid, sentence}; }

double sizeOf(const Mesh& mesh) {
  const Box3 box = boxOf(mesh.positions);
  if (box.isEmpty()) return 0;
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

/// Without the vertices that no triangle uses: they would tell a wrong size.
Mesh withoutUnused(const Mesh& surface) {
  Mesh mesh;
  mesh.triangles = surface.triangles;
  std::vector<uint32_t> index(surface.positions.size(), kNone);
  for (auto& triangle : mesh.triangles) {
    for (uint32_t& corner : triangle) {
      uint32_t& number = index[corner];
      if (number == kNone) {
        number = static_cast<uint32_t>(mesh.positions.size());
        mesh.positions.push_back(surface.positions[corner]);
      }
      corner = number;
    }
  }
  return mesh;
}

/// The pieces of a surface, joined by vertices that become one, each with its own ones.
std::vector<Mesh> piecesOf(const Mesh& mesh, const std::vector<uint32_t>& first) {
  Sets sets(mesh.positions.size());
  for (uint32_t v = 0; v < first.size(); ++v) sets.join(v, first[v]);
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

void append(const Mesh& piece, Mesh& mesh) {
  const auto offset = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), piece.positions.begin(), piece.positions.end());
  for (const auto& [a, b, c] : piece.triangles) {
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

/// Which vertices become one: none, those in the same place, those near each other.
class Welds {
 public:
  enum Kind { kNo, kSame, kNearly };

  Welds(const Mesh& surface, double size) : surface_(surface), size_(size) {}

  /// For each vertex the one it becomes.
  const std::vector<uint32_t>& of(Kind kind) {
    std::vector<uint32_t>& first = made_[kind];
    if (!first.empty() || surface_.positions.empty()) return first;
    if (kind == kSame) {
      first = samePlaces(surface_.positions);
    } else if (kind == kNearly && size_ > 0) {
      first = nearPlaces(surface_.positions, kNear * size_);
    } else {
      first.resize(surface_.positions.size());
      std::iota(first.begin(), first.end(), uint32_t{0});
    }
    return first;
  }

 private:
  const Mesh& surface_;
  double size_;
  std::vector<uint32_t> made_[3];
};

class Closing {
 public:
  /// first: see Welds. size: the model's.
  Closing(const Mesh& surface, const std::vector<uint32_t>& first, double size, bool unfolds)
      : size_(size) {
    mesh_.positions = surface.positions;
    for (auto triangle : surface.triangles) {
      for (uint32_t& corner : triangle) corner = first[corner];
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
    const auto holes = borderLoops(mesh_, across_);
    if (!holes.empty()) {
      if (!fills) return notSolid("It has a hole.");
      auto edges = edgesOf(mesh_);
      for (const auto& hole : holes) {
        if (!fillHole(mesh_, hole, edges, kSmallHole * size_)) {
          return notSolid("It has a hole too large or too uneven to be closed by a flat cap.");
        }
      }
      if (!pairAdded(mesh_, across_)) return notSolid("It is no closed surface.");
    }
    splitFans();
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

  /// Turns triangles so that neighbours run along their common side in opposite directions.
  std::optional<Error> orient() {
    auto across = pairSides(mesh_);
    if (!across) return notSolid("More than two of its faces meet at an edge.");
    across_ = std::move(*across);
    const auto corner = [&](uint32_t side) { return mesh_.triangles[side / 3][side % 3]; };
    std::vector<char> turned(mesh_.triangles.size(), 0), seen(mesh_.triangles.size(), 0);
    std::vector<uint32_t> todo;
    for (uint32_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (seen[first]) continue;
      seen[first] = 1;
      todo.push_back(first);
      while (!todo.empty()) {
        const uint32_t t = todo.back();
        todo.pop_back();
        for (uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
          if (across_[side] == kNoSide) continue;
          const uint32_t other = across_[side] / 3;
          const bool agrees = corner(side) != corner(across_[side]);
          const char turn = agrees ? turned[t] : !turned[t];
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
    Across now(across_.size(), kNoSide);
    const auto turnedSide = [&](uint32_t side) {  // the same two corners
      return turned[side / 3] ? side - side % 3 + (2 - side % 3) : side;
    };
    for (uint32_t side = 0; side < now.size(); ++side) {
      if (across_[side] != kNoSide) now[turnedSide(side)] = turnedSide(across_[side]);
    }
    across_ = std::move(now);
    return std::nullopt;
  }

  /// A vertex for each fan of triangles; those that none uses go.
  void splitFans() {
    Sets fans(3 * mesh_.triangles.size());  // of corners
    for (uint32_t side = 0; side < across_.size(); ++side) {
      const uint32_t other = across_[side];  // begins where the side ends
      fans.join(side, nextSide(other));
      fans.join(nextSide(side), other);
    }
    mesh_ = splitByFans(mesh_, fans);
  }

  /// Turns each piece outward; those that enclose nothing go.
  void keepSolids() {
    Mesh kept;
    for (Mesh& piece : piecesOf(mesh_)) {
      const MeshReport report = inspect(piece);
      if (!(std::fabs(report.volume) > kNothing * report.area * std::sqrt(report.area))) continue;
      if (report.volume < 0) {
        for (auto& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
      }
      append(piece, kept);
    }
    mesh_ = std::move(kept);
  }

  Mesh mesh_;
  Across across_;
  double size_;
  bool folds_ = false;
};

/// All of the surface, which has no unused vertices. size: the model's.
Result<Mesh> closeAll(const Mesh& surface, double size) {
  // What the file says belongs together comes first: parts that touch each other are told apart.
  constexpr struct {
    Welds::Kind weld;
    bool fills;
  } kWays[] = {{Welds::kNo, false},
               {Welds::kSame, false},
               {Welds::kNearly, false},
               {Welds::kNearly, true},
               {Welds::kSame, true}};
  Welds welds(surface, size);
  Error error;
  std::optional<Mesh> with_slivers;
  for (const auto& [weld, fills] : kWays) {
    if (fills && with_slivers) break;
    // A fold as thin as that is nothing; but some files hold every face a second time, turned.
    for (const bool unfolds : {true, false}) {
      Closing closing(surface, welds.of(weld), size, unfolds);
      if (!unfolds && !closing.folds()) break;
      auto mesh = closing.run(fills);
      if (!mesh) {
        error = mesh.error();
        continue;
      }
      const size_t slivers = flipSlivers(*mesh);
      if (!(inspect(*mesh).volume > 0)) {  // of needles little is left
        error = notSolid("It encloses nothing.");
      } else if (slivers == 0) {
        return mesh;
      } else if (!with_slivers) {
        with_slivers = std::move(*mesh);
      }
    }
  }
  if (with_slivers) return std::move(*with_slivers);
  return error;
}

/// Those pieces that can be closed; nothing where they are not what the model is in the main.
std::optional<ClosedSurface> closeSome(const Mesh& surface, double size) {
  Welds welds(surface, size);
  std::optional<ClosedSurface> best;
  for (const Welds::Kind kind : {Welds::kNo, Welds::kSame, Welds::kNearly}) {
    const std::vector<Mesh> pieces = piecesOf(surface, welds.of(kind));
    if (pieces.size() < 2 || pieces.size() > kMostPieces) continue;
    ClosedSurface closed;
    for (const Mesh& piece : pieces) {
      if (const auto solid = closeAll(piece, size)) {
        append(*solid, closed.mesh);
      } else {
        ++closed.left_out;
      }
    }
    if (!(sizeOf(closed.mesh) >= kMain * size)) continue;
    if (!best || closed.mesh.triangles.size() > best->mesh.triangles.size()) {
      best = std::move(closed);
    }
  }
  return best;
}

}  // namespace

Result<Mesh> closeSurface(const Mesh& surface) {
  const Mesh used = withoutUnused(surface);
  return closeAll(used, sizeOf(used));
}

Result<ClosedSurface> closeMost(const Mesh& surface) {
  const Mesh used = withoutUnused(surface);
  const double size = sizeOf(used);
  auto whole = closeAll(used, size);
  if (whole) return ClosedSurface{std::move(*whole), 0};
  auto some = closeSome(used, size);
  if (some) return std::move(*some);
  return whole.error();
}

bool crossesItself(const Mesh& mesh) {
  const std::vector<Mesh> pieces = piecesOf(mesh);
  return std::any_of(pieces.begin(), pieces.end(), hasSelfIntersection);
}

std::vector<Mesh> piecesOf(const Mesh& mesh) {
  std::vector<uint32_t> itself(mesh.positions.size());
  std::iota(itself.begin(), itself.end(), uint32_t{0});
  return piecesOf(mesh, itself);
}

}  // namespace marrow
