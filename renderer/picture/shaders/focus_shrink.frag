#version 450 core
#include "focus.glsl"

// Half the size; alpha: how far out of focus, 0 to 1.

layout(location = 0) out vec4 color;

layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2D depth;

void main() {
  ivec2 pixel = 2 * ivec2(gl_FragCoord.xy);
  vec2 place = 2.0 * gl_FragCoord.xy / vec2(textureSize(picture, 0));
  float radius = disc_radius(texelFetch(depth, min(pixel, textureSize(depth, 0) - 1), 0).r);
  color = vec4(texture(picture, place).rgb, radius / kLargest);
}
