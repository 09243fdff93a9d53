precision highp float;

uniform vec3 u_top;
uniform vec3 u_bottom;

in vec2 v_position;
out vec4 o_color;

void main() {
  // A little noise hides the steps of the gradient.
  float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
  o_color = vec4(mix(u_bottom, u_top, v_position.y) + noise / 255.0, 1.0);
}
