#version 450 core

// One direction of a Gaussian blur.

layout(location = 0) out float result;
layout(location = 0) uniform ivec2 direction;
layout(binding = 0) uniform sampler2D picture;

void main() {
  ivec2 last = textureSize(picture, 0) - 1;
  float sum = 0.0;
  float weights = 0.0;
  for (int i = -6; i <= 6; ++i) {
    float weight = exp(-0.09 * float(i * i));
    sum += weight * texelFetch(picture, clamp(ivec2(gl_FragCoord.xy) + i * direction, ivec2(0), last), 0).r;
    weights += weight;
  }
  result = sum / weights;
}
