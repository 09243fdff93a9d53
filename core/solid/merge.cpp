#include "solid/merge.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <unordered_map>

#include "solid/box_tree.h"
#include "solid/clean.h"
#include "solid/cut.h"
#include "solid/fill.h"
#include "solid/quality.h"
#include "surface/sharp.h"

namespace marrow {
namespace {

constexpr int kAttempts = 4;
constexpr int kCleanings = 4;
constexpr double kJitter = 16;   // lattice units; each attempt takes four times as many
constexpr double kOutward = 64;  // between one part and the next, so that copies lie in each other
constexpr double kTouching = 1e-6;  // of the model's size; nearer parts are moved by other amounts

/// A body, kept but once however often it is placed. In its own coordinates.
struct Shape {
  const Mesh* mesh = nullptr;
  bool foreign = false;
  std::string wrong;  // what keeps it from being a solid
  std::vector<Vec3> normals;
  std::vector<std::array<Vec3, 3>> corner_normals;  // of a foreign one
};

struct Solid {
  uint32_t input;
  uint32_t shape;
  Frame frame;
  Affine turn;      // the same without place and size
  bool inside_out;  // its triangles and normals have to be turned over
  Box3 box;         // in the model
  int rank = 0;
};

/// A number between −1 and 1, as if by chance [Steele, Lea & Flood 2014].
double scattered(uint64_t seed) {
  uint64_t z = seed * 0x9E3779B97F4A7C15ull + 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  z ^= z >> 31;
  return static_cast<double>(static_cast<int64_t>(z >> 11)) * 0x1p-52 - 1;
}

double rounded(double value) { return std::floor(value + 0.5); }

bool isWithinReach(Vec3 p) {
  return std::fabs(p.x) < 1e150 && std::fabs(p.y) < 1e150 && std::fabs(p.z) < 1e150;
}

/// What is wrong with a mesh that should be a solid; empty: nothing.
std::string whatIsWrong(const Mesh& mesh) {
  if (mesh.triangles.empty()) return "it has no surface";
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), isWithinReach)) {
    return "it reaches too far";
  }
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (corner >= mesh.positions.size()) return "a triangle has a corner that is not there";
    }
  }
  return isClosed(mesh) ? "" : "its surface is not closed";
}

/// Also of a foreign one.
std::string whatIsWrongInside(const Mesh& mesh) {
  if (!inspect(mesh).manifold) return "its surface touches itself";
  return countSelfIntersections(mesh) > 0 ? "its surface crosses itself" : "";
}

uint64_t mixed(uint64_t hash, uint64_t bits) {
  return (hash ^ bits ^ (bits >> 32)) * 0x100000001B3ull;
}
uint64_t mixed(uint64_t hash, Vec3 p) {
  for (double number : {p.x, p.y, p.z}) {
    number += 0.0;  // −0 is 0
    uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    hash = mixed(hash, bits);
  }
  return hash;
}
constexpr uint64_t kHashStart = 0xCBF29CE484222325ull;

uint64_t hashOf(const Mesh& mesh) {
  uint64_t hash = mixed(kHashStart, mesh.triangles.size());
  for (const Vec3 p : mesh.positions) hash = mixed(hash, p);
  return hash;
}

/// Finds one that is the same among what was added: `value` by hash, told apart by `isSame`.
template <typename IsSame>
std::optional<uint32_t> findSame(const std::unordered_multimap<uint64_t, uint32_t>& known,
                                 uint64_t hash, const IsSame& isSame) {
  const auto [first, end] = known.equal_range(hash);
  const auto found =
      std::find_if(first, end, [&](const auto& item) { return isSame(item.second); });
  return found == end ? std::nullopt : std::optional<uint32_t>(found->second);
}

class Merger {
 public:
  Merger(const std::vector<SolidInput>& inputs, const MergeOptions& options, Clock clock)
      : inputs_(inputs), options_(options), watch_(clock, merged_.timings) {}

  MergedMesh run() {
    for (uint32_t i = 0; i < inputs_.size(); ++i) prepare(i);
    dropCopies();
    merged_.shapes = shapes_.size();
    merged_.distinct = solids_.size();
    watch_.lap("prepare");
    while (!solids_.empty() && !mergeAll()) {
    }
    merged_.mesh = std::move(best_.mesh);
    return std::move(merged_);
  }

 private:
  void prepare(uint32_t index) {
    const SolidInput& input = inputs_[index];
    if (!input.mesh) return leaveOut(index, "it has no surface");
    const Frame& frame = input.frame;
    Solid solid{index, shapeOf(input), frame, {}, false, {}, 0};
    const Shape& shape = shapes_[solid.shape];
    if (!shape.wrong.empty()) return leaveOut(index, shape.wrong);
    placed_.clear();
    const Vec3 z = frame.z();
    for (const Vec3 p : input.mesh->positions) {
      const Vec3 placed = frame.toWorld(Vec2{p.x, p.y}) + z * p.z;
      if (!isWithinReach(placed)) return leaveOut(index, "it reaches too far");
      placed_.push_back(placed);
      solid.box.include(placed);
    }
    const double volume = signedVolume(placed_, input.mesh->triangles);
    if (volume == 0) return leaveOut(index, "it encloses nothing");
    solid.inside_out = volume < 0;
    const double scale = frame.scale();
    solid.turn = {frame.x / scale, frame.y / scale, z / scale, {}};
    solids_.push_back(solid);
  }

  uint32_t shapeOf(const SolidInput& input) {
    const auto last = of_mesh_.find({input.mesh, input.foreign});
    if (last != of_mesh_.end()) return last->second;
    const Mesh& mesh = *input.mesh;
    const uint64_t hash = hashOf(mesh);
    const auto same = findSame(known_shapes_, hash, [&](uint32_t i) {
      const Shape& other = shapes_[i];
      return other.foreign == input.foreign && other.mesh->positions == mesh.positions &&
             other.mesh->triangles == mesh.triangles;
    });
    const uint32_t index = same ? *same : static_cast<uint32_t>(shapes_.size());
    of_mesh_[{input.mesh, input.foreign}] = index;
    if (same) return index;
    known_shapes_.emplace(hash, index);
    Shape shape;
    shape.mesh = &mesh;
    shape.foreign = input.foreign;
    shape.wrong = whatIsWrong(mesh);
    if (shape.wrong.empty() && input.foreign) shape.wrong = whatIsWrongInside(mesh);
    if (shape.wrong.empty()) {
      shape.normals = vertexNormals(mesh);
      if (input.foreign) shape.corner_normals = cornerNormals(mesh);
    }
    shapes_.push_back(std::move(shape));
    return index;
  }

  /// Of the same body in the same place only the last one is seen.
  void dropCopies() {
    std::unordered_multimap<uint64_t, uint32_t> seen;
    std::vector<Solid> kept;
    for (size_t i = solids_.size(); i-- > 0;) {
      const Solid& solid = solids_[i];
      const Frame& frame = solid.frame;
      const uint64_t hash =
          mixed(mixed(mixed(mixed(kHashStart, frame.origin), frame.x), frame.y), solid.shape);
      const auto same = findSame(seen, hash, [&](uint32_t other) {
        return solids_[other].shape == solid.shape && solids_[other].frame == frame;
      });
      if (same) continue;
      seen.emplace(hash, static_cast<uint32_t>(i));
      kept.push_back(solid);
    }
    std::reverse(kept.begin(), kept.end());
    solids_ = std::move(kept);
  }

  void leaveOut(uint32_t input, const std::string& why) {
    merged_.left_out.push_back({inputs_[input].id, why});
  }

  /// False: a part had to be left out; try again without it.
  bool mergeAll() {
    makeLattice();
    best_ = {};
    uint32_t culprit = 0;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      ++merged_.attempts;
      makeSoup(static_cast<uint64_t>(attempt));
      cut_ = cutSurfaces(soup_);
      watch_.lap("cut");
      const bool is_filled = cut_.ok && fill();
      watch_.lap("fill");
      if (!is_filled) {
        culprit = std::max(cut_.part, cut_.other);
      } else if (tryWays()) {
        return true;
      } else if (!best_.is_closed) {
        culprit = partWithHole();
      }
    }
    if (best_.is_closed) return true;
    leaveOut(solids_[culprit].input, "it cannot be joined with the others");
    solids_.erase(solids_.begin() + culprit);
    return false;
  }

  /// A part that has an edge without a counterpart.
  uint32_t partWithHole() const {
    std::vector<uint64_t> edges;
    const auto edge = [](uint32_t a, uint32_t b) { return static_cast<uint64_t>(a) << 32 | b; };
    for (const auto& [a, b, c] : triangles_) {
      edges.insert(edges.end(), {edge(a, b), edge(b, c), edge(c, a)});
    }
    std::sort(edges.begin(), edges.end());
    for (size_t t = 0; t < triangles_.size(); ++t) {
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
        const auto [low, high] = std::equal_range(edges.begin(), edges.end(), edge(b, a));
        if (high - low != 1) return soup_.part_of_triangle[sources_[t]];
      }
    }
    return static_cast<uint32_t>(solids_.size()) - 1;
  }

  /// With the slivers gone, and with those that must stay. False: self-intersections are left.
  bool tryWays() {
    const auto own = static_cast<std::ptrdiff_t>(soup_.points.size());
    const std::vector<Vec3> added(cut_.points.begin() + own, cut_.points.end());
    std::vector<char> frozen(soup_.triangles.size(), 0);
    for (int round = 0; options_.collapse_slivers && round < kCleanings; ++round) {
      collapseSlivers(soup_, cut_.points, triangles_, sources_, frozen);
      watch_.lap("clean");
      if (isBest()) return true;
      for (const auto& [t, u] : crossings_) frozen[sources_[t]] = frozen[sources_[u]] = 1;
      std::copy(soup_.points.begin(), soup_.points.end(), cut_.points.begin());
      std::copy(added.begin(), added.end(), cut_.points.begin() + own);
      fill();
    }
    return isBest();
  }

  /// Keeps the mesh where it is better than those before; true where it is good.
  bool isBest() {
    Candidate candidate;
    const std::vector<uint32_t> points = compact(candidate.mesh);
    candidate.is_closed = isClosed(candidate.mesh);
    crossings_.clear();
    if (candidate.is_closed) {
      std::vector<char> changed(triangles_.size());
      for (size_t t = 0; t < triangles_.size(); ++t) {
        for (const uint32_t p : triangles_[t]) {
          if (p >= soup_.points.size() || !(cut_.points[p] == soup_.points[p])) changed[t] = 1;
        }
      }
      crossings_ = selfIntersections(candidate.mesh, changed);
      candidate.crossings = crossings_.size();
    }
    watch_.lap("check");
    const bool is_better =
        candidate.is_closed && (!best_.is_closed || candidate.crossings < best_.crossings);
    if (is_better) {
      best_ = std::move(candidate);
      finish(points);
      watch_.lap("finish");
    }
    return best_.is_closed && best_.crossings == 0;
  }

  void makeLattice() {
    Box3 box;
    for (const Solid& solid : solids_) {
      box.include(solid.box.low);
      box.include(solid.box.high);
    }
    middle_ = box.middle();
    const Vec3 size = box.size();
    const double widest = std::max({size.x, size.y, size.z});
    // A power of two, so that going there and back rounds once only.
    unit_ = 1;
    const double reach = kLatticeReach * 0.999;
    while (widest / 2 > unit_ * reach) unit_ *= 2;
    while (widest / 2 <= unit_ / 2 * reach && unit_ > 1e-300) unit_ /= 2;
    middle_ = {rounded(middle_.x / unit_) * unit_, rounded(middle_.y / unit_) * unit_,
               rounded(middle_.z / unit_) * unit_};

    rankSolids(widest * kTouching);
  }

  /// Those that come as near as that to each other get different ranks.
  void rankSolids(double touching) {
    std::vector<Box3> boxes, wider;
    const Vec3 margin = Vec3{1, 1, 1} * touching;
    for (const Solid& solid : solids_) {
      boxes.push_back(solid.box);
      wider.push_back(solid.box);
      wider.back().low = wider.back().low - margin;
      wider.back().high = wider.back().high + margin;
    }
    std::vector<std::vector<uint32_t>> earlier(solids_.size());
    BoxTree(std::move(wider)).pairs(BoxTree(std::move(boxes)), [&](uint32_t i, uint32_t j) {
      if (j < i) earlier[i].push_back(j);
    });
    for (size_t i = 0; i < solids_.size(); ++i) {
      std::vector<char> taken(earlier[i].size() + 1, 0);
      for (const uint32_t j : earlier[i]) {
        const auto rank = static_cast<size_t>(solids_[j].rank);
        if (rank < taken.size()) taken[rank] = 1;
      }
      solids_[i].rank = static_cast<int>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    }
  }

  void makeSoup(uint64_t attempt) {
    soup_ = {};
    first_points_.clear();
    first_triangles_.clear();
    uint64_t seed = attempt << 40;
    const double more = static_cast<double>(uint64_t{1} << (2 * attempt));
    for (uint32_t s = 0; s < solids_.size(); ++s) {
      const Solid& solid = solids_[s];
      const uint32_t base = static_cast<uint32_t>(soup_.points.size());
      first_points_.push_back(base);
      first_triangles_.push_back(static_cast<uint32_t>(soup_.triangles.size()));
      const Shape& shape = shapes_[solid.shape];
      const double outward = kOutward * more * (solid.rank + 1);
      const Vec3 upward = solid.frame.z();
      for (size_t v = 0; v < shape.mesh->positions.size(); ++v) {
        const Vec3 p = shape.mesh->positions[v];
        const Vec3 placed = solid.frame.toWorld(Vec2{p.x, p.y}) + upward * p.z;
        const Vec3 at = (placed - middle_) / unit_ + turned(solid, shape.normals[v]) * outward;
        const auto place = [&](double value) {
          return rounded(value + kJitter * more * scattered(seed++));
        };
        const double x = place(at.x), y = place(at.y), z = place(at.z);
        soup_.points.push_back({x, y, z});
      }
      soup_.part_of_point.resize(soup_.points.size(), s);
      for (const auto& [a, b, c] : shape.mesh->triangles) {
        const uint32_t second = solid.inside_out ? c : b, third = solid.inside_out ? b : c;
        soup_.triangles.push_back({base + a, base + second, base + third});
      }
      soup_.part_of_triangle.resize(soup_.triangles.size(), s);
    }
  }

  bool fill() {
    triangles_.clear();
    sources_.clear();
    triangles_.reserve(cut_.whole.size() + 2 * cut_.borders.size());
    for (const uint32_t t : cut_.whole) {
      triangles_.push_back(soup_.triangles[t]);
      sources_.push_back(t);
    }
    for (size_t first = 0, end = 0; first < cut_.borders.size(); first = end) {
      const uint32_t t = cut_.borders[first].triangle;
      while (end < cut_.borders.size() && cut_.borders[end].triangle == t) ++end;
      if (!fillTriangle(t, first, end)) {
        cut_.part = cut_.other = soup_.part_of_triangle[t];
        return false;
      }
      sources_.resize(triangles_.size(), t);
    }
    return true;
  }

  bool fillTriangle(uint32_t t, size_t first, size_t end) {
    const auto& corners = soup_.triangles[t];
    const Vec3 base = soup_.points[corners[0]];
    const Vec3 normal = cross(soup_.points[corners[1]] - base, soup_.points[corners[2]] - base);
    const Vec3 size = {std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
    const auto flat = [&](uint32_t point) {
      const Vec3 p = cut_.points[point] - base;
      if (size.x >= size.y && size.x >= size.z) {
        return normal.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y};
      }
      if (size.y >= size.z) return normal.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z};
      return normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x};
    };
    std::vector<Border> borders;
    std::vector<char> used(end - first, 0);
    for (size_t start = first; start < end; ++start) {
      if (used[start - first]) continue;
      Border border;
      for (size_t at = start; at < end && !used[at - first];) {
        used[at - first] = 1;
        const uint32_t from = cut_.borders[at].from;
        border.points.push_back({from, flat(from)});
        border.outer = border.outer || isOnBorder(t, from);
        const uint32_t to = cut_.borders[at].to;
        at = first;
        while (at < end && (cut_.borders[at].from != to || used[at - first])) ++at;
      }
      borders.push_back(std::move(border));
    }
    return fillRegion(std::move(borders), triangles_);
  }

  bool isOnBorder(uint32_t t, uint32_t point) const {
    const auto& corners = soup_.triangles[t];
    const auto isCorner = [&](uint32_t p) {
      return p == corners[0] || p == corners[1] || p == corners[2];
    };
    if (point < soup_.points.size()) return true;
    const Cut::Origin& origin = cut_.origins[point - soup_.points.size()];
    return origin.a != origin.b && isCorner(origin.a) && isCorner(origin.b);
  }

  /// Makes a mesh of the model of what is used; returns its vertices' points.
  std::vector<uint32_t> compact(Mesh& mesh) const {
    constexpr uint32_t kUnused = ~0u;
    std::vector<uint32_t> place(cut_.points.size(), kUnused), points;
    mesh.triangles = triangles_;
    for (auto& triangle : mesh.triangles) {
      for (uint32_t& corner : triangle) {
        if (place[corner] == kUnused) {
          place[corner] = static_cast<uint32_t>(points.size());
          points.push_back(corner);
        }
        corner = place[corner];
      }
    }
    mesh.positions.reserve(points.size());
    for (const uint32_t p : points) mesh.positions.push_back(middle_ + cut_.points[p] * unit_);
    return points;
  }

  void finish(const std::vector<uint32_t>& points) {
    merged_.corner_normals.clear();
    merged_.part_of_triangle.clear();
    merged_.on_seam.clear();
    merged_.corner_normals.reserve(triangles_.size());
    merged_.part_of_triangle.reserve(triangles_.size());
    for (size_t t = 0; t < triangles_.size(); ++t) {
      const uint32_t part = soup_.part_of_triangle[sources_[t]];
      std::array<Vec3, 3> normals;
      for (size_t i = 0; i < 3; ++i) normals[i] = normalAt(triangles_[t][i], part, t);
      merged_.corner_normals.push_back(normals);
      merged_.part_of_triangle.push_back(inputs_[solids_[part].input].id);
    }
    for (const uint32_t p : points) merged_.on_seam.push_back(p >= soup_.points.size());
    merged_.crossings = cut_.crossings;
    merged_.pairs = cut_.pairs;
    merged_.examined = cut_.examined;
    merged_.self_intersections = best_.crossings;
  }

  /// Of a triangle of the union.
  Vec3 normalAt(uint32_t point, uint32_t part, size_t triangle) const {
    const uint32_t source = sources_[triangle];
    if (point < soup_.points.size() && soup_.part_of_point[point] == part) {
      return original(point, source);
    }
    if (point >= soup_.points.size()) {
      const Cut::Origin& origin = cut_.origins[point - soup_.points.size()];
      if (origin.a != origin.b && soup_.part_of_point[origin.a] == part) {
        return unit(lerp(original(origin.a, source), original(origin.b, source), origin.share));
      }
      const int count = origin.a != origin.b ? 1 : 3;
      for (int i = 0; i < count; ++i) {
        if (soup_.part_of_triangle[origin.triangles[i]] == part) {
          return within(origin.triangles[i], cut_.points[point]);
        }
      }
    }
    const auto& corners = triangles_[triangle];
    const Vec3 a = cut_.points[corners[0]];
    return unit(cross(cut_.points[corners[1]] - a, cut_.points[corners[2]] - a));
  }

  /// As a triangle of the soup has it; the smooth one where it has no such corner.
  Vec3 original(uint32_t point, uint32_t triangle) const {
    const uint32_t part = soup_.part_of_point[point];
    const Solid& solid = solids_[part];
    const Shape& shape = shapes_[solid.shape];
    const uint32_t own = point - first_points_[part];
    if (!shape.corner_normals.empty() && soup_.part_of_triangle[triangle] == part) {
      const uint32_t own_triangle = triangle - first_triangles_[part];
      for (size_t k = 0; k < 3; ++k) {
        if (shape.mesh->triangles[own_triangle][k] != own) continue;
        return turned(solid, shape.corner_normals[own_triangle][k]);
      }
    }
    return turned(solid, shape.normals[own]);
  }

  /// A direction of the shape as it is in the model.
  static Vec3 turned(const Solid& solid, Vec3 direction) {
    const Vec3 placed = solid.turn.direction(direction);
    return solid.inside_out ? -placed : placed;
  }

  Vec3 within(uint32_t triangle, Vec3 p) const {
    const auto& [i, j, k] = soup_.triangles[triangle];
    const Vec3 a = soup_.points[i], b = soup_.points[j], c = soup_.points[k];
    const Vec3 normal = cross(b - a, c - a);
    const double all = dot(normal, normal);
    const double at_b = dot(normal, cross(p - a, c - a)) / all,
                 at_c = dot(normal, cross(b - a, p - a)) / all;
    return unit(original(i, triangle) * (1 - at_b - at_c) + original(j, triangle) * at_b +
                original(k, triangle) * at_c);
  }

  static Vec3 unit(Vec3 v) {
    const double size = length(v);
    return size > 0 ? v / size : Vec3{0, 0, 1};
  }

  struct Candidate {
    Mesh mesh;
    bool is_closed = false;
    size_t crossings = 0;
  };

  const std::vector<SolidInput>& inputs_;
  const MergeOptions options_;
  MergedMesh merged_;
  Stopwatch watch_;
  std::vector<Shape> shapes_;
  std::map<std::pair<const Mesh*, bool>, uint32_t> of_mesh_;  // shape of each mesh
  std::unordered_multimap<uint64_t, uint32_t> known_shapes_;  // by hash
  std::vector<Solid> solids_;
  std::vector<Vec3> placed_;
  Vec3 middle_;
  double unit_ = 1;
  Soup soup_;
  std::vector<uint32_t> first_points_, first_triangles_;  // of each part
  Cut cut_;
  std::vector<uint32_t> sources_;  // of each triangle, what triangle of the soup it is a piece of
  std::vector<std::array<uint32_t, 3>> triangles_;
  Candidate best_;
  std::vector<std::pair<uint32_t, uint32_t>> crossings_;  // of the last candidate's triangles
};

}  // namespace

MergedMesh mergeSolids(const std::vector<SolidInput>& solids, const MergeOptions& options,
                       Clock clock) {
  return Merger(solids, options, clock).run();
}

}  // namespace marrow
