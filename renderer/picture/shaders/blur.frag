#version 450 core

// One direction of a Gaussian blur: wide for the light from all around (red), narrow for the key light's shadow (green).

layout(location = 0) out vec2 result;
layout(location = 0) uniform ivec2 direction;
layout(binding = 0) uniform sampler2D picture;

// By the distance from the middle: of exp(-0.14 i^2) and exp(-0.15 i^2) the parts of their sums.
const vec2 kWeights[5] = vec2[](vec2(0.2145297, 0.2212901), vec2(0.1865031, 0.1904661), vec2(0.1225413, 0.1214466),
                                vec2(0.0608522, 0.0573673), vec2(0.0228385, 0.0200750));

void main() {
  ivec2 last = textureSize(picture, 0) - 1;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 sum = vec2(0.0);
  for (int i = -4; i <= 4; ++i) {
    sum += kWeights[abs(i)] * vec2(texelFetch(picture, clamp(pixel + 2 * i * direction, ivec2(0), last), 0).r,
                                   texelFetch(picture, clamp(pixel + i * direction, ivec2(0), last), 0).g);
  }
  result = sum;
}
