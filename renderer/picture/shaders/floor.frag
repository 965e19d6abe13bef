#version 450 core
#include "environment.glsl"
#include "occlusion.glsl"
#include "shadow.glsl"
#include "tone.glsl"

// The studio's floor: a pool of light around the scene that fades into the background.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;

layout(binding = 1) uniform sampler2D floor_shade;  // part of the sky that the scene covers, from above

vec3 linear_background() { return mix(background.rgb / 12.92, pow((background.rgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, background.rgb)); }

void main() {
  vec3 display = background.rgb;
  if (floor_plane.y > 0.0 && ray.z < 0.0) {
    float reach = (floor_plane.x - camera_position.z) / ray.z;
    vec3 position = camera_position.xyz + reach * ray;
    vec2 offset = position.xy - scene_center.xy;
    float far = length(offset) / scene_center.w;
    float pool = exp(-1.1 * square(far));
    float visible = key_visibility(position, vec3(0.0, 0.0, 1.0));
    float covered = texture(floor_shade, 0.5 + 0.5 * offset / floor_plane.z).r;
    vec3 albedo = 3.2 * linear_background() + 0.004;
    vec3 light = 2.1 * key_direction.w * key_direction.z * kKeyColor * visible * (0.15 + 1.1 * pool);
    light += environment_irradiance(vec3(0.0, 0.0, 1.0));
    light *= (1.0 - 0.85 * covered) * rods_openness(position, vec3(0.0, 0.0, 1.0));
    display = mix(display, displayed(albedo * light), exp(-0.35 * square(far)));
  }
  color = vec4(dithered(display, gl_FragCoord.xy), 1.0);
}
