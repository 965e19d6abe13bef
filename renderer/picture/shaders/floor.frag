#version 450 core
#define FRAME_FROM_VERTICES
#include "ground.glsl"
#include "tone.glsl"

// The studio's floor: a pool of light around the scene that fades into the background.

void main() {
  vec3 display = background.rgb;
  if (meets_ground()) {
    vec2 offset = place_on_ground().xy - scene_center.xy;
    float fade = exp2(-0.5 * dot(offset, offset) / square(scene_center.w));
    float pool = 0.15 + 1.1 * fade * fade * fade;
    vec2 taken = taken_light(offset);
    vec3 light = (1.0 - 0.85 * taken.r) * ((1.0 - taken.g) * pool * kKeyColor * floor_key.rgb + floor_sky.rgb);
    display = mix(display, displayed(lens_light(ray) * light), fade);
  }
  color = vec4(display, 1.0);
}
