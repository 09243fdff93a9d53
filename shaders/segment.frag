// Round ends and soft edges.
precision highp float;

uniform float u_dpr;

in vec2 v_along;
flat in float v_length;
flat in float v_radius;
flat in vec4 v_color;
out vec4 o_color;

void main() {
  vec2 from_axis = vec2(v_along.x - clamp(v_along.x, 0.0, v_length), v_along.y);
  float coverage = clamp((v_radius - length(from_axis)) * u_dpr + 0.5, 0.0, 1.0);
  o_color = vec4(v_color.rgb, v_color.a * coverage);
}
