#include "environment.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "shadow.glsl"
#include "tone.glsl"

// Steel: it shows nothing but its surroundings, here the studio, the floor and the tissue below.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;
layout(location = 2) in vec3 finish;

layout(location = 0) out vec4 color;

// What an endoscope's lamp lights around the scene, as a matte colour.
const vec3 kSurroundings = vec3(0.20, 0.125, 0.10);

// The tissue as a ball around the scene's centre: its part of what `direction` sees, blurred; it fades up the shaft.
float tissue_part(vec3 direction, float blur) {
  vec3 toward = scene_center.xyz - position;
  float distance = length(toward);
  float sine = min(0.40 * scene_center.w / max(distance, 1e-9), 1.0);
  float edge = sqrt(1.0 - square(sine));
  float seen = smoothstep(edge - 0.2 - blur, edge + 0.2 + blur, dot(direction, toward) / max(distance, 1e-9));
  return 0.85 * seen * exp(-12.0 * finish.y);
}

// What a lamp's light leaves of a streak on brushed steel: fine grooves run around the tool and spread what they mirror
// along it (after Ward 1992). In the units of glint().
float streak(vec3 normal, vec3 view, vec3 toward) {
  const float kAcross = 0.20, kAlong = 0.55;  // widths of the slopes across the tool and along it
  // Along the tool, in the triangle's plane, from how the distance along it changes between pixels (Mikkelsen 2010).
  vec3 across_pixels = dFdx(position), up_pixels = dFdy(position);
  vec3 plane = cross(across_pixels, up_pixels);
  vec3 axis = dFdx(finish.y) * cross(up_pixels, plane) + dFdy(finish.y) * cross(plane, across_pixels);
  axis -= dot(axis, normal) * normal;
  float size = length(axis);
  vec3 halfway = normalize(view + toward);
  float nl = saturate(dot(normal, toward)), nv = max(dot(normal, view), 0.1), nh = max(dot(normal, halfway), 0.1);
  axis = size > 0.0 ? axis / size : vec3(0.0);
  float along = dot(axis, halfway) / kAlong, aside = dot(cross(normal, axis), halfway) / kAcross;
  float part = exp(-(along * along + aside * aside) / square(nh)) * sqrt(nl / nv) / (4.0 * kAcross * kAlong);
  return size > 0.0 ? part : 0.0;
}

void main() {
  vec3 view = normalize(camera_position.xyz - position);
  vec3 normal = normalize(smooth_normal);
  normal = dot(normal, view) < 0.0 ? -normal : normal;
  // Where the normal turns within a pixel, the pixel sees as much more of the surroundings as on a rougher surface
  // (Tokuyoshi and Kaplanyan 2019).
  vec3 across = dFdx(normal), along = dFdy(normal);
  float roughness = sqrt(square(finish.x) + min(0.5 * (dot(across, across) + dot(along, along)), 0.25));
  float ring = finish.z * sin(2.0 * kPi * 90.0 * finish.y);
  float groove = finish.z * smoothstep(0.2, 0.9, ring);
  float nv = max(dot(normal, view), 0.02);

  float visible = key_visibility(position, normal);
  vec3 mirrored = reflect(-view, normal);
  vec3 light = environment_light(mirrored, roughness, mix(0.25, 1.0, visible));
#ifdef ENDOSCOPE
  vec3 toward = lamp_direction(position);
  // The lamp lights what lies before the lens; behind it there is the dark that steel shows in its middle.
  float ahead = dot(mirrored, normalize(ray_middle.xyz));
  light *= 0.35;
  light += kSurroundings * lamp_light(scene_center.xyz) * smoothstep(-0.25 - roughness, 0.95, ahead) * (1.0 + 0.8 * noise(1.1 * mirrored + 5.0).w);
  vec3 tissue_light = 0.6 * tissue.rgb * lamp_light(scene_center.xyz);
  light = mix(light, tissue_light, tissue_part(mirrored, roughness));
  // Brushed: a sharp highlight in a streak.
  float highlight = 0.55 * glint(normal, view, toward, max(square(roughness), 0.02)) +
                    0.25 * glint(normal, view, toward, 0.4) + 0.33 * streak(normal, view, toward);
  light += visible * highlight * lamp_light(position);
#else
  vec3 tissue_light = tissue.rgb * (0.15 + 0.8 * key_direction.w * saturate(key_direction.z));
  light = mix(light, tissue_light * environment.x, tissue_part(mirrored, roughness));
  light += 0.25 * mix(0.25, 1.0, visible) * streak(normal, view, key_direction.xyz) * lamp_light(position);
#endif

  const vec3 steel = vec3(0.62, 0.60, 0.575);
  vec3 reflectance = steel + (1.0 - steel) * fresnel_weight(max(nv, 0.25)) * (1.0 - roughness);
  vec3 result = reflectance * light * (1.0 - 0.65 * groove);
  vec3 ray = position - camera_position.xyz;
  color = finished(result, ray / dot(ray, ray_middle.xyz), gl_FragCoord.xy);
}
