#version 450 core
#define FRAME_FROM_VERTICES
#include "tone.glsl"

// The studio's floor: a pool of light around the scene that fades into the background. Drawn small, see
// BackdropPicture.hpp.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;

layout(binding = 1) uniform sampler2D floor_shade;  // part that the scene takes of the light from all around, of the key light

void main() {
  vec3 display = background.rgb;
  if (floor_plane.y > 0.0 && ray.z < 0.0) {
    float reach = (floor_plane.x - camera_position.z) / ray.z;
    vec3 position = camera_position.xyz + reach * ray;
    vec2 offset = position.xy - scene_center.xy;
    float fade = exp2(-0.5 * dot(offset, offset) / square(scene_center.w));
    float pool = 0.15 + 1.1 * fade * fade * fade;
    vec2 place = offset / floor_plane.z;
    vec2 taken = saturate(5.0 - 5.0 * max(abs(place.x), abs(place.y))) * texture(floor_shade, 0.5 + 0.5 * place).rg;
    vec3 light = (1.0 - 0.85 * taken.r) * ((1.0 - taken.g) * pool * kKeyColor * floor_key.rgb + floor_sky.rgb);
    display = mix(display, displayed(lens_light(ray) * light), fade);
  }
  color = vec4(display, 1.0);
}
