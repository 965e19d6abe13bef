#version 450 core
#define FRAME_FROM_VERTICES
#define ENDOSCOPE
#include "environment.glsl"
#include "ground.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "tone.glsl"

// What lies below the scene inside a body: brown-red and fatty tissue, wet, that the lamp hardly reaches, and out of focus.

void main() {
  vec3 light = vec3(0.0);
  if (meets_ground()) {
    vec3 position = place_on_ground();
    vec2 taken = taken_light(position.xy - scene_center.xy);
    vec3 coordinates = (position - scene_center.xyz) / scene_center.w;
    vec4 broad = noise(2.3 * coordinates + 4.2);
    vec4 fine = noise(8.0 * coordinates + 0.12 * broad.xyz);
    float fatty = smoothstep(-0.1, 1.0, broad.w + 0.30 * fine.w);
    vec3 albedo = mix(vec3(0.185, 0.054, 0.040), vec3(0.36, 0.20, 0.095), fatty) * (1.0 + 0.20 * fine.w);
    vec3 bump = 0.10 * broad.xyz + 0.06 * fine.xyz;
    vec3 normal = normalize(vec3(-bump.xy, 1.0));
    vec3 view = -normalize(ray);
    vec3 toward = lamp_direction(position);
    float lit = (1.0 - taken.g) * (1.0 - 0.7 * taken.r);
    vec3 lamp = lamp_light(position);
    light = albedo * (lit * saturate(dot(normal, toward)) * lamp + (1.0 - 0.85 * taken.r) * environment_irradiance(normal));
    light += 0.03 * lit * glint(normal, view, toward, 0.15) * lamp;
  }
  color = vec4(displayed(lens_light(ray) * light), 1.0);
}
