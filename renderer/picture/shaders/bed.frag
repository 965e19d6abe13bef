#version 450 core
#define FRAME_FROM_VERTICES
#define ENDOSCOPE
#include "environment.glsl"
#include "ground.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "tone.glsl"

// What lies below and around the scene inside a body: brown-red and fatty tissue, wet, that the lamp hardly reaches, and out
// of focus. A plane below the scene, and a ball around scene and lens, so wherever the lens looks it sees some.

// How far above the plane the middle of the ball lies, and half the width of the plane at least, over the scene's size.
const float kMiddle = 1.0, kPlane = 0.8;

struct Bed {
  vec3 position;
  vec3 normal;     // towards the inside, of length one
  float on_plane;  // 0 to 1
};

Bed bed_along(vec3 ray) {
  float lifted = kMiddle * scene_center.w;
  vec3 middle = vec3(scene_center.xy, floor_plane.x + lifted);
  vec3 from_middle = camera_position.xyz - middle;
  float squared_radius = max(square(lifted) + square(kPlane * scene_center.w), 1.1 * dot(from_middle, from_middle));
  float squared = dot(ray, ray), along = dot(from_middle, ray);
  float inside = squared_radius - dot(from_middle, from_middle);
  float to_ball = (sqrt(square(along) + squared * inside) - along) / squared;
  float to_plane = ray.z < 0.0 ? (floor_plane.x - camera_position.z) / ray.z : 1e6;
  vec3 position = camera_position.xyz + min(to_ball, to_plane) * ray;
  vec3 inward = middle - position;
  // No edge where both meet.
  float aside = length(inward.xy) * inversesqrt(squared_radius - square(lifted));
  float up_the_wall = to_plane < to_ball ? 0.5 * smoothstep(0.6, 1.0, aside)
                                         : 0.5 + 0.5 * smoothstep(0.0, 0.6, 1.0 - inward.z / lifted);
  vec3 normal = mix(vec3(0.0, 0.0, 1.0), normalize(inward), up_the_wall);
  return Bed(position, normalize(normal), 1.0 - up_the_wall);
}

void main() {
  vec3 light = vec3(0.0);
  if (floor_plane.y > 0.0) {
    Bed bed = bed_along(ray);
    vec3 position = bed.position;
    vec2 taken = bed.on_plane * taken_light(position.xy - scene_center.xy);
    vec3 coordinates = (position - scene_center.xyz) / scene_center.w;
    vec4 broad = noise(2.3 * coordinates + 4.2);
    vec4 fine = noise(8.0 * coordinates + 0.12 * broad.xyz);
    float fatty = smoothstep(-0.1, 1.0, broad.w + 0.30 * fine.w);
    vec3 albedo = mix(vec3(0.185, 0.054, 0.040), vec3(0.36, 0.20, 0.095), fatty) * (1.0 + 0.20 * fine.w);
    vec3 bump = 0.10 * broad.xyz + 0.06 * fine.xyz;
    vec3 normal = normalize(bed.normal - (bump - dot(bump, bed.normal) * bed.normal));
    vec3 view = -normalize(ray);
    vec3 toward = lamp_direction(position);
    float lit = (1.0 - taken.g) * (1.0 - 0.7 * taken.r);
    vec3 lamp = lamp_light(position);
    light = albedo * (lit * saturate(dot(normal, toward)) * lamp + (1.0 - 0.85 * taken.r) * environment_irradiance(normal));
    light += 0.03 * lit * glint(normal, view, toward, 0.15) * lamp;
  }
  color = vec4(displayed(lens_light(ray) * light), 1.0);
}
