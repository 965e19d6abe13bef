#version 450 core
#define FRAME_FROM_VERTICES
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

// Vessels run where noise passes through zero; noise that is drawn out makes them long. 1 in the middle of a vessel, with
// soft sides, for vessels lie below the surface. `stretch` is the noise's frequency, `width` half a vessel's.
float vessel(vec4 field, vec3 stretch, float width) {
  float distance = abs(field.w) / (width * max(length(stretch * field.xyz), 0.5 * stretch.y));
  return 1.0 / (1.0 + square(square(distance)) + 0.5 * square(distance));
}

Skin skin_at(vec3 place, float blanch) {
  const vec3 medium_stretch = vec3(8.0, 27.0, 25.0);
  const vec3 fine_stretch = vec3(58.0, 76.0, 70.0);
  vec4 broad = noise(6.0 * place + 11.3);
  vec4 medium = noise(medium_stretch * place + 0.40 * broad.zxy + 3.1);
  vec4 fine = noise(fine_stretch * place + 0.45 * medium.yzx);
  float veins = vessel(medium, medium_stretch, 0.0011 + 0.0011 * abs(broad.y)) * smoothstep(-0.35, 0.35, broad.w);
  float capillaries = vessel(fine, fine_stretch, 0.0009) * smoothstep(-0.1, 0.6, medium.w - 0.3 * broad.w);
  Skin skin;
  vec3 redder = flesh * vec3(0.90, 0.58, 0.60);
  vec3 paler = flesh * vec3(1.05, 1.12, 1.02) + vec3(0.012, 0.008, 0.005);
  vec3 mottled = mix(redder, paler, saturate(0.42 + 0.60 * broad.w + 0.20 * medium.w + 0.10 * fine.w));
  vec3 blood = flesh * vec3(0.50, 0.17, 0.26);
  mottled = mix(mottled, blood, saturate(0.36 * veins + 0.15 * capillaries) * (1.0 - 0.8 * blanch));
  skin.albedo = mix(flesh, mottled, mottling);
  vec3 bloodless = mix(vec3(dot(skin.albedo, vec3(0.35, 0.45, 0.20))), vec3(0.70, 0.53, 0.42), 0.62);
  skin.albedo = mix(skin.albedo, bloodless, 0.6 * blanch);
  skin.bump = mottling * (0.007 * medium.xyz + 0.015 * fine.xyz);
  skin.film = wetness * (1.0 - mottling * 0.45 * smoothstep(0.0, 0.7, 0.6 * medium.w + 0.7 * fine.w));
  return skin;
}

// Light that enters the flesh leaves it nearby, red farthest: the border between light and dark is soft and reddish
// (wrapped cosine, each channel with its own width, keeping the mean over all directions).
vec3 scattered_cosine(float cosine) {
  const vec3 wrap = vec3(0.30, 0.13, 0.10);
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
  vec3 film_normal = normalize(mix(base, normal, 0.8));
  // A smooth normal may face away where the triangle is still seen.
  float nv = max(dot(normal, view), 0.02);

  float visible = key_visibility(position, base);
  float openness = rods_openness(position, base) * floor_openness(position, base) * mix(1.08, 0.55, smoothstep(0.5, 0.85, hollow));
  openness = min(openness, 1.0);

  vec3 key = 1.8 * key_direction.w * kKeyColor;
  vec3 fill = 0.34 * fill_direction.w * kFillColor;
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
  vec3 film_light = environment_light(reflect(-view, film_normal), 0.05, visible);
  result = mix(result, film_light * mix(1.0, openness, 0.7), film);

  color = vec4(dithered(displayed(result), gl_FragCoord.xy), 1.0);
}
