#include "frame.glsl"

// The light that casts the shadow. In the open a lamp so far away that its rays are parallel; with ENDOSCOPE a small one
// beside the lens, whose light falls with the square of the distance. Light is told as what a white matte surface that
// faces it sends back.

// Part of it that the walls of a wound or an opened organ, which are wet with blood, send to each other.
const vec3 kFromWalls = vec3(0.105, 0.027, 0.021);

#ifdef ENDOSCOPE

vec3 lamp_direction(vec3 position) { return normalize(key_direction.xyz - position); }

vec3 lamp_light(vec3 position) {
  vec3 toward = key_direction.xyz - position;
  return key_direction.w / dot(toward, toward) * kLampColor;
}

#else

vec3 lamp_direction(vec3 position) { return key_direction.xyz; }
vec3 lamp_light(vec3 position) { return 1.8 * key_direction.w * kKeyColor; }

#endif
