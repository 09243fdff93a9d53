#include "render/gpu_cache.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace marrow {
namespace {

// Undo and redo find their meshes still there; a live preview leaves one behind each frame.
constexpr uint64_t kFramesKept = 8;

const void* at(size_t bytes) { return reinterpret_cast<const void*>(bytes); }

/// Floats of a vertex: position, normal, and where that is another one the hull's.
size_t floatsOf(const Part& part) { return part.imported ? 9 : 6; }

void bindLayout(const Part* part) {
  const size_t size = floatsOf(*part);
  const auto stride = static_cast<GLsizei>(size * sizeof(float));
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, at(3 * sizeof(float)));
  glVertexAttribPointer(4, 3, GL_FLOAT, GL_FALSE, stride, at((size - 3) * sizeof(float)));
  for (const GLuint location : {0u, 1u, 4u}) glEnableVertexAttribArray(location);
  for (const GLuint location : {2u, 3u}) glDisableVertexAttribArray(location);
}

void bindLayout(const Figure*) {
  using Vertex = Figure::Vertex;
  const GLsizei stride = sizeof(Vertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(Vertex, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(Vertex, normal)));
  glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, stride, at(offsetof(Vertex, weights)));
  glVertexAttribPointer(3, 4, GL_UNSIGNED_SHORT, GL_FALSE, stride, at(offsetof(Vertex, joints)));
  glVertexAttribPointer(4, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(Vertex, hull)));
  for (const GLuint location : {0u, 1u, 2u, 3u, 4u}) glEnableVertexAttribArray(location);
}

GpuMesh makeMesh() {
  GpuMesh mesh;
  mesh.vertices = makeBuffer();
  mesh.triangles = makeBuffer();
  mesh.vertex_array = makeVertexArray();
  return mesh;
}

/// The bytes of the vertices, as bindLayout has them.
std::vector<float> verticesOf(const Part& part, Vec3 origin) {
  std::vector<float> vertices;
  const auto put = [&](Vec3 v) {
    for (const double value : {v.x, v.y, v.z}) vertices.push_back(static_cast<float>(value));
  };
  const size_t count = part.imported ? part.shown.vertices.size() : part.mesh.positions.size();
  vertices.reserve(count * floatsOf(part));
  for (size_t i = 0; i < count; ++i) {
    const size_t vertex = part.imported ? part.shown.vertices[i] : i;
    put(part.mesh.positions[vertex] - origin);
    if (part.imported) put(part.shown.normals[i]);
    put(part.normals[vertex]);
  }
  return vertices;
}
const std::vector<Figure::Vertex>& verticesOf(const Figure& figure, Vec3) {
  return figure.vertices;
}

Vec3 originOf(const Part& part) {
  return part.mesh.positions.empty() ? Vec3{} : part.mesh.positions.front();
}
Vec3 originOf(const Figure& figure) { return figure.origin; }

const auto& trianglesOf(const Part& part) {
  return part.imported ? part.shown.triangles : part.mesh.triangles;
}
const auto& trianglesOf(const Figure& figure) { return figure.triangles; }

/// Those that tell which sides are the same edge.
const auto& surfaceOf(const Part& part) { return part.mesh.triangles; }
const auto& surfaceOf(const Figure& figure) { return figure.triangles; }

template <typename T>
void upload(GLenum target, const std::vector<T>& items) {
  glBufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(T)), items.data(),
               GL_DYNAMIC_DRAW);
}

template <typename Source>
void fill(GpuMesh& gpu, const Source& source) {
  gpu.origin = originOf(source);
  gpu.triangle_indices = static_cast<GLsizei>(trianglesOf(source).size() * 3);
  gpu.edge_indices = 0;
  glBindVertexArray(gpu.vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.triangles.name());
  bindLayout(&source);
  upload(GL_ARRAY_BUFFER, verticesOf(source, gpu.origin));
  upload(GL_ELEMENT_ARRAY_BUFFER, trianglesOf(source));
  glBindVertexArray(0);
}

template <typename Source>
void fillEdges(GpuMesh& gpu, const Source& source) {
  std::vector<uint32_t> lines;
  lines.reserve(trianglesOf(source).size() * 3);
  for (size_t t = 0; t < trianglesOf(source).size(); ++t) {
    const auto& triangle = trianglesOf(source)[t];
    const auto& vertices = surfaceOf(source)[t];
    for (size_t k = 0; k < 3; ++k) {
      // The triangle on the other side has it the other way round.
      if (vertices[k] < vertices[(k + 1) % 3]) {
        lines.push_back(triangle[k]);
        lines.push_back(triangle[(k + 1) % 3]);
      }
    }
  }
  if (!gpu.edge_array) {
    gpu.edges = makeBuffer();
    gpu.edge_array = makeVertexArray();
  }
  glBindVertexArray(gpu.edge_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.edges.name());
  bindLayout(&source);
  upload(GL_ELEMENT_ARRAY_BUFFER, lines);
  glBindVertexArray(0);
  gpu.edge_indices = static_cast<GLsizei>(lines.size());
}

}  // namespace

template <typename Source>
GpuMesh& GpuCache::find(uint64_t id, const Source& source) {
  const auto [found, is_new] = entries_.try_emplace(id);
  Entry& entry = found->second;
  if (is_new) {
    if (spare_.empty()) {
      entry.mesh = makeMesh();
    } else {
      entry.mesh = std::move(spare_.back());
      spare_.pop_back();
    }
    fill(entry.mesh, source);
  }
  entry.last_used = frame_;
  return entry.mesh;
}

template <typename Source>
GpuMesh& GpuCache::findWithEdges(uint64_t id, const Source& source) {
  GpuMesh& mesh = find(id, source);
  if (mesh.edge_indices == 0) fillEdges(mesh, source);
  return mesh;
}

const GpuMesh& GpuCache::mesh(uint64_t id, const Part& part) { return find(id, part); }
const GpuMesh& GpuCache::mesh(uint64_t id, const Figure& figure) { return find(id, figure); }
const GpuMesh& GpuCache::meshWithEdges(uint64_t id, const Part& part) {
  return findWithEdges(id, part);
}
const GpuMesh& GpuCache::meshWithEdges(uint64_t id, const Figure& figure) {
  return findWithEdges(id, figure);
}

void GpuCache::endFrame() {
  ++frame_;
  for (auto it = entries_.begin(); it != entries_.end();) {
    if (it->second.last_used + kFramesKept >= frame_) {
      ++it;
      continue;
    }
    if (spare_.size() < kFramesKept) spare_.push_back(std::move(it->second.mesh));
    it = entries_.erase(it);
  }
}

}  // namespace marrow
