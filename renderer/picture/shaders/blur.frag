#version 450 core

// One direction of a Gaussian blur: wide for the light from all around (red), narrow for the key light's shadow (green).

layout(location = 0) out vec2 result;
layout(location = 0) uniform ivec2 direction;
layout(binding = 0) uniform sampler2D picture;

void main() {
  ivec2 last = textureSize(picture, 0) - 1;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 sum = vec2(0.0);
  vec2 weights = vec2(0.0);
  for (int i = -4; i <= 4; ++i) {
    vec2 weight = vec2(exp(-0.14 * float(i * i)), exp(-0.15 * float(i * i)));
    sum.r += weight.r * texelFetch(picture, clamp(pixel + 2 * i * direction, ivec2(0), last), 0).r;
    sum.g += weight.g * texelFetch(picture, clamp(pixel + i * direction, ivec2(0), last), 0).g;
    weights += weight;
  }
  result = sum / weights;
}
