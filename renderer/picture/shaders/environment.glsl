#include "frame.glsl"

#ifdef ENDOSCOPE

// Inside a body: what the lamp lights sends a little, reddish light back from all around.

const vec3 kCavity = vec3(0.140, 0.076, 0.058);

vec3 environment_light(vec3 direction, float roughness, float key_visible) {
  return environment.x * mix(vec3(1.0), kCavity, environment.y);
}

vec3 environment_light(vec3 direction, float roughness, float key_visible, float lamp_size) {
  return environment_light(direction, roughness, key_visible);
}

vec3 environment_irradiance(vec3 normal) { return environment.x * mix(vec3(1.0), kCavity, environment.y); }

#else

// The studio as light sources seen from the scene, without a picture of it: a gradient from the floor to the ceiling, a
// soft box where the key light is, and two tall panels that stand on the floor, one in front and one behind. `roughness`
// (0 to 1) widens their edges, as the width of a highlight does.

const vec3 kSky = vec3(0.36, 0.40, 0.45);
const vec3 kHorizon = vec3(0.13, 0.14, 0.155);
const vec3 kGround = vec3(0.095, 0.092, 0.094);

vec3 gradient(float height) {
  vec3 upper = mix(kHorizon, kSky, smoothstep(0.0, 1.0, height));
  vec3 lower = mix(kHorizon, kGround, smoothstep(0.0, 0.6, -height));
  return height > 0.0 ? upper : lower;
}

// 1 where both distances are inside the half widths, falling to 0 over twice the blur.
float soft_rectangle(vec2 distances, vec2 half_size, float blur) {
  vec2 t = saturate2(0.5 + (half_size - abs(distances)) / (2.0 * blur));
  t = t * t * (3.0 - 2.0 * t);
  return t.x * t.y;
}

// Light of the box's cloth, over an even one's: the lamp stands behind its middle, and the highlight has a core.
float cloth(vec2 off_middle) { return 0.25 + 2.75 / square(1.0 + 1.6 * dot(off_middle, off_middle)); }

float key_box(vec3 direction, vec2 half_size, float blur) {
  float facing = dot(direction, key_direction.xyz);
  vec2 place = vec2(dot(direction, key_right.xyz), dot(direction, cross(key_direction.xyz, key_right.xyz)));
  place /= max(facing, 1e-3);
  return facing > 0.0 ? cloth(place / half_size) * soft_rectangle(place, half_size, blur) : 0.0;
}

float panel(vec3 direction, vec2 toward, vec2 half_size, float blur) {
  float facing = dot(direction.xy, toward);
  vec2 place = vec2(direction.x * toward.y - direction.y * toward.x, direction.z);
  return facing > 0.0 ? soft_rectangle(place / max(facing, 1e-3), half_size, blur) : 0.0;
}

// Radiance from `direction`; `key_visible` is the part of the key light that is not shadowed. Blurred over a larger
// angle the same light is dimmer. `lamp_size`: of box and panels, over what they are;
// a smaller box is brighter.
vec3 environment_light(vec3 direction, float roughness, float key_visible, float lamp_size) {
  float blur = 0.02 + 1.1 * roughness;
  float box = key_box(direction, lamp_size * vec2(0.27, 0.19), blur) / (1.0 + 18.0 * square(blur));
  float front = panel(direction, panels.xy, lamp_size * vec2(0.17, 1.5), blur) / (1.0 + 5.0 * blur);
  float back = panel(direction, panels.zw, lamp_size * vec2(0.16, 1.5), blur) / (1.0 + 4.0 * blur);
  vec3 light = gradient(direction.z);
  light += (24.0 / lamp_size * key_visible * box + 1.3 * front) * key_direction.w * kKeyColor;
  light += 1.7 * fill_direction.w * back * kFillColor;
  return environment.x * mix(vec3(1.0), light, environment.y);
}

vec3 environment_light(vec3 direction, float roughness, float key_visible) {
  return environment_light(direction, roughness, key_visible, 1.0);
}

// Light from all around on a white matte surface; box and panels count as key and fill light instead.
vec3 environment_irradiance(vec3 normal) {
  vec3 light = normal.z > 0.0 ? mix(kHorizon, 0.85 * kSky + 0.15 * kHorizon, normal.z)
                              : mix(kHorizon, 0.8 * kGround + 0.2 * kHorizon, -normal.z);
  return environment.x * mix(vec3(1.0), light, environment.y);
}

#endif
