// A rectangle in space.
uniform vec3 u_center;  // in the view, model units
uniform vec3 u_x;       // from the centre to its sides
uniform vec3 u_y;
uniform vec3 u_scale;

out vec2 v_place;  // −1 … 1 over the rectangle

void main() {
  v_place = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  gl_Position = vec4((u_center + u_x * v_place.x + u_y * v_place.y) * u_scale, 1.0);
}
