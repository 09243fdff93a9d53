// A part's mesh seen from above, into the shadow's own picture.
layout(location = 0) in vec3 a_position;

uniform mat3 u_rotation;  // part → model
uniform float u_size;
uniform vec3 u_offset;
uniform vec4 u_box;  // x, z of the middle; half width, half depth

void main() {
  vec3 model = u_rotation * (a_position * u_size) + u_offset;
  gl_Position = vec4((model.xz - u_box.xy) / u_box.zw, 0.0, 1.0);
}
