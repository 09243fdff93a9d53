// A triangle that covers the canvas, without any buffer.
out vec2 v_position;  // 0 … 1

void main() {
  v_position = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(v_position * 2.0 - 1.0, 0.0, 1.0);
}
