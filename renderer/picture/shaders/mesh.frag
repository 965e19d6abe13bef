#version 450 core
#include "tone.glsl"

layout(location = 0) noperspective in float offset;  // pixels
layout(location = 1) flat in float half_width;       // pixels
layout(location = 2) flat in float is_cut;

layout(location = 0) out vec4 color;  // is blended over the pixel by its alpha

const vec3 kEdge = vec3(0.03, 0.04, 0.06);
const vec3 kCut = vec3(1.0, 0.35, 0.12);

void main() {
  vec2 place = 2.0 * gl_FragCoord.xy * vec2(ray_right.w, ray_up.w) - 1.0;
  vec3 ray = ray_middle.xyz + place.x * ray_right.xyz + place.y * ray_up.xyz;
  float covered = clamp(half_width + 0.5 - abs(offset), 0.0, min(1.0, 2.0 * half_width));
  color = vec4(mix(kEdge, kCut, is_cut), field_stop(ray) * mix(0.65, 1.0, is_cut) * covered);
}
