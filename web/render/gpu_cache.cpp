#include "render/gpu_cache.h"

#include <algorithm>
#include <array>

namespace marrow {
namespace {

// Undo and redo find their meshes still there; a live preview leaves one behind each frame.
constexpr uint64_t kFramesKept = 8;

void bindVertexLayout() {
  const GLsizei stride = 6 * sizeof(float);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride,
                        reinterpret_cast<const void*>(3 * sizeof(float)));
}

GpuMesh makeMesh() {
  GpuMesh mesh;
  mesh.vertices = makeBuffer();
  mesh.triangles = makeBuffer();
  mesh.vertex_array = makeVertexArray();
  glBindVertexArray(mesh.vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles.name());
  bindVertexLayout();
  glBindVertexArray(0);
  return mesh;
}

void fill(GpuMesh& gpu, const Part& part) {
  const std::vector<Vec3>& positions = part.mesh.positions;
  gpu.origin = positions.empty() ? Vec3{} : positions.front();
  std::vector<float> vertices;
  vertices.reserve(positions.size() * 6);
  for (size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = positions[i] - gpu.origin;
    const Vec3 n = part.normals[i];
    for (const double value : {p.x, p.y, p.z, n.x, n.y, n.z}) {
      vertices.push_back(static_cast<float>(value));
    }
  }
  gpu.triangle_indices = static_cast<GLsizei>(part.mesh.triangles.size() * 3);
  gpu.edge_indices = 0;
  glBindVertexArray(gpu.vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
               vertices.data(), GL_DYNAMIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(part.mesh.triangles.size() * 3 * sizeof(uint32_t)),
               part.mesh.triangles.data(), GL_DYNAMIC_DRAW);
  glBindVertexArray(0);
}

void fillEdges(GpuMesh& gpu, const Part& part) {
  std::vector<uint32_t> lines;
  lines.reserve(part.mesh.triangles.size() * 3);
  for (const auto& triangle : part.mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      if (a < b) {  // the triangle on the other side has it the other way round
        lines.push_back(a);
        lines.push_back(b);
      }
    }
  }
  if (!gpu.edge_array) {
    gpu.edges = makeBuffer();
    gpu.edge_array = makeVertexArray();
    glBindVertexArray(gpu.edge_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.name());
    bindVertexLayout();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.edges.name());
  }
  glBindVertexArray(gpu.edge_array.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(lines.size() * sizeof(uint32_t)),
               lines.data(), GL_DYNAMIC_DRAW);
  glBindVertexArray(0);
  gpu.edge_indices = static_cast<GLsizei>(lines.size());
}

}  // namespace

GpuCache::Entry& GpuCache::entry(uint64_t id, const Part& part) {
  const auto [found, is_new] = entries_.try_emplace(id);
  Entry& entry = found->second;
  if (is_new) {
    if (spare_.empty()) {
      entry.mesh = makeMesh();
    } else {
      entry.mesh = std::move(spare_.back());
      spare_.pop_back();
    }
    fill(entry.mesh, part);
  }
  entry.last_used = frame_;
  return entry;
}

const GpuMesh& GpuCache::mesh(uint64_t id, const Part& part) { return entry(id, part).mesh; }

const GpuMesh& GpuCache::meshWithEdges(uint64_t id, const Part& part) {
  GpuMesh& mesh = entry(id, part).mesh;
  if (mesh.edge_indices == 0) fillEdges(mesh, part);
  return mesh;
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
