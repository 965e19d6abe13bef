#include "frame.glsl"

float rod_openness(vec4 start, vec4 span, vec3 position, vec3 normal) {
  vec3 from_start = start.xyz - position;
  vec3 offset = from_start + saturate(-dot(from_start, span.xyz) * span.w) * span.xyz;
  float distance_squared = max(dot(offset, offset), 1e-12);
  float facing = saturate(0.55 + 0.45 * dot(normal, offset) * inversesqrt(distance_squared));
  return 1.0 - 0.75 * facing * min(1.0, 1.4 * start.w / distance_squared);
}

// Part of the light from all around that the tools' rods, ROD_COUNT of them, leave over, 0 to 1: each counts as the ball of
// its radius at the nearest point of its middle line.
float rods_openness(vec3 position, vec3 normal) {
  // Written out: llvmpipe takes ten times as long for a loop over an array of uniforms.
  float open = 1.0;
  if (ROD_COUNT > 0) open *= rod_openness(rod_start[0], rod_span[0], position, normal);
  if (ROD_COUNT > 1) open *= rod_openness(rod_start[1], rod_span[1], position, normal);
  if (ROD_COUNT > 2) open *= rod_openness(rod_start[2], rod_span[2], position, normal);
  return open;
}
