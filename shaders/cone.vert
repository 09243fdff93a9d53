// One instance the part of a cone that touches two balls.
layout(location = 0) in vec3 a_position;  // x: 0 or 1 along; y, z: on the unit circle
layout(location = 1) in vec3 i_a;
layout(location = 2) in vec3 i_b;
layout(location = 3) in vec2 i_radii;
layout(location = 4) in vec4 i_color;

uniform mat3 u_rotation;
uniform vec3 u_scale;

out vec3 v_normal;
flat out vec4 v_color;

void main() {
  vec3 along = i_b - i_a;
  float span = max(length(along), 1e-6);
  vec3 direction = along / span;
  vec3 helper = abs(direction.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 side = normalize(cross(helper, direction));
  vec3 other = cross(direction, side);
  // The line that touches both balls leans by this against the axis.
  float lean = clamp((i_radii.x - i_radii.y) / span, -1.0, 1.0);
  vec3 normal = (side * a_position.y + other * a_position.z) * sqrt(1.0 - lean * lean) +
                direction * lean;
  bool at_b = a_position.x > 0.5;
  vec3 model = (at_b ? i_b : i_a) + normal * (at_b ? i_radii.y : i_radii.x);
  v_normal = u_rotation * normal;
  v_color = i_color;
  gl_Position = vec4(u_rotation * model * u_scale, 1.0);
}
