// One instance a line segment, grown to a rectangle on the screen.
layout(location = 0) in vec2 a_corner;  // x: 0 at a, 1 at b; y: −1 or 1 to the sides
layout(location = 1) in vec3 i_a;
layout(location = 2) in vec3 i_b;
layout(location = 3) in float i_width_px;
layout(location = 4) in vec4 i_color;

uniform mat3 u_rotation;
uniform vec3 u_scale;
uniform vec2 u_pixel;

out vec2 v_along;  // CSS pixels from a along the segment, and to the side
flat out float v_length;
flat out float v_radius;
flat out vec4 v_color;

void main() {
  vec3 a = u_rotation * i_a * u_scale;
  vec3 b = u_rotation * i_b * u_scale;
  vec2 a_px = a.xy / u_pixel;
  vec2 b_px = b.xy / u_pixel;
  v_length = distance(a_px, b_px);
  vec2 along = v_length > 1e-6 ? (b_px - a_px) / v_length : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  v_radius = 0.5 * i_width_px;
  float reach = v_radius + 1.0;
  v_along = vec2(a_corner.x * v_length + (a_corner.x * 2.0 - 1.0) * reach, a_corner.y * reach);
  v_color = i_color;
  vec2 px = a_px + along * v_along.x + side * v_along.y;
  gl_Position = vec4(px * u_pixel, mix(a.z, b.z, a_corner.x), 1.0);
}
