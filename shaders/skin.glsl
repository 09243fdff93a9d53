// Vertices that follow joints, as core/pose/skin.h has it. A joint has three texels: its rotation,
// how it moves, and its colour.
layout(location = 2) in vec4 a_weights;
layout(location = 3) in vec4 a_joints;

uniform int u_skinning;  // 0: not at all, 1: linear, 2: dual quaternions
uniform highp sampler2D u_joints;

vec4 jointTexel(float joint, int which) {
  int at = int(joint) * 3 + which;
  return texelFetch(u_joints, ivec2(at % 768, at / 768), 0);
}

vec3 turned(vec4 q, vec3 v) {
  vec3 twice = 2.0 * cross(q.xyz, v);
  return v + q.w * twice + cross(q.xyz, twice);
}

vec4 product(vec4 a, vec4 b) {
  return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}

void follow(inout vec3 position, inout vec3 normal) {
  if (u_skinning == 0 || a_weights.x == 0.0) return;
  vec4 first = jointTexel(a_joints.x, 0);
  if (u_skinning == 1) {
    vec3 place = vec3(0.0), direction = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
      if (a_weights[k] == 0.0) break;
      vec4 q = jointTexel(a_joints[k], 0);
      place += a_weights[k] * (turned(q, position) + jointTexel(a_joints[k], 1).xyz);
      direction += a_weights[k] * turned(q, normal);
    }
    position = place;
    normal = normalize(direction);
    return;
  }
  vec4 real = vec4(0.0), dual = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    if (a_weights[k] == 0.0) break;
    vec4 q = jointTexel(a_joints[k], 0);
    vec4 d = 0.5 * product(vec4(jointTexel(a_joints[k], 1).xyz, 0.0), q);
    float weight = dot(first, q) < 0.0 ? -a_weights[k] : a_weights[k];
    real += weight * q;
    dual += weight * d;
  }
  float size = length(real);
  real /= size;
  dual /= size;
  position = turned(real, position) + 2.0 * product(dual, vec4(-real.xyz, real.w)).xyz;
  normal = turned(real, normal);
}

/// The colours of the joints that hold a vertex.
vec3 jointColor() {
  vec3 color = vec3(0.0);
  for (int k = 0; k < 4; ++k) color += a_weights[k] * jointTexel(a_joints[k], 2).rgb;
  return color;
}
