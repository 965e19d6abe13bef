#version 450 core
#define FRAME_FROM_VERTICES
#include "ground.glsl"

// The threads of a drape, over the backdrop that shows its folds: what is left of the light on them. Those of one direction
// lie over those of the other in turns, some thicker than others.

// Waves of length 1 from -1 to 1: parabolas, which take a fifth of what cosines do.
vec2 waves(vec2 place) {
  vec2 part = fract(place) - 0.5;
  vec2 away = abs(part);
  return 16.0 * part * (0.5 - away);
}

void main() {
  const float kThreads = 105.0;  // over the scene's size, in each direction
  float scale = kThreads / scene_center.w;
  float reach = scale * (floor_plane.x - camera_position.z) / min(ray.z, -1e-3);
  vec2 place = reach * ray.xy + scale * (camera_position.xy - scene_center.xy);
  // What a pixel covers along the line of sight.
  float footprint = environment.w * reach / max(-ray.z, 1e-3);
  float seen = floor_plane.y * saturate(1.6 - 2.9 * footprint);
  vec2 thread = vec2(0.91 * place.x + 0.42 * place.y, 0.91 * place.y - 0.42 * place.x);
  vec2 wave = waves(thread + 0.12 * waves(0.083 * thread.yx));
  color = vec4(vec3(1.0 - seen * (0.10 + 0.06 * wave.x * wave.y + 0.02 * (wave.x + wave.y))), 1.0);
}
