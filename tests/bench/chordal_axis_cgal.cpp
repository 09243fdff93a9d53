#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include "bench/chordal_axis.h"

namespace marrow::bench {
namespace {

struct FaceInfo {
  bool outside = false;
  std::array<uint32_t, 3> middles{};  // of the edges opposite to the corners
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangles = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

void insertBorder(Triangles& triangles, const std::vector<Vec2>& polygon) {
  // Neighbours on the border are near each other: each is looked for from the one before, which is
  // faster than sorting them in space first.
  std::vector<Triangles::Vertex_handle> corners;
  corners.reserve(polygon.size());
  Triangles::Face_handle near{};
  for (const Vec2 p : polygon) {
    corners.push_back(triangles.insert(Kernel::Point_2(p.x, p.y), near));
    near = corners.back()->face();
  }
  for (size_t i = 0; i < corners.size(); ++i) {
    triangles.insert_constraint(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
  }
}

void markOutside(Triangles& triangles) {
  std::vector<Triangles::Face_handle> stack{triangles.infinite_face()};
  triangles.infinite_face()->info().outside = true;
  while (!stack.empty()) {
    const Triangles::Face_handle face = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Triangles::Face_handle other = face->neighbor(i);
      if (face->is_constrained(i) || other->info().outside) continue;
      other->info().outside = true;
      stack.push_back(other);
    }
  }
}

Vec2 cornerOf(Triangles::Face_handle face, int i) {
  const Kernel::Point_2& p = face->vertex(i)->point();
  return {p.x(), p.y()};
}

}  // namespace

ChordalAxis chordalAxis(const std::vector<Vec2>& polygon) {
  Triangles triangles;
  insertBorder(triangles, polygon);
  markOutside(triangles);

  ChordalAxis axis;
  axis.points.reserve(2 * polygon.size());
  axis.edges.reserve(2 * polygon.size());
  for (auto e = triangles.finite_edges_begin(); e != triangles.finite_edges_end(); ++e) {
    const auto [face, i] = *e;
    if (face->is_constrained(i) || face->info().outside) continue;
    const auto other = face->neighbor(i);
    const auto middle = static_cast<uint32_t>(axis.points.size());
    face->info().middles[i] = middle;
    other->info().middles[other->index(face)] = middle;
    axis.points.push_back((cornerOf(face, Triangles::cw(i)) + cornerOf(face, Triangles::ccw(i))) *
                          0.5);
  }
  for (auto face = triangles.finite_faces_begin(); face != triangles.finite_faces_end(); ++face) {
    if (face->info().outside) continue;
    std::array<uint32_t, 3> ends{};
    int open = 0, last_open = 0;
    for (int i = 0; i < 3; ++i) {
      if (face->is_constrained(i)) continue;
      ends[open++] = face->info().middles[i];
      last_open = i;
    }
    const auto next = static_cast<uint32_t>(axis.points.size());
    if (open == 1) {
      axis.points.push_back(cornerOf(face, last_open));
      axis.edges.push_back({ends[0], next});
    } else if (open == 2) {
      axis.edges.push_back({ends[0], ends[1]});
    } else if (open == 3) {
      axis.points.push_back((cornerOf(face, 0) + cornerOf(face, 1) + cornerOf(face, 2)) / 3);
      for (const uint32_t end : ends) axis.edges.push_back({end, next});
    }
  }
  return axis;
}

}  // namespace marrow::bench
