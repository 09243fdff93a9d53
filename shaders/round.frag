// Balls and cones: soft light, a darker rim.
precision highp float;

uniform vec3 u_edge_color;
uniform float u_edge;  // where the rim begins: 0 … 1 of the ball's radius

in vec3 v_normal;
flat in vec4 v_color;
out vec4 o_color;

void main() {
  vec3 n = normalize(v_normal);
  float lit = 0.80 + 0.20 * dot(n, vec3(-0.45, 0.60, 0.66));
  float rim = smoothstep(u_edge, min(u_edge + 0.1, 1.0), length(n.xy));
  o_color = vec4(mix(v_color.rgb * lit, u_edge_color, rim), v_color.a);
}
