precision highp float;

uniform sampler2D u_picture;
uniform vec4 u_color;

in vec2 v_position;
out vec4 o_color;

void main() { o_color = vec4(u_color.rgb, u_color.a * texture(u_picture, v_position).r); }
