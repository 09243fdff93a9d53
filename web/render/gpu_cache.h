// Meshes on the GPU: a cache keyed by mesh id. Nothing is lost when it is thrown away.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "figure/figure.h"
#include "part/part.h"
#include "render/gl.h"

namespace marrow {

struct GpuMesh {
  /// Location 0: position from the origin below, 1: normal, 4: the hull's, smooth also at sharp
  /// edges; of figures also 2: weights, 3: joints.
  GlVertexArray vertex_array;
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
  const GpuMesh& mesh(uint64_t id, const Figure& figure);
  /// The same with its edges.
  const GpuMesh& meshWithEdges(uint64_t id, const Part& part);
  const GpuMesh& meshWithEdges(uint64_t id, const Figure& figure);
  /// Call once a frame: meshes that were not asked for in a while are dropped.
  void endFrame();
  size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    GpuMesh mesh;
    uint64_t last_used = 0;
  };
  template <typename Source>
  GpuMesh& find(uint64_t id, const Source& source);
  template <typename Source>
  GpuMesh& findWithEdges(uint64_t id, const Source& source);

  std::unordered_map<uint64_t, Entry> entries_;
  std::vector<GpuMesh> spare_;  // buffers to be filled again
  uint64_t frame_ = 0;
};

}  // namespace marrow
