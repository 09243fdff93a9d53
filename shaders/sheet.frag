// Fades out towards the rim.
precision highp float;

uniform vec4 u_color;

in vec2 v_place;
out vec4 o_color;

void main() {
  float rim = max(abs(v_place.x), abs(v_place.y));
  o_color = vec4(u_color.rgb, u_color.a * (1.0 - smoothstep(0.75, 1.0, rim)));
}
