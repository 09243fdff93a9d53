#include "render/instances.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace marrow {
namespace {

constexpr float kTurn = 6.28318531f;

using Point = std::array<float, 3>;

Point onSphere(int ring, int rings, int step, int steps) {
  const float polar = 0.5f * kTurn * static_cast<float>(ring) / static_cast<float>(rings);
  const float around = kTurn * static_cast<float>(step) / static_cast<float>(steps);
  return {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
}

void append(std::vector<float>& vertices, const Point& point) {
  vertices.insert(vertices.end(), point.begin(), point.end());
}

GLsizei total(const std::vector<int>& attributes) {
  GLsizei sum = 0;
  for (const int floats : attributes) sum += floats;
  return sum;
}

// Points the attributes from `location` on at the buffer that is bound.
void layOut(const std::vector<int>& attributes, GLuint location, GLuint divisor) {
  const GLsizei stride = total(attributes) * static_cast<GLsizei>(sizeof(float));
  uintptr_t offset = 0;
  for (const int floats : attributes) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
    offset += static_cast<uintptr_t>(floats) * sizeof(float);
    ++location;
  }
}

}  // namespace

Shape segmentShape() { return {{0, -1, 1, -1, 0, 1, 0, 1, 1, -1, 1, 1}, {2}}; }

Shape octahedronShape() {
  constexpr float kWaist = 0.14f;  // of the length, from the head
  const Point head{0, 0, 0}, tail{1, 0, 0};
  const std::array<Point, 4> ring{Point{kWaist, 1, 0}, Point{kWaist, 0, 1}, Point{kWaist, -1, 0},
                                  Point{kWaist, 0, -1}};
  const std::array<Point, 3> corners{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  Shape shape{{}, {3, 3}};
  for (size_t k = 0; k < 4; ++k) {
    const Point& a = ring[k];
    const Point& b = ring[(k + 1) % 4];
    const std::array<std::array<Point, 3>, 2> faces{std::array<Point, 3>{head, b, a},
                                                    std::array<Point, 3>{tail, a, b}};
    for (const auto& face : faces) {
      for (size_t corner = 0; corner < 3; ++corner) {
        append(shape.vertices, face[corner]);
        append(shape.vertices, corners[corner]);
      }
    }
  }
  return shape;
}

Shape sphereShape() {
  constexpr int kRings = 10, kSteps = 20;
  Shape shape{{}, {3}};
  for (int ring = 0; ring < kRings; ++ring) {
    for (int step = 0; step < kSteps; ++step) {
      const Point a = onSphere(ring, kRings, step, kSteps);
      const Point b = onSphere(ring + 1, kRings, step, kSteps);
      const Point c = onSphere(ring + 1, kRings, step + 1, kSteps);
      const Point d = onSphere(ring, kRings, step + 1, kSteps);
      for (const Point& point : {a, b, c, a, c, d}) append(shape.vertices, point);
    }
  }
  return shape;
}

Shape tubeShape() {
  constexpr int kSteps = 28;
  Shape shape{{}, {3}};
  for (int step = 0; step < kSteps; ++step) {
    const float from = kTurn * static_cast<float>(step) / kSteps;
    const float to = kTurn * static_cast<float>(step + 1) / kSteps;
    const Point a{0, std::cos(from), std::sin(from)}, b{0, std::cos(to), std::sin(to)};
    const Point c{1, b[1], b[2]}, d{1, a[1], a[2]};
    for (const Point& point : {a, c, b, a, d, c}) append(shape.vertices, point);
  }
  return shape;
}

Instances::Instances(const Shape& shape, const std::vector<int>& attributes)
    : vertex_array_(makeVertexArray()),
      shape_(makeBuffer()),
      instances_(makeBuffer()),
      vertices_(static_cast<GLsizei>(shape.vertices.size()) / total(shape.attributes)),
      floats_(static_cast<size_t>(total(attributes))) {
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, shape_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.vertices.size() * sizeof(float)),
               shape.vertices.data(), GL_STATIC_DRAW);
  layOut(shape.attributes, 0, 0);
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  layOut(attributes, static_cast<GLuint>(shape.attributes.size()), 1);
  glBindVertexArray(0);
}

void Instances::drawBytes(const void* data, size_t count, size_t stride) const {
  if (count == 0) return;
  assert(stride == floats_ * sizeof(float));
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * stride), data, GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertices_, static_cast<GLsizei>(count));
  glBindVertexArray(0);
}

}  // namespace marrow
