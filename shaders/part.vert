// A part's mesh; with u_outline_px > 0 its hull, pushed outward by so much on the screen.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat3 u_rotation;     // part → view
uniform float u_size;        // model units per unit of the part
uniform vec3 u_offset;       // of the mesh from the camera's target, in the view
uniform vec3 u_scale;        // view → clip
uniform vec2 u_pixel;        // one CSS pixel in clip space
uniform float u_outline_px;

out vec3 v_normal;  // view space

void main() {
  v_normal = u_rotation * a_normal;
  vec3 view = u_rotation * (a_position * u_size) + u_offset;
  gl_Position = vec4(view * u_scale, 1.0);
  float flatness = length(v_normal.xy);
  if (u_outline_px > 0.0 && flatness > 1e-4) {
    gl_Position.xy += v_normal.xy / flatness * u_outline_px * u_pixel;
  }
}
