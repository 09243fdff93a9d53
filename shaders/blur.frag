// One direction of a Gaussian blur.
precision highp float;

uniform sampler2D u_picture;
uniform vec2 u_step;  // texels to the next sample

in vec2 v_position;
out vec4 o_color;

void main() {
  float sum = 0.0;
  float weights = 0.0;
  for (int i = -8; i <= 8; ++i) {
    float weight = exp(-float(i * i) / 26.0);
    sum += weight * texture(u_picture, v_position + u_step * float(i)).r;
    weights += weight;
  }
  o_color = vec4(sum / weights);
}
