#include "frame.glsl"

// What lies below a scene: a plane. Drawn small, see BackdropPicture.hpp.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;

// Part that the scene takes of the light from all around (red), and of the light that casts the shadow (green).
layout(binding = 1) uniform sampler2D floor_shade;

bool meets_ground() { return floor_plane.y > 0.0 && ray.z < 0.0; }

vec3 place_on_ground() { return camera_position.xyz + (floor_plane.x - camera_position.z) / ray.z * ray; }

// `offset`: from the scene's centre, along the plane.
vec2 taken_light(vec2 offset) {
  vec2 place = offset / floor_plane.z;
  return saturate(5.0 - 5.0 * max(abs(place.x), abs(place.y))) * texture(floor_shade, 0.5 + 0.5 * place).rg;
}
