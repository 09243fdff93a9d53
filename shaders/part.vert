// A part's mesh, or the whole figure as it is posed; with u_outline_px > 0 its hull, pushed outward
// by so much on the screen.
#include "skin.glsl"
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 4) in vec3 a_hull;  // the same in all copies of a vertex, so that no gap opens

uniform mat3 u_rotation;     // part → view
uniform float u_size;        // model units per unit of the part
uniform vec3 u_offset;       // of the mesh from the camera's target, in the view
uniform vec3 u_scale;        // view → clip
uniform vec2 u_pixel;        // one CSS pixel in clip space
uniform float u_outline_px;

out vec3 v_normal;  // view space
out vec3 v_joint_color;

void main() {
  vec3 position = a_position, normal = u_outline_px > 0.0 ? a_hull : a_normal;
  follow(position, normal);
  v_joint_color = u_skinning == 0 ? vec3(0.0) : jointColor();
  v_normal = u_rotation * normal;
  vec3 view = u_rotation * (position * u_size) + u_offset;
  gl_Position = vec4(view * u_scale, 1.0);
  float flatness = length(v_normal.xy);
  if (u_outline_px > 0.0 && flatness > 1e-4) {
    gl_Position.xy += v_normal.xy / flatness * u_outline_px * u_pixel;
  }
}
