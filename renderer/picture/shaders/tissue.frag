#version 450 core
#include "environment.glsl"
#include "noise.glsl"
#include "occlusion.glsl"
#include "reflection.glsl"
#include "shadow.glsl"
#include "tone.glsl"

// Living tissue: scattering flesh with mottling and vessels below a wet layer.

layout(location = 0) in vec3 ray;

layout(location = 0) out vec4 color;

layout(binding = 2) uniform sampler2D seen_normal;  // w: depth along the line of sight, metres
layout(binding = 3) uniform sampler2D seen_rest;    // in units of the scene's size, from its centre; w: see surface.frag

layout(location = 0) uniform vec3 flesh;      // linear
layout(location = 1) uniform float roughness;
layout(location = 2) uniform float wetness;
layout(location = 3) uniform float mottling;

struct Skin {
  vec3 albedo;
  vec3 bump;  // to be taken from the normal
  float film;  // strength of the wet layer here
};

// A fine net of vessels: where the noise passes through zero. 1 in the middle of a vessel.
float vessel(float value, float slope, float width) {
  return 1.0 - smoothstep(0.35, 1.0, abs(value) / (width * max(slope, 0.4)));
}

Skin skin_at(vec3 place, float blanch) {
  vec4 broad = noise(7.0 * place + 11.3);
  vec4 medium = noise(23.0 * place + 1.1 * broad.xyz * 0.3);
  vec4 fine = noise(78.0 * place + 3.7);
  float large_vessels = vessel(medium.w + 0.25 * broad.w, length(medium.xyz), 0.055);
  float veil = smoothstep(-0.25, 0.45, broad.w);
  Skin skin;
  vec3 redder = flesh * vec3(1.06, 0.80, 0.80);
  vec3 paler = flesh * vec3(1.10, 1.28, 1.20) + vec3(0.015, 0.012, 0.008);
  vec3 mottled = mix(redder, paler, saturate(0.5 + 0.55 * broad.w + 0.22 * medium.w + 0.10 * fine.w));
  vec3 blood = flesh * vec3(0.52, 0.20, 0.26);
  mottled = mix(mottled, blood, 0.50 * large_vessels * veil * (1.0 - 0.8 * blanch));
  skin.albedo = mix(flesh, mottled, mottling);
  vec3 bloodless = mix(vec3(dot(skin.albedo, vec3(0.35, 0.45, 0.20))), vec3(0.78, 0.62, 0.50), 0.62);
  skin.albedo = mix(skin.albedo, bloodless, 0.75 * blanch);
  skin.bump = mottling * (0.010 * medium.xyz + 0.016 * fine.xyz);
  skin.film = wetness * (1.0 - mottling * 0.35 * smoothstep(0.1, 0.8, medium.w + 0.4 * fine.w));
  return skin;
}

// Light that enters the flesh leaves it nearby, red farthest: the border between light and dark is soft and reddish
// (wrapped cosine, each channel with its own width, keeping the mean over all directions).
vec3 scattered_cosine(float cosine) {
  const vec3 wrap = vec3(0.38, 0.14, 0.10);
  vec3 lifted = max((cosine + wrap) / (1.0 + wrap), 0.0);
  return lifted * lifted / (lifted + 0.12) * 1.12 / (1.0 + wrap);
}

float floor_openness(vec3 position, vec3 normal) {
  float height = max(position.z - floor_plane.x, 0.0) / scene_center.w;
  return 1.0 - floor_plane.y * 0.75 * saturate(0.5 - 0.6 * normal.z) * exp(-6.0 * height);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(seen_normal, pixel, 0);
  vec4 rest_and_state = texelFetch(seen_rest, pixel, 0);
  vec3 position = camera_position.xyz + seen.w * ray;
  vec3 view = -normalize(ray);
  vec3 base = normalize(seen.xyz);
  float blanch = fract(rest_and_state.w);
  float hollow = saturate(0.5 + floor(rest_and_state.w) / 1024.0);
  Skin skin = skin_at(rest_and_state.xyz, blanch);
  vec3 normal = normalize(base - (skin.bump - dot(skin.bump, base) * base));
  vec3 film_normal = normalize(mix(base, normal, 1.5));
  // A smooth normal may face away where the triangle is still seen.
  float nv = max(dot(normal, view), 0.02);

  float visible = key_visibility(position, base);
  float openness = rods_openness(position, base) * floor_openness(position, base) * mix(1.08, 0.55, smoothstep(0.5, 0.85, hollow));
  openness = min(openness, 1.0);

  vec3 key = 2.1 * key_direction.w * kKeyColor;
  vec3 fill = 0.42 * fill_direction.w * kFillColor;
  // Shadows on flesh have reddish borders too.
  vec3 soft_visible = vec3(mix(visible, sqrt(visible), 0.6), visible, visible);
  vec3 diffuse = key * soft_visible * scattered_cosine(dot(normal, key_direction.xyz));
  diffuse += fill * openness * scattered_cosine(dot(normal, fill_direction.xyz));
  diffuse += openness * environment_irradiance(normal);

  const float reflectance = 0.035;
  vec2 part = reflected_part(nv, roughness);
  vec3 mirrored = reflect(-view, normal);
  vec3 rough_light = environment_light(mirrored, roughness, visible);
  vec3 result = skin.albedo * (1.0 - reflectance * part.x - part.y) * diffuse;
  result += (reflectance * part.x + part.y) * openness * rough_light;

  // The wet layer: water, so smooth that it mirrors the lamps; what it reflects does not reach the flesh.
  float film = skin.film * (0.022 + 0.978 * fresnel_weight(max(dot(film_normal, view), 0.02)));
  vec3 film_light = environment_light(reflect(-view, film_normal), 0.10, visible);
  result = mix(result, film_light * mix(1.0, openness, 0.7), film);

  color = vec4(dithered(displayed(result), gl_FragCoord.xy), 1.0);
}
