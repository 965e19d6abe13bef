#version 450 core
#define FRAME_FROM_VERTICES
#include "ground.glsl"
#include "noise.glsl"
#include "tone.glsl"

// A surgical drape that the scene lies on: cloth in soft folds, which the scene presses flat. It is seen from near by, so
// its lengths are parts of the scene's size.

// Slope in xy and height in z, 0 to 1, of folds across `along` with waves of 1 / `frequency`; noise bends them. They are
// narrow, with wide valleys between them.
vec3 folds(vec2 place, vec2 across, float frequency, float bending, vec4 bend) {
  float phase = 2.0 * kPi * frequency * dot(place, across) + bending * bend.w;
  float rise = 0.5 + 0.5 * sin(phase);
  vec2 turn = across + bending * bend.xy / (2.0 * kPi * frequency);
  return vec3(1.5 * rise * rise * cos(phase) * turn, rise * rise * rise);
}

void main() {
  vec3 display = background.rgb;
  if (meets_ground()) {
    vec2 offset = place_on_ground().xy - scene_center.xy;
    vec2 place = offset / scene_center.w;
    vec2 taken = taken_light(offset);
    vec4 broad = noise(vec3(0.9 * place, 3.7)), middle = noise(vec3(2.2 * place + 0.3 * broad.xy, 8.1));
    vec3 long_folds = folds(place, vec2(0.80, 0.60), 1.3, 3.0, broad);
    vec3 short_folds = folds(place, vec2(-0.35, 0.94), 2.6, 3.0, middle);
    float loose = 1.0 - smoothstep(0.05, 0.75, taken.r);
    float long_part = loose * smoothstep(-0.45, 0.35, broad.x), short_part = loose * smoothstep(-0.15, 0.6, middle.y);
    vec2 slope = 0.95 * long_part * long_folds.xy + 0.55 * short_part * short_folds.xy + 0.10 * loose * middle.xy;
    const float kSteepest = 0.75;
    slope *= inversesqrt(1.0 + dot(slope, slope) / square(kSteepest));
    vec3 normal = normalize(vec3(-slope, 1.0));
    float hollow = 0.5 * (long_part * (1.0 - long_folds.z) + short_part * (1.0 - short_folds.z));
    // Light that has gone through one fold or from one to the other.
    const float kThrough = 0.22;
    float facing = saturate((dot(normal, key_direction.xyz) + kThrough) / (max(key_direction.z, 0.2) + kThrough));
    float pool = 0.25 + 0.75 * exp2(-0.45 * dot(place, place));
    vec3 light = (1.0 - taken.g) * pool * facing * kKeyColor * floor_key.rgb + (1.0 - 0.35 * hollow) * floor_sky.rgb;
    display = mix(display, displayed(lens_light(ray) * (1.0 - 0.85 * taken.r) * light), exp2(-0.06 * dot(place, place)));
  }
  color = vec4(display, 1.0);
}
