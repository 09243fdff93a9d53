precision highp float;

uniform sampler2D u_fonts;

in vec2 v_texture;
in vec4 v_color;
out vec4 o_color;

void main() { o_color = v_color * texture(u_fonts, v_texture); }
