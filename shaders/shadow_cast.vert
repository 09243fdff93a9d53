// A part's mesh, or the figure, seen from above, into the shadow's own picture.
#include "skin.glsl"
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat3 u_rotation;  // part → model
uniform float u_size;
uniform vec3 u_offset;
uniform vec4 u_box;  // x, z of the middle; half width, half depth

void main() {
  vec3 position = a_position, normal = a_normal;
  follow(position, normal);
  vec3 model = u_rotation * (position * u_size) + u_offset;
  gl_Position = vec4((model.xz - u_box.xy) / u_box.zw, 0.0, 1.0);
}
