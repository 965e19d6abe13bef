#include "frame.glsl"

// The studio as light sources seen from the scene, without a picture of it: a gradient from the floor to the ceiling, a
// large soft box where the key light is, a tall strip behind. `roughness` (0 to 1) widens their edges, as the width of
// a highlight does.

const vec3 kSky = vec3(0.52, 0.57, 0.62);
const vec3 kHorizon = vec3(0.21, 0.225, 0.245);
const vec3 kGround = vec3(0.085, 0.080, 0.080);
const vec3 kStripDirection = vec3(0.62, 0.70, 0.35);

vec3 gradient(float height) {
  vec3 upper = mix(kHorizon, kSky, smoothstep(0.0, 1.0, height));
  vec3 lower = mix(kHorizon, kGround, smoothstep(0.0, 0.6, -height));
  return height > 0.0 ? upper : lower;
}

// A rectangle of half widths `half_size` (tangents) around `toward`, 1 inside, blurred by `blur`.
float soft_box(vec3 direction, vec3 toward, vec2 half_size, float blur) {
  vec3 right = normalize(cross(toward, vec3(0.0, 0.0, 1.0) + 1e-3 * toward.yzx));
  vec3 up = cross(right, toward);
  float facing = dot(direction, toward);
  vec2 place = vec2(dot(direction, right), dot(direction, up)) / max(facing, 1e-3);
  vec2 inside = smoothstep(half_size + blur, max(half_size - blur, vec2(0.0)), abs(place));
  return facing > 0.0 ? inside.x * inside.y : 0.0;
}

// Radiance from `direction`; `key_visible` is the part of the key light that is not shadowed.
vec3 environment_light(vec3 direction, float roughness, float key_visible) {
  float blur = 0.03 + 1.3 * roughness;
  // Blurred over a larger area the same light is dimmer.
  float key_box = soft_box(direction, key_direction.xyz, vec2(0.42, 0.30), blur) / (1.0 + 6.0 * square(blur));
  float strip = soft_box(direction, normalize(kStripDirection), vec2(0.10, 0.85), blur) / (1.0 + 4.0 * blur);
  vec3 light = gradient(direction.z);
  light += 4.6 * key_direction.w * key_visible * key_box * kKeyColor;
  light += 1.5 * fill_direction.w * strip * kFillColor;
  return environment.x * mix(vec3(1.0), light, environment.y);
}

// Light from all around on a white matte surface; the boxes count as key and fill light instead.
vec3 environment_irradiance(vec3 normal) {
  vec3 light = normal.z > 0.0 ? mix(kHorizon, 0.85 * kSky + 0.15 * kHorizon, normal.z)
                              : mix(kHorizon, 0.8 * kGround + 0.2 * kHorizon, -normal.z);
  return environment.x * mix(vec3(1.0), light, environment.y);
}
