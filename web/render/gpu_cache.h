// Meshes on the GPU: a cache keyed by mesh id. Nothing is lost when it is thrown away.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "part/part.h"
#include "render/gl.h"

namespace marrow {

struct GpuMesh {
  GlVertexArray vertex_array;  // location 0: position, 1: normal; both from the origin below
  GlBuffer vertices, triangles;
  GlVertexArray edge_array;  // the same vertices, with every edge once as a line
  GlBuffer edges;
  GLsizei triangle_indices = 0, edge_indices = 0;
  Vec3 origin;  // what was subtracted from the positions before they became float
};

class GpuCache {
 public:
  /// Uploads what is drawn for the first time.
  const GpuMesh& mesh(uint64_t id, const Part& part);
  /// The same with its edges.
  const GpuMesh& meshWithEdges(uint64_t id, const Part& part);
  /// Call once a frame: meshes that were not asked for in a while are dropped.
  void endFrame();
  size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    GpuMesh mesh;
    uint64_t last_used = 0;
  };
  Entry& entry(uint64_t id, const Part& part);

  std::unordered_map<uint64_t, Entry> entries_;
  std::vector<GpuMesh> spare_;  // buffers to be filled again
  uint64_t frame_ = 0;
};

}  // namespace marrow
