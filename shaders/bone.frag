// Flat faces with dark edges.
precision highp float;

uniform vec3 u_edge_color;
uniform float u_dpr;

in vec3 v_view;
in vec3 v_edge;
flat in vec4 v_color;
out vec4 o_color;

void main() {
  vec3 n = normalize(cross(dFdx(v_view), dFdy(v_view)));
  float lit = 0.78 + 0.22 * dot(n, vec3(-0.45, 0.60, 0.66));
  vec3 px = v_edge / max(fwidth(v_edge), vec3(1e-6));
  float edge = 1.0 - smoothstep(0.4 * u_dpr, 1.2 * u_dpr, min(px.x, min(px.y, px.z)));
  o_color = vec4(mix(v_color.rgb * lit, u_edge_color, edge), v_color.a);
}
