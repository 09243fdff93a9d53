// Soft toon shading from the view-space normal alone: the light comes along with the viewer.
precision highp float;

uniform vec4 u_color;

in vec3 v_normal;
out vec4 o_color;

const vec3 kLight = vec3(-0.381, 0.572, 0.726);
const vec3 kShade = vec3(0.70, 0.66, 0.80);

void main() {
  vec3 n = normalize(v_normal);
  float lit = 0.5 + 0.5 * dot(n, kLight);
  float band = 0.40 * smoothstep(0.22, 0.46, lit) + 0.60 * smoothstep(0.50, 0.86, lit);
  vec3 color = u_color.rgb * mix(kShade, vec3(1.0), band);
  color += 0.10 * smoothstep(0.72, 1.0, lit) * (1.0 - color);
  float rim = smoothstep(0.55, 1.0, 1.0 - max(n.z, 0.0));
  color *= 1.0 - 0.16 * rim;
  o_color = vec4(color, u_color.a);
}
