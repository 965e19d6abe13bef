#include "environment.glsl"
#include "lamp.glsl"
#include "occlusion.glsl"
#include "pattern.glsl"
#include "reflection.glsl"
#include "scattering.glsl"
#include "seen.glsl"
#include "shadow.glsl"
#include "tone.glsl"

// Living tissue: scattering flesh with mottling and vessels below a wet layer. What TissuePrograms.cpp defines leaves out
// what a part of it or the scene does not have, for llvmpipe computes both sides of each branch.

layout(location = 0) in vec3 ray;

layout(location = 0) out vec4 color;

layout(binding = 2) uniform usampler2D seen_tissue;

// By how much more red light than other comes to the border of a shadow: little, for in flesh red goes hardly farther
// than the border is wide.
const float kRedBorder = 0.25;

// Deep in a cut: what is left of light that has been at the other face, which is red, and what part of the room is seen.
const vec3 kFromFace = vec3(0.92, 0.62, 0.55);
const float kSeenRoom = 0.4;
const float kLeastFaceCosine = 0.3;  // so uneven is a face that along it its bumps hide what would mirror most

// What is mirrored within wounds and opened organs where the lamp does not reach: the walls rather than the room.
const vec3 kShadedRoom = vec3(0.45, 0.20, 0.17);

float floor_openness(vec3 position, vec3 normal) {
  float height = max(position.z - floor_plane.x, 0.0) / scene_center.w;
  return 1.0 - floor_plane.y * 0.75 * saturate(0.5 - 0.6 * normal.z) * exp(-6.0 * height);
}

void main() {
  // Before what is computed from the numbers of the pixel, which come from memory meanwhile.
  vec2 lens = through_lens(ray);
  Seen seen = seen_from(texelFetch(seen_tissue, ivec2(gl_FragCoord.xy), 0), rest_grid, LAYERED);
  vec3 position = camera_position.xyz + seen.depth * ray;
  vec3 view = -normalize(ray);
  vec3 base = seen.normal;
  float wound = seen.wound;
  // Before the skin is computed: what the map says comes from memory meanwhile.
  float visible = SHADOWED ? key_visibility(position, base) : 1.0;
  // A smooth normal may face away where the triangle is still seen.
  float base_nv = max(dot(base, view), 0.05);
  Skin skin = skin_at(seen.rest, environment.w * seen.depth / base_nv, seen.blanch, seen.thickness, wound);
  vec3 bump = skin.bump - dot(skin.bump, base) * base;
  vec3 normal = normalize(base - 0.6 * bump);
  // Seen along the wall the film's relief hides its own valleys.
  float shown = smoothstep(0.15, 0.95, base_nv);
  vec3 film_normal = normalize(base - 1.3 * shown * bump);
  float nv = max(dot(normal, view), 0.02);
  float film_nv = max(dot(film_normal, view), LAYERED ? kLeastFaceCosine : 0.02);

  vec3 toward = lamp_direction(position);
  vec3 lamp = lamp_light(position);
  // Light that has come into an opened organ goes from wall to wall.
  float bounced = ENCLOSED && !LAYERED ? 0.20 : 0.0;
#ifdef ENDOSCOPE
  bounced = max(bounced, 0.18);  // the walls of the cavity send light into shadows
#endif
  float lit = ENCLOSED ? key_mirrored(visible, base, toward) : visible;
  visible = mix(bounced, 1.0, visible);
  float hollow = max(seen.bend, 0.0);
  float openness = rods_openness(position, base) * floor_openness(position, base) * (1.0 - 0.55 * smoothstep(0.0, 0.8, hollow));

  vec3 width = clamp(scatter.rgb * (30.0 + abs(seen.bend) / (0.03 * scene_center.w)), 0.03, 0.7);
  // Shadows on flesh have reddish borders too.
  vec3 soft_visible = vec3(visible * (1.0 + kRedBorder * (1.0 - visible)), visible, visible);
  if (ENCLOSED && !LAYERED) soft_visible *= mix(kFromFace, vec3(1.0), lit);
  // Light that is caught between the walls of a crease is reddened by each.
  // Powers of 0.85 (within 0.003) and 1.25 from two roots.
  float root = sqrt(openness), second_root = sqrt(root);
  vec3 open_color = vec3(mix(openness, root * second_root, 0.554), vec2(openness * second_root));
  vec3 diffuse = lamp * soft_visible * scattered_cosine(dot(normal, toward), width);
#ifndef ENDOSCOPE
  vec3 fill = 0.34 * fill_direction.w * kFillColor;
  diffuse += fill * open_color * scattered_cosine(dot(normal, fill_direction.xyz), width);
#else
  diffuse *= mix(vec3(1.0), open_color, 0.5);
#endif
  diffuse += open_color * environment_irradiance(normal);
  vec3 around = vec3(openness);
  if (LAYERED) {
    diffuse *= mix(vec3(1.0), kFromFace, saturate(wound));
    around *= mix(vec3(1.0), kSeenRoom * kFromFace, saturate(0.3 + wound));
  }
  if (ENCLOSED) {
    float inside = LAYERED ? smoothstep(0.0, 0.25, wound) : 1.0;
    diffuse += inside * kFromWalls * lamp;
    around *= mix(vec3(1.0), mix(kShadedRoom, vec3(1.0), lit), inside);
  }

  // Cut fibres mirror one another more than the lamps.
  const float reflectance = LAYERED ? 0.016 : 0.028;
  float rough = sqrt(square(flesh.w) + min(skin.lost_bump, 0.2));
  vec2 part = reflected_part(nv, rough);
  float veil = scatter.w * vessels.w * fresnel_weight(nv);
  vec3 albedo = mix(skin.albedo, vec3(0.75), veil);
  vec3 result = albedo * (1.0 - reflectance * part.x - part.y) * diffuse;
  result += (reflectance * part.x + part.y) * around * environment_light(reflect(-view, normal), rough, visible);

  // The wet layer: water, so smooth that it mirrors the lamps; what it reflects does not reach the flesh.
  // What is hardly wet is greasy: its film is too thin to lie smooth, or fine relief would sparkle as frost does.
  // Cut fibres are finer than pixels show.
  const float kGreasy = 0.10, kFibres = 0.06;  // squares of its roughness
  float greasy = kGreasy * square(saturate(1.0 - 2.0 * blood.w)) + (LAYERED ? kFibres : 0.0);
  float film = skin.film * (0.022 + 0.978 * fresnel_weight(film_nv));
  float film_rough = sqrt(0.0064 + greasy + min(skin.lost_bump + 0.08 * (1.0 - shown), 0.1));
  vec3 film_light = environment_light(reflect(-view, film_normal), film_rough, visible, lamp_size) * mix(vec3(1.0), around, 0.7);
  result = mix(result, film_light, film);

#ifdef ENDOSCOPE
  float lamp_fresnel = fresnel_weight(dot(view, normalize(view + toward)));
  float gloss = (1.0 - film) * (reflectance + (1.0 - reflectance) * lamp_fresnel) * glint(normal, view, toward, square(rough));
  float film_alpha = sqrt(0.0014 + greasy + min(skin.lost_bump, 0.1));
  gloss += skin.film * (0.022 + 0.978 * lamp_fresnel) * glint(film_normal, view, toward, film_alpha);
  result += visible * gloss * lamp;
#endif

  color = finished(result, lens, gl_FragCoord.xy);
}
