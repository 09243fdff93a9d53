// One instance a ball.
layout(location = 0) in vec3 a_position;  // on the unit sphere
layout(location = 1) in vec3 i_center;
layout(location = 2) in float i_radius;
layout(location = 3) in vec4 i_color;

uniform mat3 u_rotation;
uniform vec3 u_scale;

out vec3 v_normal;
flat out vec4 v_color;

void main() {
  v_normal = u_rotation * a_position;
  v_color = i_color;
  gl_Position = vec4(u_rotation * (i_center + a_position * i_radius) * u_scale, 1.0);
}
