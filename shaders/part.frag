// Soft toon shading from the view-space normal alone: the light comes along with the viewer.
precision highp float;

uniform vec4 u_color;
uniform int u_weights;  // 0: the part's colour, 1: those of the joints, 2: how much one joint holds

in vec3 v_normal;
in vec3 v_joint_color;
out vec4 o_color;

const vec3 kLight = vec3(-0.381, 0.572, 0.726);
const vec3 kShade = vec3(0.70, 0.66, 0.80);

// Even to the eye and for the colour-blind: from dark blue over violet and orange to light yellow.
vec3 heat(float weight) {
  vec3 a = vec3(0.16, 0.17, 0.42), b = vec3(0.58, 0.20, 0.52), c = vec3(0.93, 0.45, 0.25);
  vec3 d = vec3(0.99, 0.92, 0.55);
  float t = clamp(weight, 0.0, 1.0) * 3.0;
  return t < 1.0 ? mix(a, b, t) : t < 2.0 ? mix(b, c, t - 1.0) : mix(c, d, t - 2.0);
}

void main() {
  vec3 base = u_weights == 0 ? u_color.rgb : u_weights == 1 ? v_joint_color : heat(v_joint_color.r);
  vec3 n = normalize(v_normal);
  float lit = 0.5 + 0.5 * dot(n, kLight);
  float band = 0.40 * smoothstep(0.22, 0.46, lit) + 0.60 * smoothstep(0.50, 0.86, lit);
  vec3 color = base * mix(kShade, vec3(1.0), band);
  color += 0.10 * smoothstep(0.72, 1.0, lit) * (1.0 - color);
  float rim = smoothstep(0.55, 1.0, 1.0 - max(n.z, 0.0));
  color *= 1.0 - 0.16 * rim;
  o_color = vec4(color, u_color.a);
}
