#include "lamp.glsl"

layout(binding = 0) uniform sampler2DShadow shadow_map;

#ifndef SHADOW_TAPS
#define SHADOW_TAPS 5
#endif

// Part of the key light that reaches `position`, 0 to 1. Taps of two by two compared texels each, at the corners of a
// fixed tilted square and, with five, in its middle: it hides the raster, while one that is turned from pixel to pixel shows
// as noise. `normal` lifts the point off its own surface.
float key_visibility(vec3 position, vec3 normal) {
  vec3 lifted = position + environment.z * (normal + 0.6 * lamp_direction(position));
  vec4 projected = shadow_matrix * vec4(lifted, 1.0);
  vec3 place = projected.xyz / projected.w;
  float texel = 1.0 / float(textureSize(shadow_map, 0).x);
  vec3 a = texel * vec3(0.7, 1.9, 0.0);
  vec3 b = texel * vec3(1.9, -0.7, 0.0);
  float light = texture(shadow_map, place + a) + texture(shadow_map, place - a) + texture(shadow_map, place + b) +
                texture(shadow_map, place - b);
  if (SHADOW_TAPS > 4) light += texture(shadow_map, place);
  light *= 1.0 / float(SHADOW_TAPS);
  // Steep at neither end, or the raster would show where the shadow begins.
  light = light * light * (3.0 - 2.0 * light);
  // Towards the border of the map the shadow fades, so that a long shaft's does not end in a line.
  vec2 border = abs(2.0 * place.xy - 1.0);
  return mix(light, 1.0, smoothstep(0.90, 0.99, max(border.x, border.y)));
}
