#version 450 core
#include "environment.glsl"
#include "tone.glsl"

// The studio's floor: a pool of light around the scene that fades into the background.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;

layout(binding = 1) uniform sampler2D floor_shade;  // part that the scene takes of the light from all around, of the key light

vec3 linear_background() { return mix(background.rgb / 12.92, pow((background.rgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, background.rgb)); }

void main() {
  vec3 display = background.rgb;
  if (floor_plane.y > 0.0 && ray.z < 0.0) {
    float reach = (floor_plane.x - camera_position.z) / ray.z;
    vec3 position = camera_position.xyz + reach * ray;
    vec2 offset = position.xy - scene_center.xy;
    float far = length(offset) / scene_center.w;
    float pool = exp(-1.1 * square(far));
    vec2 place = offset / floor_plane.z;
    vec2 taken = texture(floor_shade, 0.5 + 0.5 * place).rg * (1.0 - smoothstep(0.8, 1.0, max(abs(place.x), abs(place.y))));
    vec3 albedo = 3.2 * linear_background() + 0.004;
    vec3 light = 2.1 * key_direction.w * key_direction.z * kKeyColor * (1.0 - taken.g) * (0.15 + 1.1 * pool);
    light += environment_irradiance(vec3(0.0, 0.0, 1.0));
    light *= (1.0 - 0.85 * taken.r);
    display = mix(display, displayed(albedo * light), exp(-0.35 * square(far)));
  }
  color = vec4(dithered(display, gl_FragCoord.xy), 1.0);
}
