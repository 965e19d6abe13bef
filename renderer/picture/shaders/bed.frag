#version 450 core
#define FRAME_FROM_VERTICES
#define ENDOSCOPE
#include "environment.glsl"
#include "ground.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "tone.glsl"

// What lies below and around the scene inside a body: brown-red and fatty tissue, wet, that the lamp hardly reaches, and out
// of focus. A plane below the scene, and a ball around scene and lens, so wherever the lens looks it sees some.

layout(location = 1) flat in vec4 ball;  // these two: see bed.vert
layout(location = 2) flat in vec4 parts;

struct Bed {
  vec3 position;
  vec3 normal;     // towards the inside, of about length one
  float on_plane;  // 0 to 1
};

// `along_ray`: one over the square of its length.
Bed bed_along(vec3 ray, float along_ray) {
  float along = dot(ball.xyz, ray) * along_ray;
  float to_ball = sqrt(square(along) + ball.w * along_ray) - along;
  float to_plane = ray.z < 0.0 ? (floor_plane.x - camera_position.z) / ray.z : 1e6;
  vec3 away = min(to_ball, to_plane) * ray;
  vec3 inward = -(ball.xyz + away);
  // No edge where both meet.
  float up_the_wall = to_plane < to_ball ? 0.5 * saturate(1.6 * parts.x * dot(inward.xy, inward.xy) - 0.6)
                                         : saturate(1.25 - 0.75 * parts.z * inward.z);
  vec3 normal = mix(vec3(0.0, 0.0, 1.0), parts.y * inward, up_the_wall);
  return Bed(camera_position.xyz + away, normal, 1.0 - up_the_wall);
}

void main() {
  vec3 light = vec3(0.0);
  if (floor_plane.y > 0.0) {
    float along_ray = 1.0 / dot(ray, ray);
    Bed bed = bed_along(ray, along_ray);
    vec3 position = bed.position;
    vec2 taken = bed.on_plane * taken_light(position.xy - scene_center.xy);
    vec3 coordinates = parts.w * (position - scene_center.xyz);
    vec4 broad = noise(2.3 * coordinates + 4.2);
    float fine = noise(8.0 * coordinates + 0.12 * broad.xyz).w;
    float fatty = saturate(0.909 * (broad.w + 0.30 * fine + 0.1));
    fatty *= fatty * (3.0 - 2.0 * fatty);
    vec3 albedo = mix(vec3(0.185, 0.054, 0.040), vec3(0.36, 0.20, 0.095), fatty) * (1.0 + 0.20 * fine);
    vec3 bump = 0.16 * broad.xyz;
    vec3 normal = normalize(bed.normal - (bump - dot(bump, bed.normal) * bed.normal));
    vec3 view = -sqrt(along_ray) * ray;
    vec3 toward = lamp_direction(position);
    float lit = (1.0 - taken.g) * (1.0 - 0.7 * taken.r);
    vec3 lamp = lamp_light(position);
    light = albedo * (lit * saturate(dot(normal, toward)) * lamp + (1.0 - 0.85 * taken.r) * environment_irradiance(normal));
    // What glistens, as microfacets do that neither mask nor shadow each other.
    const float kSquaredWidth = 0.0225;
    vec3 halfway = view + toward;
    float spread = 1.0 - (1.0 - kSquaredWidth) * square(max(dot(normal, halfway), 0.0)) / dot(halfway, halfway);
    light += 0.008 * kSquaredWidth / square(spread) * lit * lamp;
  }
  color = vec4(displayed(lens_light(ray) * light), 1.0);
}
