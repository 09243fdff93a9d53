#include "weights/weight_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pose/mirror.h"

namespace marrow {
namespace {

using Kind = WeightStroke::Kind;
using Trail = PlacedWeightStroke::Trail;

constexpr double kStep = 0.25;       // of the radius: between places of a stroke
constexpr double kMostSteps = 1000;  // of a stroke
constexpr double kOnIt = 1. / 64, kNear = 0.25, kFar = 2;  // × the radius: to the surface
constexpr double kScarce = 0.05;    // of others' weight: less is taken where they hold less
constexpr double kLeast = 1e-6;     // weights below are not worth an entry
constexpr double kMostRounds = 40;  // of smoothing
constexpr double kSpread = 2. / 9;  // rounds that even out a third of the radius, × (r ÷ edge)²
constexpr uint32_t kNone = UINT32_MAX;

double square(Vec3 v) { return dot(v, v); }

Vec3 nearestOnSegment(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 way = b - a;
  const double all = square(way);
  if (!(all > 0)) return a;
  return a + way * std::min(std::max(dot(p - a, way) / all, 0.0), 1.0);
}

Vec3 nearestOnTriangle(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
  const Vec3 normal = cross(b - a, c - a);
  const auto isInside = [&](Vec3 from, Vec3 to) {
    return dot(cross(to - from, p - from), normal) >= 0;
  };
  const double size = square(normal);
  if (size > 0 && isInside(a, b) && isInside(b, c) && isInside(c, a)) {
    return p - normal * (dot(p - a, normal) / size);
  }
  Vec3 nearest = nearestOnSegment(a, b, p);
  for (const Vec3 other : {nearestOnSegment(b, c, p), nearestOnSegment(c, a, p)}) {
    if (square(other - p) < square(nearest - p)) nearest = other;
  }
  return nearest;
}

Box3 around(Vec3 p, double reach) {
  const Vec3 far{reach, reach, reach};
  Box3 box;
  box.include(p - far);
  box.include(p + far);
  return box;
}

/// Places along the stroke, evenly spaced, its points among them.
std::vector<Vec3> stepsAlong(const Trail& trail) {
  double all = 0;
  for (size_t i = 1; i < trail.points.size(); ++i) {
    all += distance(trail.points[i - 1], trail.points[i]);
  }
  const double step = std::max(kStep * trail.radius, all / kMostSteps);
  std::vector<Vec3> places;
  for (size_t i = 0; i < trail.points.size(); ++i) {
    if (i == 0) {
      places.push_back(trail.points[0]);
      continue;
    }
    const Vec3 from = trail.points[i - 1], to = trail.points[i];
    const double steps = std::max(std::ceil(distance(from, to) / step), 1.0);
    for (double k = 1; k <= steps; ++k) places.push_back(lerp(from, to, k / steps));
  }
  return places;
}

double& weightOf(JointWeights& weights, uint32_t joint) {
  auto place = std::find_if(weights.begin(), weights.end(),
                            [&](const JointWeight& one) { return one.joint >= joint; });
  if (place == weights.end() || place->joint != joint) place = weights.insert(place, {joint, 0});
  return place->weight;
}

/// Without crumbs, and with the sum 1 again.
void tidy(JointWeights& weights) {
  weights.erase(std::remove_if(weights.begin(), weights.end(),
                               [](const JointWeight& one) { return !(one.weight > kLeast); }),
                weights.end());
  double sum = 0;
  for (const JointWeight& one : weights) sum += one.weight;
  for (JointWeight& one : weights) one.weight /= sum;
}

/// What is done to one vertex: by how much, for which joint. At most two, of other joints.
struct Dab {
  uint32_t joint;
  double share;
};

void add(const std::vector<Dab>& dabs, JointWeights& weights) {
  double kept = 1, shares = 0;
  for (const Dab& dab : dabs) {
    kept *= 1 - dab.share;
    shares += dab.share;
  }
  for (JointWeight& one : weights) one.weight *= kept;
  for (const Dab& dab : dabs) weightOf(weights, dab.joint) += (1 - kept) * dab.share / shares;
}

void take(const std::vector<Dab>& dabs, JointWeights& weights) {
  const auto shareOf = [&](uint32_t joint) {
    for (const Dab& dab : dabs) {
      if (dab.joint == joint) return dab.share;
    }
    return 0.0;
  };
  const JointWeights before = weights;
  for (const JointWeight& one : before) {
    const double share = shareOf(one.joint);
    if (!(share > 0)) continue;
    double others = 0;  // that hold, and are not taken from as well
    for (const JointWeight& other : before) {
      if (other.joint != one.joint) others += other.weight * (1 - shareOf(other.joint));
    }
    if (!(others > 0)) continue;
    const double taken = one.weight * share * std::min(others / kScarce, 1.0);
    for (size_t k = 0; k < before.size(); ++k) {
      const JointWeight& other = before[k];
      weights[k].weight += other.joint == one.joint
                               ? -taken
                               : taken * other.weight * (1 - shareOf(other.joint)) / others;
    }
  }
}

}  // namespace

bool operator==(const PlacedWeightStroke& a, const PlacedWeightStroke& b) {
  return a.kind == b.kind && a.strength == b.strength &&
         std::equal(a.trails.begin(), a.trails.end(), b.trails.begin(), b.trails.end(),
                    [](const Trail& one, const Trail& other) {
                      return one.joint == other.joint && one.radius == other.radius &&
                             one.points == other.points;
                    });
}

std::vector<PlacedWeightStroke> placedStrokes(const Document& document, const Rig& rig) {
  std::vector<PlacedWeightStroke> placed;
  OppositeJoints opposite(document, rig);
  for (const auto& stroke : document.weight_strokes) {
    const auto index = document.find(stroke->part);
    if (!index) continue;
    const PartSource& part = *document.parts[*index];
    PlacedWeightStroke one{stroke->kind, stroke->strength, {}};
    Trail trail{stroke->joint, stroke->radius * part.frame.scale(), {}};
    for (const Vec3 p : stroke->points) {
      const Vec3 there = part.frame.toWorld(p);
      if (isDrawable(there)) trail.points.push_back(there);
    }
    one.trails.push_back(trail);
    if (part.mirror) {
      trail.joint = opposite.of(stroke->joint, *part.mirror);
      // One of a joint that the rig has only on the other side is for the joint opposite to that.
      one.trails[0].joint = opposite.of(trail.joint, *part.mirror);
      for (Vec3& p : trail.points) p = mirrored(p, *part.mirror);
      one.trails.push_back(std::move(trail));
    }
    placed.push_back(std::move(one));
  }
  return placed;
}

WeightStroke forJointOfRig(const Document& document, const Rig& rig, WeightStroke in_space) {
  const auto index = document.find(sourceId(in_space.part));
  if (!index || !isTwinId(in_space.part) || !document.parts[*index]->mirror) return in_space;
  const Plane& plane = *document.parts[*index]->mirror;
  in_space.joint = oppositeJoint(document, OppositeJoints(document, rig).of(in_space.joint, plane));
  return in_space;
}

WeightPainter::WeightPainter(const Mesh& surface, const Rig& rig)
    : surface_(surface), triangles_([&] {
        std::vector<Box3> boxes(surface.triangles.size());
        for (size_t t = 0; t < boxes.size(); ++t) {
          for (const uint32_t v : surface.triangles[t]) boxes[t].include(surface.positions[v]);
        }
        return boxes;
      }()) {
  for (uint32_t joint = 0; joint < rig.joints.size(); ++joint) {
    joints_.emplace(rig.joints[joint].id, joint);
  }
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (const auto& [a, b, c] : surface.triangles) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      edges.push_back({from, to});
      edges.push_back({to, from});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  starts_.assign(surface.positions.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++starts_[from + 1];
    neighbours_.push_back(to);
  }
  for (size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
}

/// The stroke on the surface. seeds: the vertices around its places.
std::vector<Vec3> WeightPainter::drawnToSurface(const Trail& trail,
                                                std::vector<uint32_t>& seeds) const {
  struct Nearest {
    double squared;
    uint32_t triangle;
    Vec3 place;
  };
  const std::vector<Vec3> places = stepsAlong(trail);
  std::vector<Nearest> nearest(places.size(), {0, kNone, {}});
  // Most lie on it: a short look around finds them.
  for (const double part : {kOnIt, kNear, kFar}) {
    const double reach = part * trail.radius;
    std::vector<Box3> boxes;
    std::vector<uint32_t> asked;
    for (uint32_t i = 0; i < places.size(); ++i) {
      if (nearest[i].triangle != kNone) continue;
      nearest[i].squared = reach * reach;
      asked.push_back(i);
      boxes.push_back(around(places[i], reach));
    }
    if (asked.empty()) break;
    BoxTree(std::move(boxes)).pairs(triangles_, [&](uint32_t k, uint32_t t) {
      const auto& [a, b, c] = surface_.triangles[t];
      const auto& at = surface_.positions;
      const uint32_t i = asked[k];
      const Vec3 place = nearestOnTriangle(at[a], at[b], at[c], places[i]);
      const double squared = square(place - places[i]);
      Nearest& best = nearest[i];
      if (squared < best.squared || (squared == best.squared && t < best.triangle)) {
        best = {squared, t, place};
      }
    });
  }
  std::vector<Vec3> drawn;
  for (const Nearest& one : nearest) {
    if (one.triangle == kNone) continue;
    drawn.push_back(one.place);
    for (const uint32_t v : surface_.triangles[one.triangle]) seeds.push_back(v);
  }
  return drawn;
}

std::vector<WeightPainter::Share> WeightPainter::cover(const Trail& trail) const {
  std::vector<uint32_t> seeds;
  const std::vector<Vec3> drawn = drawnToSurface(trail, seeds);
  const double squared_radius = trail.radius * trail.radius;
  const auto squaredDistance = [&](Vec3 p) {
    double least = squared_radius;
    for (size_t i = 0; i < drawn.size(); ++i) {
      const Vec3 from = drawn[i > 0 ? i - 1 : 0];
      // Places far apart are of pieces of their own.
      const bool joined = square(drawn[i] - from) < squared_radius;
      const Vec3 near = joined ? nearestOnSegment(from, drawn[i], p) : drawn[i];
      least = std::min(least, square(near - p));
    }
    return least;
  };
  std::vector<char> asked(surface_.positions.size(), 0);
  std::vector<uint32_t> todo;
  std::vector<Share> shares;
  const auto reach = [&](uint32_t v) {
    if (asked[v]) return;
    asked[v] = 1;
    const double squared = squaredDistance(surface_.positions[v]);
    if (!(squared < squared_radius)) return;
    const double rest = 1 - squared / squared_radius;
    shares.push_back({v, rest * rest});
    todo.push_back(v);
  };
  for (const uint32_t v : seeds) reach(v);
  while (!todo.empty()) {
    const uint32_t v = todo.back();
    todo.pop_back();
    for (uint32_t i = starts_[v]; i < starts_[v + 1]; ++i) reach(neighbours_[i]);
  }
  std::sort(shares.begin(), shares.end(),
            [](const Share& a, const Share& b) { return a.vertex < b.vertex; });
  return shares;
}

std::vector<uint32_t> WeightPainter::paint(const PlacedWeightStroke& stroke,
                                           std::vector<JointWeights>& weights) const {
  const double strength = std::min(stroke.strength, 1.0);
  std::vector<std::vector<Share>> covered;  // by trail
  std::vector<uint32_t> joints;
  double radius = 0;
  for (const Trail& trail : stroke.trails) {
    const auto found = joints_.find(trail.joint);
    const bool any = stroke.kind == Kind::smooth;
    if (!(strength > 0) || !(trail.radius > 0) || (!any && found == joints_.end())) continue;
    joints.push_back(any ? kNone : found->second);
    radius = std::max(radius, trail.radius);
    covered.push_back(cover(trail));
  }
  // Vertex by vertex, along all trails at once.
  std::vector<uint32_t> vertices;
  std::vector<Share> smoothed;
  std::vector<size_t> next(covered.size(), 0);
  for (std::vector<Dab> dabs;; dabs.clear()) {
    uint32_t vertex = kNone;
    for (size_t i = 0; i < covered.size(); ++i) {
      if (next[i] < covered[i].size()) vertex = std::min(vertex, covered[i][next[i]].vertex);
    }
    if (vertex == kNone) break;
    for (size_t i = 0; i < covered.size(); ++i) {
      if (next[i] == covered[i].size() || covered[i][next[i]].vertex != vertex) continue;
      const double share = covered[i][next[i]++].share * strength;
      if (!(share > 0)) continue;
      const auto same = std::find_if(dabs.begin(), dabs.end(),
                                     [&](const Dab& dab) { return dab.joint == joints[i]; });
      if (same == dabs.end()) {
        dabs.push_back({joints[i], share});
      } else {
        same->share = std::max(same->share, share);
      }
    }
    if (dabs.empty() || weights[vertex].empty()) continue;
    if (stroke.kind == Kind::smooth) {
      smoothed.push_back({vertex, dabs[0].share});
      continue;
    }
    vertices.push_back(vertex);
    if (stroke.kind == Kind::add) {
      add(dabs, weights[vertex]);
    } else {
      take(dabs, weights[vertex]);
    }
    tidy(weights[vertex]);
  }
  return stroke.kind == Kind::smooth ? smooth(smoothed, radius, weights) : vertices;
}

std::vector<uint32_t> WeightPainter::smooth(const std::vector<Share>& shares, double radius,
                                            std::vector<JointWeights>& weights) const {
  // The vertices, those around them, and the joints that hold them, as a small dense table.
  std::vector<uint32_t> vertices, reached, joints;
  double edges = 0, count = 0;
  for (const Share& one : shares) {
    reached.push_back(one.vertex);
    vertices.push_back(one.vertex);
    for (uint32_t i = starts_[one.vertex]; i < starts_[one.vertex + 1]; ++i) {
      vertices.push_back(neighbours_[i]);
      edges += distance(surface_.positions[one.vertex], surface_.positions[neighbours_[i]]);
      ++count;
    }
  }
  if (!(edges > 0)) return {};
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const uint32_t v : vertices) {
    for (const JointWeight& one : weights[v]) joints.push_back(one.joint);
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  const size_t width = joints.size();
  const auto rowOf = [&](uint32_t v) {
    const auto place = std::lower_bound(vertices.begin(), vertices.end(), v);
    return static_cast<size_t>(place - vertices.begin()) * width;
  };
  std::vector<double> table(vertices.size() * width, 0);
  for (const uint32_t v : vertices) {
    for (const JointWeight& one : weights[v]) {
      const auto column = std::lower_bound(joints.begin(), joints.end(), one.joint);
      table[rowOf(v) + static_cast<size_t>(column - joints.begin())] = one.weight;
    }
  }
  std::vector<size_t> own_rows, rows, first_row(1, 0);
  for (const Share& one : shares) {
    own_rows.push_back(rowOf(one.vertex));
    for (uint32_t i = starts_[one.vertex]; i < starts_[one.vertex + 1]; ++i) {
      if (!weights[neighbours_[i]].empty()) rows.push_back(rowOf(neighbours_[i]));
    }
    first_row.push_back(rows.size());
  }

  const double in_edges = radius * count / edges;
  const double wanted = std::ceil(kSpread * in_edges * in_edges);
  const int rounds = static_cast<int>(std::min(std::max(wanted, 1.0), kMostRounds));
  std::vector<double> next(shares.size() * width), sums(width);
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < shares.size(); ++i) {
      const size_t begin = first_row[i], end = first_row[i + 1];
      if (begin == end) {
        std::copy_n(table.data() + own_rows[i], width, next.data() + i * width);
        continue;
      }
      std::fill(sums.begin(), sums.end(), 0);
      for (size_t r = begin; r < end; ++r) {
        const double* row = table.data() + rows[r];
        for (size_t k = 0; k < width; ++k) sums[k] += row[k];
      }
      const double* own = table.data() + own_rows[i];
      double* into = next.data() + i * width;
      const double share = shares[i].share, around = static_cast<double>(end - begin);
      for (size_t k = 0; k < width; ++k) into[k] = own[k] + share * (sums[k] / around - own[k]);
    }
    for (size_t i = 0; i < shares.size(); ++i) {
      std::copy_n(next.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                  table.begin() + static_cast<std::ptrdiff_t>(own_rows[i]));
    }
  }
  for (size_t i = 0; i < shares.size(); ++i) {
    JointWeights& own = weights[shares[i].vertex];
    own.clear();
    for (size_t k = 0; k < width; ++k) {
      if (table[own_rows[i] + k] > 0) own.push_back({joints[k], table[own_rows[i] + k]});
    }
    tidy(own);
  }
  return reached;
}

}  // namespace marrow
