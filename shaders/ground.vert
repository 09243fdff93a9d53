// The ground below the parts, carrying their shadow. It leans a little towards a viewer who looks
// along it, as grounds in picture books do, so that the shadow can be seen from the front.
uniform mat3 u_rotation;
uniform vec3 u_scale;
uniform vec4 u_box;      // x, z of the middle; half width, half depth
uniform float u_height;  // y of the ground
uniform vec2 u_towards;  // x, z towards the viewer, times the lean

out vec2 v_position;

void main() {
  v_position = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  vec2 from_middle = (v_position * 2.0 - 1.0) * u_box.zw;
  vec2 ground = u_box.xy + from_middle;
  vec3 model = vec3(ground.x, u_height - dot(from_middle, u_towards), ground.y);
  gl_Position = vec4(u_rotation * model * u_scale, 1.0);
}
