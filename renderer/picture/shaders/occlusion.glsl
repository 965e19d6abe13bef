#include "frame.glsl"

// Part of the light from all around that the tools' rods leave over, 0 to 1: each counts as the ball of its radius at
// the nearest point of its middle line.
float rods_openness(vec3 position, vec3 normal) {
  float openness = 1.0;
  int count = int(counts.x);
  for (int i = 0; i < count; ++i) {
    vec3 start = rod_start[i].xyz;
    vec3 line = rod_end[i].xyz - start;
    float t = saturate(dot(position - start, line) / max(dot(line, line), 1e-12));
    vec3 offset = start + t * line - position;
    float distance_squared = max(dot(offset, offset), 1e-12);
    float facing = saturate(0.55 + 0.45 * dot(normal, offset) * inversesqrt(distance_squared));
    openness *= 1.0 - 0.75 * facing * min(1.0, 1.4 * square(rod_start[i].w) / distance_squared);
  }
  return openness;
}
