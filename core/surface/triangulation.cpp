#include "surface/triangulation.h"

#include <algorithm>
#include <cmath>

#include "sketch/turn_sign.h"
#include "surface/border.h"
#include "surface/constrained_delaunay.h"

namespace marrow {
namespace {

// All lengths below are in units of the spacing unless a comment says otherwise.
constexpr double kRowHeight = 0.8660254037844386;  // of a lattice of equilateral triangles
constexpr double kFirstRing = 0.35;   // depth of the first ring of points along the border, where
constexpr double kSecondRing = 1.05;  // the inflated surface rises steeply; of the second
constexpr double kRingApart = 0.4;    // of the first ring's points under border vertices
constexpr double kRingGap = 1.2;      // in the first ring, above: another point
constexpr double kRingOpen = 2;       // in the first ring, above: spikes, where it has ends
constexpr double kThin = 2.4;         // half widths below get a row of points along their middle
constexpr double kRinged = 1.3;       // half widths below get no second ring
constexpr double kClearance = 0.7;    // of lattice points from all others
constexpr double kSpike = 0.04;       // squared sum of two edges' unit normals: no ring point below
constexpr double kBesideLattice = 1.2;  // points per spacing of border, beyond the lattice's
constexpr double kInThin = 2.4;         // the same where everything is too thin for a lattice

// In points aimed at.
constexpr double kBorderShare = 0.5;  // the border gets no more
constexpr double kMost = 1.15;        // another attempt above,
constexpr double kFewest = 0.85;      // or below
constexpr int kMostAttempts = 3;
constexpr size_t kLeastBorder = 24;

// Depths, in half widths, at which a half circle rises by equal angles: an eighth, a twelfth and a
// sixth of the turn.
constexpr double kEighth = 0.29289321881345254;
constexpr double kTwelfth = 0.1339745962155614;
constexpr double kSixth = 0.5;

/// Finds points within a distance.
class Grid {
 public:
  Grid(Vec2 low, Vec2 high, double cell, size_t most_cells) : low_(low) {
    const Vec2 size = high - low;
    while ((size.x / cell + 1) * (size.y / cell + 1) > static_cast<double>(most_cells)) cell *= 2;
    per_unit_ = 1 / cell;
    columns_ = static_cast<int>(size.x * per_unit_) + 1;
    rows_ = static_cast<int>(size.y * per_unit_) + 1;
    heads_.assign(static_cast<size_t>(columns_) * rows_, -1);
  }

  void add(Vec2 point) {
    int32_t& head = heads_[static_cast<size_t>(row(point.y)) * columns_ + column(point.x)];
    entries_.push_back({point, head});
    head = static_cast<int32_t>(entries_.size() - 1);
  }

  int32_t size() const { return static_cast<int32_t>(entries_.size()); }

  /// True where no point is nearer than `apart`, nor `apart_late` for those from `late` on. Both at
  /// most a cell.
  bool isClear(Vec2 point, double apart, int32_t late, double apart_late) const {
    const double squared = apart * apart, squared_late = apart_late * apart_late;
    const double reach = std::max(apart, apart_late);
    const int left = column(point.x - reach), right = column(point.x + reach);
    const int top = row(point.y + reach);
    for (int r = row(point.y - reach); r <= top; ++r) {
      for (int c = left; c <= right; ++c) {
        for (int32_t i = heads_[static_cast<size_t>(r) * columns_ + c]; i >= 0;
             i = entries_[i].next) {
          const Vec2 off = entries_[i].at - point;
          if (dot(off, off) < (i < late ? squared : squared_late)) return false;
        }
      }
    }
    return true;
  }

 private:
  struct Entry {
    Vec2 at;
    int32_t next;
  };

  static int clamp(double at, int count) {
    return at > 0 ? (at < count ? static_cast<int>(at) : count - 1) : 0;
  }
  int column(double x) const { return clamp((x - low_.x) * per_unit_, columns_); }
  int row(double y) const { return clamp((y - low_.y) * per_unit_, rows_); }

  Vec2 low_;
  double per_unit_;
  int columns_, rows_;
  std::vector<int32_t> heads_;
  std::vector<Entry> entries_;
};

/// Puts points into a polygon: rings along the border, a row along the middle of thin places, a
/// lattice everywhere else.
class Filling {
 public:
  Filling(const std::vector<Vec2>& border, double spacing, size_t expected_points)
      : border_(border), spacing_(spacing), expected_points_(expected_points) {
    low_ = high_ = border[0];
    for (const Vec2 p : border) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  /// False where the border is not a simple, counter-clockwise polygon.
  bool fill() {
    if (!mesh_.start(border_, expected_points_ * 5 / 4 + 16)) return false;
    measure();
    Grid grid(low_, high_, spacing_, 4 * expected_points_ + 64);
    for (const Vec2 p : border_) grid.add(p);
    addFirstRing(grid);
    addMiddle(grid);
    addSecondRing(grid);
    const size_t before_lattice = mesh_.points().size();
    addLattice(grid);
    lattice_count_ = mesh_.points().size() - before_lattice;
    return true;
  }

  bool splitChords();

  const ConstrainedDelaunay& mesh() const { return mesh_; }
  size_t latticeCount() const { return lattice_count_; }

 private:
  struct Chord {
    Vec2 middle;
    double half_length;  // spacings
    uint32_t end;        // one of the border vertices it joins
  };

  void measure();
  double halfWidthAt(uint32_t vertex, Vec2 inward);
  void addFirstRing(Grid& grid);
  void addMiddle(Grid& grid);
  void addSecondRing(Grid& grid);
  void addLattice(const Grid& grid);

  uint32_t after(uint32_t k) const { return k + 1 < border_.size() ? k + 1 : 0; }
  uint32_t triangleAt(uint32_t border_edge) const { return mesh_.borderEdge(border_edge) / 3; }

  const std::vector<Vec2>& border_;
  const double spacing_;  // model units
  const size_t expected_points_;
  Vec2 low_, high_;
  ConstrainedDelaunay mesh_;
  std::vector<Vec2> normals_;        // of border edges, inward
  std::vector<Vec2> inward_;         // at border vertices: a step that leads 1 away from both edges
  std::vector<double> half_widths_;  // at border vertices, spacings; 0 at spikes
  std::vector<Chord> chords_;        // across thin places, the shortest from each vertex
  size_t lattice_count_ = 0;
};

/// Local widths, from the triangulation of the polygon without any point inside.
void Filling::measure() {
  const uint32_t n = static_cast<uint32_t>(border_.size());
  normals_.resize(n);
  for (uint32_t k = 0; k < n; ++k) {
    const Vec2 along = border_[after(k)] - border_[k];
    normals_[k] = perpendicular(along / length(along));
  }
  inward_.resize(n);
  half_widths_.resize(n);
  for (uint32_t k = 0; k < n; ++k) {
    const Vec2 before = normals_[k == 0 ? n - 1 : k - 1], behind = normals_[k];
    const Vec2 sum = before + behind;
    const double squared = dot(sum, sum);
    if (squared < kSpike) {
      half_widths_[k] = 0;
      continue;
    }
    const double size = std::sqrt(squared);
    half_widths_[k] = halfWidthAt(k, sum / size) / spacing_;
    // At sharp corners the step would get long; ring points so far off serve nothing.
    inward_[k] = sum / (cross(before, behind) > 0 ? std::max(0.5, squared / 2) : size);
  }
}

/// The radius of the largest circle inside that touches the border at `vertex`, as far as Delaunay
/// neighbours tell; model units. Notes the shortest chord from here on the way.
double Filling::halfWidthAt(uint32_t vertex, Vec2 inward) {
  const Vec2 at = border_[vertex];
  double radius = length(high_ - low_);
  double shortest = 4 * kThin * kThin * spacing_ * spacing_;
  Chord chord = {at, 0, vertex};
  for (uint32_t e = mesh_.borderEdge(vertex);;) {
    const uint32_t opposite = mesh_.next(e), spoke = mesh_.previous(e);
    if (mesh_.twin(opposite) == ConstrainedDelaunay::kNone) {
      const uint32_t k = mesh_.corner(opposite);
      const Vec2 a = border_[k], b = border_[after(k)];
      const double closing = 1 - dot(normals_[k], inward);
      const double circle = dot(normals_[k], at - a) / closing;
      if (closing > 0 && circle < radius) {
        const Vec2 centre = at + inward * circle;
        if (dot(centre - a, b - a) > 0 && dot(centre - b, a - b) > 0) radius = circle;
      }
    }
    const uint32_t other_side = mesh_.twin(spoke);
    if (other_side == ConstrainedDelaunay::kNone) break;
    const uint32_t far = mesh_.corner(spoke);
    const Vec2 off = border_[far] - at;
    const double squared = dot(off, off), ahead = dot(off, inward);
    if (ahead > 0) radius = std::min(radius, squared / (2 * ahead));
    if (squared < shortest) {
      shortest = squared;
      chord = {at + off * 0.5, std::sqrt(squared) / (2 * spacing_), vertex};
    }
    e = other_side;
  }
  if (chord.half_length > 0) chords_.push_back(chord);
  return radius;
}

/// Where the ring has a gap, triangles reach from the border to what lies behind it: a dent. So
/// points go under all border vertices that are not too near to each other, then into the middle of
/// gaps, be they from a vertex without a point or a long edge.
void Filling::addFirstRing(Grid& grid) {
  struct RingPoint {
    Vec2 at;
    double depth;
    uint32_t vertex;
  };
  std::vector<RingPoint> ring;
  const int32_t first = grid.size();
  const auto add = [&](const RingPoint& point, double apart) {
    if (!grid.isClear(point.at, 0.9 * point.depth * spacing_, first, apart * spacing_) ||
        mesh_.insert(point.at, triangleAt(point.vertex)) == ConstrainedDelaunay::kNone) {
      return false;
    }
    grid.add(point.at);
    return true;
  };
  for (uint32_t k = 0; k < border_.size(); ++k) {
    const double width = half_widths_[k];
    const double narrow = std::min(1.0, std::max(0.0, 4 - 3 * width / kRinged));
    const double depth = std::min(kFirstRing, width * (kTwelfth + (kEighth - kTwelfth) * narrow));
    if (!(depth > 0)) continue;
    const RingPoint point = {border_[k] + inward_[k] * (depth * spacing_), depth, k};
    if (add(point, std::min(kRingApart, width))) ring.push_back(point);
  }
  for (size_t i = 0; i < ring.size(); ++i) {
    const RingPoint &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double gap = distance(a.at, b.at) / spacing_;
    if (!(gap > kRingGap && gap < kRingOpen)) continue;
    add({(a.at + b.at) * 0.5, std::min(a.depth, b.depth), a.vertex}, 0.5 * kRingGap);
  }
}

void Filling::addMiddle(Grid& grid) {
  const int32_t border = static_cast<int32_t>(border_.size()), first = grid.size();
  for (const Chord& chord : chords_) {
    const double apart = std::min(0.45 * chord.half_length, 0.6);
    // Chords that only cut a bulge off have border near their middle.
    if (!grid.isClear(chord.middle, 0.8 * chord.half_length * spacing_, border, 0) ||
        !grid.isClear(chord.middle, apart * spacing_, first, 0.75 * spacing_) ||
        mesh_.insert(chord.middle, triangleAt(chord.end)) == ConstrainedDelaunay::kNone) {
      continue;
    }
    grid.add(chord.middle);
  }
}

void Filling::addSecondRing(Grid& grid) {
  const int32_t first = grid.size();
  for (uint32_t k = 0; k < border_.size(); ++k) {
    const double width = half_widths_[k];
    if (width < kRinged) continue;
    const double depth = std::min(kSecondRing, kSixth * width);
    const Vec2 point = border_[k] + inward_[k] * (depth * spacing_);
    if (!grid.isClear(point, 0.4 * depth * spacing_, first, 0.6 * spacing_) ||
        mesh_.insert(point, triangleAt(k)) == ConstrainedDelaunay::kNone) {
      continue;
    }
    grid.add(point);
  }
}

/// Row by row, each stretch inside the polygon from its left border on.
void Filling::addLattice(const Grid& grid) {
  struct Crossing {
    int row;
    double x;
    uint32_t border_edge;
  };
  const Vec2 centre = (low_ + high_) * 0.5;
  const double height = kRowHeight * spacing_;
  std::vector<Crossing> crossings;
  for (uint32_t k = 0; k < border_.size(); ++k) {
    Vec2 a = border_[k], b = border_[after(k)];
    if (a.y > b.y) std::swap(a, b);
    const int end = static_cast<int>(std::ceil((b.y - centre.y) / height));
    for (int row = static_cast<int>(std::ceil((a.y - centre.y) / height)); row < end; ++row) {
      const double t = (centre.y + row * height - a.y) / (b.y - a.y);
      crossings.push_back({row, a.x + (b.x - a.x) * t, k});
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    if (a.row != b.row) return a.row < b.row;
    return a.x != b.x ? a.x < b.x : a.border_edge < b.border_edge;
  });
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const Crossing& enter = crossings[i];
    const double y = centre.y + enter.row * height;
    const double left = centre.x + (enter.row % 2 != 0 ? 0.5 * spacing_ : 0);
    const int end = static_cast<int>(std::floor((crossings[i + 1].x - left) / spacing_));
    uint32_t hint = triangleAt(enter.border_edge);
    for (int c = static_cast<int>(std::ceil((enter.x - left) / spacing_)); c <= end; ++c) {
      const Vec2 point = {left + c * spacing_, y};
      if (!grid.isClear(point, kClearance * spacing_, 0, kClearance * spacing_)) continue;
      const uint32_t triangle = mesh_.insert(point, hint);
      if (triangle != ConstrainedDelaunay::kNone) hint = triangle;
    }
  }
}

/// An edge between two border points would stay flat when inflated. False where one is too short to
/// have a middle.
bool Filling::splitChords() {
  const uint32_t n = static_cast<uint32_t>(border_.size());
  // New edges all end at the new point, so there are never more than the n − 3 chords of an empty
  // polygon to split; but they change places.
  uint32_t left = n;
  for (bool found = true; found;) {
    found = false;
    for (uint32_t e = 0; e < mesh_.edgeCount(); ++e) {
      const uint32_t a = mesh_.corner(e), b = mesh_.corner(ConstrainedDelaunay::next(e));
      if (a >= n || b >= n || mesh_.twin(e) == ConstrainedDelaunay::kNone) continue;
      const Vec2 middle = (border_[a] + border_[b]) * 0.5;
      if (left-- == 0 || mesh_.insert(middle, e / 3) == ConstrainedDelaunay::kNone) return false;
      found = true;
    }
  }
  return true;
}

/// The spacing h for which a polygon gets about `count` points: the larger of those at which
/// area / (h² √3/2) + kBesideLattice · perimeter / h and kInThin · perimeter / h are that many.
double spacingFor(double area, double perimeter, double count) {
  const double a = area / kRowHeight, b = kBesideLattice * perimeter;
  const double thick = (b + std::sqrt(b * b + 4 * a * count)) / (2 * count);
  return std::max(thick, kInThin * perimeter / count);
}

bool isSound(const std::vector<Vec2>& points,
             const std::vector<std::array<uint32_t, 3>>& triangles) {
  for (const auto& t : triangles) {
    if (turnSign(points[t[0]], points[t[1]], points[t[2]]) <= 0) return false;
  }
  return true;
}

}  // namespace

Result<Triangulation> triangulate(const std::vector<Vec2>& outline,
                                  const TriangulationOptions& options) {
  if (outline.size() < 3) return Status::tooFewPoints;
  double area = 0, perimeter = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[i + 1 < outline.size() ? i + 1 : 0];
    area += cross(a - outline[0], b - outline[0]) / 2;
    perimeter += distance(a, b);
  }
  if (!(area > 0) || !std::isfinite(area) || !std::isfinite(perimeter)) {
    return {Status::meshFailed, "The outline does not run counter-clockwise around an area."};
  }

  const size_t target =
      static_cast<size_t>(std::max(TriangulationOptions::kFewest, options.target_points));
  double spacing = spacingFor(area, perimeter, static_cast<double>(target));
  Triangulation sparse;  // the last attempt with too few points
  for (int attempt = 1;; ++attempt) {
    const size_t most = std::max(kLeastBorder, static_cast<size_t>(kBorderShare * target));
    const std::vector<Vec2> border = fitBorder(outline, spacing, most);
    Filling filling(border, spacing, target);
    if (!filling.fill()) return {Status::meshFailed, "The outline crosses itself."};
    // The lattice grows with the square of the resolution, the rest with the resolution.
    const double lattice = static_cast<double>(filling.latticeCount());
    const double rest = static_cast<double>(filling.mesh().points().size()) - lattice;

    const bool is_split = filling.splitChords();
    Triangulation result;
    result.points = filling.mesh().points();
    result.border_count = static_cast<uint32_t>(border.size());
    result.triangles = filling.mesh().triangles();
    if (!is_split || !isSound(result.points, result.triangles)) {
      return {Status::meshFailed, "The outline is too narrow somewhere to be triangulated."};
    }

    const double count = static_cast<double>(result.points.size());
    const bool too_many = count > kMost * target, too_few = count < kFewest * target;
    if (too_many && !sparse.points.empty()) return sparse;
    if (attempt == kMostAttempts || !(too_many || too_few)) return result;
    if (too_few) sparse = std::move(result);
    spacing *= (rest + std::sqrt(rest * rest + 4 * lattice * target)) / (2 * target);
  }
}

}  // namespace marrow
