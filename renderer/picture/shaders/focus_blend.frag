#version 450 core
#include "focus.glsl"

// Lays what is blurred over what is sharp, the more the farther a pixel is out of focus.

layout(location = 0) out vec4 color;  // is blended over the pixel by its alpha

layout(binding = 0) uniform sampler2D blurred;
layout(binding = 1) uniform sampler2D depth;

void main() {
  float radius = disc_radius(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r);
  vec2 place = gl_FragCoord.xy / vec2(textureSize(depth, 0));
  color = vec4(texture(blurred, place).rgb, smoothstep(0.5, 1.8, radius));
}
