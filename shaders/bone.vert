// One instance a bone: an octahedron, wide near its head.
layout(location = 0) in vec3 a_position;  // x along the bone, 0 … 1; y, z: in its radius
layout(location = 1) in vec3 a_edge;      // barycentric: zero on one edge of the triangle
layout(location = 2) in vec3 i_head;
layout(location = 3) in vec3 i_tail;
layout(location = 4) in float i_radius;
layout(location = 5) in vec4 i_color;

uniform mat3 u_rotation;
uniform vec3 u_scale;

out vec3 v_view;
out vec3 v_edge;
flat out vec4 v_color;

void main() {
  vec3 along = i_tail - i_head;
  vec3 direction = normalize(along);
  vec3 helper = abs(direction.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 side = normalize(cross(helper, direction));
  vec3 other = cross(direction, side);
  vec3 model = i_head + along * a_position.x + (side * a_position.y + other * a_position.z) * i_radius;
  v_view = u_rotation * model;
  v_edge = a_edge;
  v_color = i_color;
  gl_Position = vec4(v_view * u_scale, 1.0);
}
