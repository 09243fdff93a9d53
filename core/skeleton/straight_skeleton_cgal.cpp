// The oracle and the fallback: CGAL's straight skeleton in our conventions. The only file of this
// room that includes CGAL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Straight_skeleton_2.h>
#include <CGAL/Straight_skeleton_builder_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "base/box.h"
#include "skeleton/straight_skeleton.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Straight_skeleton_builder_traits_2<Kernel>;

/// Memory that CGAL has given back, until a skeleton is done: where many nodes coincide, CGAL 5.5's
/// builder still looks at vertices that it has erased.
std::vector<void*>& graveyard() {
  static thread_local std::vector<void*> freed;
  return freed;
}

struct Undertaker {
  ~Undertaker() {
    for (void* freed : graveyard()) ::operator delete(freed);
    graveyard().clear();
  }
};

/// An erased vertex has a negative id, by which CGAL would look it up.
template <typename Vertex>
auto restoreId(Vertex* vertex, int) -> decltype(vertex->reset_id__internal__(0)) {
  if (vertex->id() < 0) vertex->reset_id__internal__(-vertex->id());
}
template <typename Other>
void restoreId(Other*, long) {}

template <typename T>
struct KeepingAllocator {
  using value_type = T;
  KeepingAllocator() = default;
  template <typename Other>
  KeepingAllocator(const KeepingAllocator<Other>&) {}
  T* allocate(size_t count) { return static_cast<T*>(::operator new(count * sizeof(T))); }
  void deallocate(T* freed, size_t) {
    restoreId(freed, 0);
    graveyard().push_back(freed);
  }

  friend bool operator==(const KeepingAllocator&, const KeepingAllocator&) { return true; }
  friend bool operator!=(const KeepingAllocator&, const KeepingAllocator&) { return false; }
};

constexpr double kMergeRatio = 1e-9;       // × the polygon's size: nodes this close are one event
constexpr size_t kStepsPerVertex = 10000;  // by far more than any sound skeleton takes

/// What the builder may still walk from halfedge to halfedge.
size_t& stepsLeft() {
  static thread_local size_t steps;
  return steps;
}

/// Where the builder has linked the halfedges wrongly, it would go round in a circle for ever, and
/// write down where it has been.
template <typename Refs>
class CountedHalfedge : public CGAL::Straight_skeleton_halfedge_base_2<Refs> {
 public:
  using Plain = CGAL::Straight_skeleton_halfedge_base_2<Refs>;
  using Handle = typename Refs::Halfedge_handle;
  using ConstHandle = typename Refs::Halfedge_const_handle;
  using Plain::Plain;

  Handle next() { return step(), Plain::next(); }
  ConstHandle next() const { return step(), Plain::next(); }
  Handle prev() { return step(), Plain::prev(); }
  ConstHandle prev() const { return step(), Plain::prev(); }

 private:
  static void step() {
    if (stepsLeft()-- == 0) throw std::length_error("the halfedges are wrongly linked");
  }
};

struct Items : CGAL::Straight_skeleton_items_2 {
  template <typename Refs, typename>
  struct Halfedge_wrapper {
    using Halfedge = CountedHalfedge<Refs>;
  };
};

using CgalSkeleton = CGAL::Straight_skeleton_2<Kernel, Items, KeepingAllocator<int>>;
using Event = CGAL::CGAL_SS_i::Event_2<CgalSkeleton, Traits>;

/// Among the simultaneous events of one vertex, which differ in their third edge alone, CGAL would
/// prefer the one with the higher address: another result, or none, in every run.
bool operator<(const boost::intrusive_ptr<Event>& a, const boost::intrusive_ptr<Event>& b) {
  return a->triedge().e2()->id() < b->triedge().e2()->id();
}

/// Bounds the last part of the building, which is where it goes round in circles.
struct Limit : CGAL::Dummy_straight_skeleton_builder_2_visitor<CgalSkeleton> {
  size_t steps;
  explicit Limit(size_t vertex_count) : steps(kStepsPerVertex * vertex_count) {
    stepsLeft() = std::numeric_limits<size_t>::max();
  }
  void on_cleanup_started() const { stepsLeft() = steps; }
};

using Builder = CGAL::Straight_skeleton_builder_2<Traits, CgalSkeleton, Limit>;

Result<StraightSkeleton> convert(const std::vector<Vec2>& polygon, const CgalSkeleton& cgal) {
  const uint32_t n = static_cast<uint32_t>(polygon.size());
  StraightSkeleton result;
  result.method = StraightSkeleton::Method::cgal;
  result.nodes = polygon;
  result.times.assign(n, 0);

  // CGAL numbers the contour's vertices first, in its order; removed ones leave gaps later on.
  std::map<int, uint32_t> node_of_vertex;
  for (auto v = cgal.vertices_begin(); v != cgal.vertices_end(); ++v) {
    const Vec2 at{v->point().x(), v->point().y()};
    if (v->is_contour()) {
      const uint32_t i = static_cast<uint32_t>(v->id());
      if (i >= n || polygon[i] != at) return Status::skeletonFailed;
      node_of_vertex[v->id()] = i;
    } else {
      const double time = v->time();
      if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(time)) {
        return Status::skeletonFailed;
      }
      node_of_vertex[v->id()] = static_cast<uint32_t>(result.nodes.size());
      result.nodes.push_back(at);
      result.times.push_back(time);
    }
  }

  std::map<int, uint32_t> border_of_face;
  for (auto f = cgal.faces_begin(); f != cgal.faces_end(); ++f) {
    const auto border = f->halfedge()->defining_contour_edge();
    border_of_face[f->id()] = node_of_vertex.at(border->opposite()->vertex()->id());
  }
  if (border_of_face.size() != n) return Status::skeletonFailed;

  for (uint32_t i = 0; i < n; ++i) {
    result.edges.push_back({i, (i + 1) % n, StraightSkeleton::Kind::border, i, i});
  }
  for (auto h = cgal.halfedges_begin(); h != cgal.halfedges_end(); ++h) {
    const auto twin = h->opposite();
    if (!h->is_bisector() || h->id() > twin->id()) continue;
    result.edges.push_back({node_of_vertex.at(twin->vertex()->id()),
                            node_of_vertex.at(h->vertex()->id()), StraightSkeleton::Kind::skeleton,
                            border_of_face.at(h->face()->id()),
                            border_of_face.at(twin->face()->id())});
  }
  return result;
}

/// Nodes of one event, which CGAL joins by arcs of no length, become one; names the arcs' kinds.
void mergeCoincidentNodes(StraightSkeleton& skeleton, uint32_t n, double tolerance) {
  std::vector<uint32_t> root(skeleton.nodes.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& e : skeleton.edges) {
    if (e.a < n || e.b < n) continue;
    if (distance(skeleton.nodes[e.a], skeleton.nodes[e.b]) > tolerance) continue;
    if (std::abs(skeleton.times[e.a] - skeleton.times[e.b]) > tolerance) continue;
    const uint32_t a = find(e.a), b = find(e.b);
    root[std::max(a, b)] = std::min(a, b);
  }

  std::vector<uint32_t> renamed(skeleton.nodes.size());
  uint32_t count = 0;
  for (uint32_t i = 0; i < skeleton.nodes.size(); ++i) {
    if (find(i) != i) continue;
    renamed[i] = count;
    skeleton.nodes[count] = skeleton.nodes[i];
    skeleton.times[count] = skeleton.times[i];
    ++count;
  }
  std::vector<StraightSkeleton::Edge> edges;
  for (auto e : skeleton.edges) {
    e.a = renamed[find(e.a)];
    e.b = renamed[find(e.b)];
    if (e.a == e.b) continue;
    if (e.kind != StraightSkeleton::Kind::border && (e.a < n || e.b < n)) {
      e.kind = StraightSkeleton::Kind::peripheral;
    }
    edges.push_back(e);
  }
  skeleton.nodes.resize(count);
  skeleton.times.resize(count);
  skeleton.edges = std::move(edges);
}

}  // namespace

Result<StraightSkeleton> straightSkeletonByCgal(const std::vector<Vec2>& polygon) {
  if (polygon.size() < 3) return Status::tooFewPoints;
  for (const Vec2 p : polygon) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return Status::notAPolygon;
  }
  if (!(signedArea(polygon) > 0) || !isSimple(polygon)) return Status::notAPolygon;

  const Undertaker after_all_else;
  try {
    std::vector<Kernel::Point_2> contour;
    contour.reserve(polygon.size());
    for (const Vec2 p : polygon) contour.emplace_back(p.x, p.y);
    const Limit limit(polygon.size());
    Builder builder(boost::none, Traits(), limit);
    builder.enter_contour(contour.begin(), contour.end());
    const auto cgal = builder.construct_skeleton();
    if (!cgal) return Status::skeletonFailed;

    auto result = convert(polygon, *cgal);
    if (!result) return result;
    const uint32_t n = static_cast<uint32_t>(polygon.size());
    mergeCoincidentNodes(*result, n, kMergeRatio * boxOf(polygon).longerSide());
    if (result->edges.size() != n + result->nodes.size() - 1) return Status::skeletonFailed;
    return result;
  } catch (...) {
    return Status::skeletonFailed;
  }
}

}  // namespace marrow
