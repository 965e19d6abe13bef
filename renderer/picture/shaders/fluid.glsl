#define TOOLS_SHADE
#include "environment.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "seen.glsl"
// Light that comes in beside the border of a shadow is scattered on into it.
#ifndef ENDOSCOPE
#define SOFT_SHADOW
#endif
#include "shadow.glsl"
#include "tone.glsl"
#include "turning.glsl"

// The fluid in an opened organ: a mirror over a depth that swallows what lies in it (Lambert and Beer).

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;

layout(location = 0, index = 0) out vec4 color;  // is added to what is left of the pixel
layout(location = 0, index = 1) out vec4 through;  // part of each channel that is left

layout(location = 0) uniform vec4 fluid;  // linear colour of a deep layer; w: 1 / clarity, 1 / metre
layout(location = 1) uniform float cloudiness;  // part of what it takes of the light that it sends back

layout(binding = 2) uniform usampler2D seen_tissue;

// Slope of its waves; size and roughness with which lamps are seen in it. Those of a studio are farther off its level than
// an endoscope's, and would not be seen in flatter waves.
#ifdef ENDOSCOPE
const float kWaves = 0.10, kLampSize = 1.0, kRoughness = 0.06, kGlint = 0.05;
#else
const float kWaves = 0.24, kLampSize = 1.6, kRoughness = 0.09;
#endif

void main() {
  vec3 from_eye = position - camera_position.xyz;
  vec3 view = -normalize(from_eye);
  float depth = 1.0 / gl_FragCoord.w;
  Seen wall = seen_from(texelFetch(seen_tissue, ivec2(gl_FragCoord.xy), 0), rest_grid, false);
  float way = max(wall.depth / depth - 1.0, 0.0) * length(from_eye);
  // What is cloudy hides what lies in it, what is clear tints it: it takes its part of the light, which is shown by a power
  // of about 1 / 2.2.
  vec3 swallowed = -log(clamp(fluid.rgb, 0.004, 0.9));
  vec3 tint = swallowed / dot(swallowed, vec3(1.0 / 3.0)) / 2.2;
  vec3 left = exp(-way * fluid.w * mix(tint, vec3(1.0), cloudiness));

  // It is hardly ever at rest.
  vec3 coordinates = 350.0 * position;
  vec3 waves = kWaves * (noise(0.8 * coordinates).xyz + 0.4 * noise(2.7 * coordinates + 4.0).xyz);
  vec3 base = normalize(smooth_normal);
  base = dot(base, view) < 0.0 ? -base : base;
  // It wets the wall and climbs it, so that there some of it always faces the lamp.
  const float kMeniscus = 0.0011;  // metres of way through it
  base = normalize(base + 1.5 * exp2(-way / kMeniscus) * wall.normal);
  vec3 normal = normalize(base - (waves - dot(waves, base) * base));
  float nv = max(dot(normal, view), 0.02);
  vec3 toward = lamp_direction(position);
  vec3 lamp = lamp_light(position);
  float visible = key_visibility(position, base);

  // Light that has come in by the opening goes from wall to wall.
  vec3 lit = mix(vec3(0.30, 0.22, 0.20), vec3(1.0), visible) * mix(0.35, 1.0, saturate(dot(base, toward)));
  // What floats in it is here more, there less, and beside the wall, which stands around it, less light comes to it.
  const float kMotes = 0.55, kFineMotes = 0.35, kBesideWall = 0.45;
  const float kStandsAround = 0.004;  // metres of way through it
  float motes = 1.0 + cloudiness * (kMotes * noise(90.0 * position).w + kFineMotes * noise(310.0 * position + 2.0).w);
  float open = mix(kBesideWall, 1.0, 1.0 - exp2(-way / kStandsAround));
  vec3 body = fluid.rgb * motes * open * (lit * lamp + environment_irradiance(base));
  float mirror = 0.022 + 0.978 * fresnel_weight(nv);
  // Along itself it mirrors the wall that stands around it, as bright as it is lit itself.
  const vec3 kWall = vec3(0.42, 0.13, 0.10);
  vec3 mirrored_way = reflect(-view, normal);
  float of_wall = 1.0 - smoothstep(0.25, 0.6, dot(mirrored_way, base));
  // Beside a fold of the wall, which it climbs, one pixel of it would be a spark. At a lip the pixels beside are of another
  // wall.
  const float kMostLost = 0.03, kAnotherWall = 0.0004;  // metres
  float lost = min(turned_within_pixel(normal), kMostLost) * step(fwidth(way), kAnotherWall);
  vec3 seen_room = environment_light(mirrored_way, sqrt(square(kRoughness) + lost), visible, kLampSize);
  vec3 room = mix(seen_room, kWall * lit * lamp, of_wall);
  vec3 shine = mirror * mix(0.35, 1.0, visible) * room;
#ifdef ENDOSCOPE
  float lamp_mirror = 0.022 + 0.978 * fresnel_weight(dot(view, normalize(view + toward)));
  shine += visible * lamp_mirror * glint(normal, view, toward, sqrt(square(kGlint) + lost)) * lamp;
#endif

  vec3 opaque = 1.0 - left * (1.0 - mirror);
  vec3 ray = from_eye / depth;
  float shining = saturate(dot(shine, vec3(0.33)));
  vec3 alpha = max(opaque, shining);
  vec3 sent = (cloudiness * body * (1.0 - left) + shine) / max(alpha, 1e-3);
  color = vec4(alpha * finished(sent, ray, gl_FragCoord.xy).rgb, 1.0);
  through = vec4(1.0 - alpha, 1.0);
}
