#include "lamp.glsl"

layout(binding = 0) uniform sampler2DShadow shadow_map;

// What the map says at `place` (0 to 1; z: depth), averaged over four by four texels with the weights of a cubic
// B-spline, whose slope and bend are steady: of the map's raster nothing is left. Four taps do, as each compares two by
// two texels and stands between them so that they weigh in right (Sigg and Hadwiger 2005).
float lit_part(vec3 place) {
  float size = float(textureSize(shadow_map, 0).x);
  vec2 texels = size * place.xy - 0.5;
  vec2 part = fract(texels), rest = 1.0 - part;
  vec2 middle = texels - part + 0.5;
  vec2 first = rest * rest * rest / 6.0, last = part * part * part / 6.0;
  vec2 second = 2.0 / 3.0 - part * part * (1.0 - 0.5 * part);
  vec2 before = first + second, after = 1.0 - before;
  vec2 near = (middle - 1.0 + second / before) / size;
  vec2 far = (middle + 1.0 + last / after) / size;
  return before.x * (before.y * texture(shadow_map, vec3(near, place.z)) +
                     after.y * texture(shadow_map, vec3(near.x, far.y, place.z))) +
         after.x * (before.y * texture(shadow_map, vec3(far.x, near.y, place.z)) +
                    after.y * texture(shadow_map, vec3(far, place.z)));
}

// The same over seven by seven texels: what is close to the border that throws the shadow shows how large a lamp is.
float softly_lit_part(vec3 place) {
  vec2 aside = 1.5 / vec2(textureSize(shadow_map, 0));
  return 0.25 * (lit_part(place + vec3(aside, 0.0)) + lit_part(place - vec3(aside, 0.0)) +
                 lit_part(place + vec3(aside.x, -aside.y, 0.0)) + lit_part(place + vec3(-aside.x, aside.y, 0.0)));
}

// Part of the light of a large lamp that comes past tools which take `taken` of the map as it is blurred less or more, see
// ToolCover.hpp, where the border of their shadow is blurred by `spread` texels: below zero before their middle.
float past_tools(float spread, vec4 taken) {
  const vec4 kSpreads = vec4(1.0, 2.23607, 4.58258, 9.21954);
  const float kBefore = 0.07;  // texels: as far before the middle of a thin tool its shadow is whole
  vec3 wider = saturate3((spread - kSpreads.xyz) / (kSpreads.yzw - kSpreads.xyz));
  return 1.0 - saturate(2.0 + spread / kBefore) * mix(mix(mix(taken.x, taken.y, wider.x), taken.z, wider.y), taken.w, wider.z);
}

#if defined(TOOLS_SHADE) && !defined(ENDOSCOPE)

layout(binding = 8) uniform sampler2D tools_take;
layout(binding = 9) uniform sampler2D tools_depth;

// At `place` of the map.
float past_tools(vec3 place) {
  float behind = place.z - texture(tools_depth, place.xy).r;
  return past_tools(camera_position.w * behind, texture(tools_take, place.xy));
}

#else

// The map of a small lamp shows the tools themselves.
float past_tools(vec3 place) { return 1.0; }

#endif

// Part of the key light that reaches `position`, 0 to 1. `normal` lifts the point off its own surface. With TOOLS_SHADE
// tools may stand in its way.
float key_visibility(vec3 position, vec3 normal) {
  vec3 lifted = position + environment.z * (normal + 0.6 * lamp_direction(position));
  vec4 projected = shadow_matrix * vec4(lifted, 1.0);
  vec3 place = projected.xyz / projected.w;
#ifdef SOFT_SHADOW
  float light = softly_lit_part(place);
#else
  float light = lit_part(place);
#endif
  light *= past_tools(place);
  // Towards the border of the map the shadow fades, so that a long shaft's does not end in a line.
  vec2 border = abs(2.0 * place.xy - 1.0);
  float beyond = smoothstep(0.90, 0.99, max(border.x, border.y));
  return mix(light, 1.0, projected.w > 0.0 ? beyond : 1.0);
}

// The same for what mirrors the light: what is turned away from it lies in its own shade, which the map does not tell so
// close to the border.
float key_mirrored(float visibility, vec3 normal, vec3 toward) {
  return visibility * smoothstep(-0.15, 0.10, dot(normal, toward));
}
