// A picture on a sheet, its first row above.
precision highp float;

uniform sampler2D u_picture;
uniform float u_opacity;

in vec2 v_place;
out vec4 o_color;

void main() {
  vec4 color = texture(u_picture, vec2(0.5 + 0.5 * v_place.x, 0.5 - 0.5 * v_place.y));
  o_color = vec4(color.rgb, color.a * u_opacity);
}
