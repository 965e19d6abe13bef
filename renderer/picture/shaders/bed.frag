#version 450 core
#define FRAME_FROM_VERTICES
#define ENDOSCOPE
#include "environment.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "tone.glsl"

// What lies below the scene inside a body: brown-red and fatty tissue, wet, that the lamp hardly reaches. Drawn small, see
// BackdropPicture.hpp: it lies out of focus.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;

layout(binding = 1) uniform sampler2D floor_shade;  // part that the scene takes of the light from all around, of the lamp's

void main() {
  vec3 light = vec3(0.0);
  if (floor_plane.y > 0.0 && ray.z < 0.0) {
    vec3 position = camera_position.xyz + (floor_plane.x - camera_position.z) / ray.z * ray;
    vec2 place = (position.xy - scene_center.xy) / floor_plane.z;
    vec2 taken = saturate(5.0 - 5.0 * max(abs(place.x), abs(place.y))) * texture(floor_shade, 0.5 + 0.5 * place).rg;
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
