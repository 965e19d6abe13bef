#version 450 core
#define FRAME_FROM_VERTICES
#include "seen.glsl"
#include "tone.glsl"

// Tints what is seen of a ball of the stress-free shape, with a ring along its border. The stencil keeps it to one wall.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;  // is blended over the pixel by its alpha

layout(location = 0) uniform vec4 ball;  // center and radius, metres
layout(location = 1) uniform vec3 tint;  // sRGB

layout(binding = 2) uniform usampler2D seen_tissue;

void main() {
  Seen seen = seen_from(texelFetch(seen_tissue, ivec2(gl_FragCoord.xy), 0), rest_grid, false);
  float pixel_size = environment.w * seen.depth;
  float inward = ball.w - distance(seen.rest, ball.xyz);
  float inside = smoothstep(-0.7 * pixel_size, 0.7 * pixel_size, inward);
  float width = max(0.05 * ball.w, 1.5 * pixel_size);
  float ring = 1.0 - smoothstep(width, width + 1.4 * pixel_size, inward);
  color = vec4(tint, field_stop(ray) * inside * mix(0.16, 0.9, ring));
}
