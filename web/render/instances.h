// Many copies of one small shape, each with its own values.
#pragma once

#include <cstddef>
#include <vector>

#include "render/gl.h"

namespace marrow {

/// A shape's vertices and the numbers of floats of its attributes, from location 0 on.
struct Shape {
  std::vector<float> vertices;
  std::vector<int> attributes;
};

Shape segmentShape();     // two triangles; x: 0 or 1 along, y: −1 or 1 to the sides
Shape octahedronShape();  // position, barycentric coordinates
Shape sphereShape();      // position on the unit sphere
Shape tubeShape();        // x: 0 or 1 along; y, z on the unit circle

class Instances {
 public:
  /// attributes: floats of each value of an instance, from the location after the shape's on.
  Instances(const Shape& shape, const std::vector<int>& attributes);

  /// Item: a struct of floats alone, with the attributes in their order.
  template <typename Item>
  void draw(const std::vector<Item>& items) const {
    drawBytes(items.data(), items.size(), sizeof(Item));
  }

 private:
  void drawBytes(const void* data, size_t count, size_t stride) const;

  GlVertexArray vertex_array_;
  GlBuffer shape_, instances_;
  GLsizei vertices_ = 0;
  size_t floats_ = 0;  // of an instance
};

}  // namespace marrow
