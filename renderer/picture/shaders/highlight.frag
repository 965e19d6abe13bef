#version 450 core
#define FRAME_FROM_VERTICES
#include "tone.glsl"

// Tints what is seen of a ball of the stress-free shape, with a ring along its border. The stencil keeps it to one wall.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;  // is blended over the pixel by its alpha

layout(location = 0) uniform vec4 ball;  // center and radius, metres
layout(location = 1) uniform vec3 tint;  // sRGB

layout(binding = 2) uniform sampler2D seen_normal;  // w: depth along the line of sight, metres
layout(binding = 3) uniform sampler2D seen_rest;    // metres

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float pixel_size = environment.w * texelFetch(seen_normal, pixel, 0).w;
  float inward = ball.w - distance(texelFetch(seen_rest, pixel, 0).xyz, ball.xyz);
  float inside = smoothstep(-0.7 * pixel_size, 0.7 * pixel_size, inward);
  float width = max(0.05 * ball.w, 1.5 * pixel_size);
  float ring = 1.0 - smoothstep(width, width + 1.4 * pixel_size, inward);
  color = vec4(tint, field_stop(ray) * inside * mix(0.16, 0.9, ring));
}
