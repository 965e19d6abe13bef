#include "frame.glsl"

layout(binding = 0) uniform sampler2DShadow shadow_map;

// Part of the key light that reaches `position`, 0 to 1. Five taps of two by two compared texels each, in a fixed
// pattern: a turned one shows as noise. `normal` lifts the point off its own surface.
float key_visibility(vec3 position, vec3 normal) {
  if (environment.z == 0.0) return 1.0;
  vec3 lifted = position + environment.w * (normal + 0.6 * key_direction.xyz);
  vec3 place = (shadow_matrix * vec4(lifted, 1.0)).xyz;
  float texel = 1.1 / float(textureSize(shadow_map, 0).x);
  float light = 2.0 * texture(shadow_map, place);
  light += texture(shadow_map, place + vec3(-texel, -texel, 0.0));
  light += texture(shadow_map, place + vec3(texel, -texel, 0.0));
  light += texture(shadow_map, place + vec3(-texel, texel, 0.0));
  light += texture(shadow_map, place + vec3(texel, texel, 0.0));
  light *= 1.0 / 6.0;
  // Towards the border of the map the shadow fades, so that a long shaft's does not end in a line.
  vec2 border = abs(2.0 * place.xy - 1.0);
  return mix(light, 1.0, smoothstep(0.80, 0.98, max(border.x, border.y)));
}
