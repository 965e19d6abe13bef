#include "environment.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "shadow.glsl"
#include "tone.glsl"
#include "tool_rings.glsl"

// Steel: it shows nothing but its surroundings, here the studio or the cavity, the floor, and the tissue that is seen.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;
layout(location = 2) in vec3 finish;  // roughness, distance along the tool, depth of the rings
layout(location = 3) in vec2 aside;   // distances from its middle line

layout(location = 0) out vec4 color;

layout(location = 4) flat in vec2 depth_terms;  // the first and the second times the depth on the screen are 1 / depth in metres

layout(binding = 2) uniform sampler2D seen_normal;
layout(binding = 4) uniform sampler2D tissue_depth;  // 1 where no tissue is

// What an endoscope's lamp lights around the scene, as a matte colour.
const vec3 kSurroundings = vec3(0.125, 0.050, 0.036);

// The tissue as a ball around the scene's centre: its part of what `direction` sees, blurred; it fades up the shaft.
float tissue_part(vec3 direction, float blur) {
  vec3 toward = scene_center.xyz - position;
  float distance = length(toward);
  float sine = min(0.40 * scene_center.w / max(distance, 1e-9), 1.0);
  float edge = sqrt(1.0 - square(sine));
  float seen = smoothstep(edge - 0.2 - blur, edge + 0.2 + blur, dot(direction, toward) / max(distance, 1e-9));
  return 0.85 * seen * exp(-12.0 * finish.y);
}

// What tissue of the picture sends into the mirror.
vec3 lit_tissue(vec3 place, vec3 normal) {
#ifdef ENDOSCOPE
  return tissue.rgb * (0.06 + 0.94 * saturate(dot(normal, lamp_direction(place)))) * lamp_light(place);
#else
  vec3 sent = saturate(dot(normal, key_direction.xyz)) * lamp_light(place) + environment_irradiance(normal);
  return tissue.rgb * (sent + 0.34 * fill_direction.w * saturate(dot(normal, fill_direction.xyz)) * kFillColor);
#endif
}

// The tissue that is seen in the mirror, if the picture shows it: the way of the ray is followed over the picture until
// it lies behind what is seen there, in steps that grow with the distance. Where it leaves the picture before, the last
// that it passed over is taken to go on. xyz: what comes from there, w: how much of the mirror it fills, less the farther
// away it is, as what brushed steel shows blurs with the distance.
vec4 mirrored_tissue(vec3 direction) {
  const int kSteps = 7;
  const float kFirst = 0.006, kGrowth = 1.55;  // parts of the scene's size
  vec4 onward = view_projection * vec4(direction, 0.0);
  vec2 here = gl_FragCoord.xy * vec2(ray_right.w, ray_up.w);
  vec3 start = vec3(here, 1.0) / gl_FragCoord.w;
  vec3 go = vec3(0.5 * (onward.xy + onward.w), onward.w);
  vec2 size = vec2(textureSize(tissue_depth, 0));
  float way = 0.0, step = kFirst * scene_center.w, to_go = 1e3;
  vec2 pixel = vec2(-1.0);  // where the ray passes over tissue
  float gap = -1.0;         // metres by which it lies behind what is seen there
  for (int i = 0; i < kSteps; ++i) {
    float next_way = way + step;
    vec3 at = start + next_way * go;
    vec2 place = at.xy / at.z;
    if (at.z <= 0.0 || any(greaterThan(abs(place - 0.5), vec2(0.5)))) break;
    vec2 next_pixel = min(place * size, size - 1.0);
    float depth = texelFetch(tissue_depth, ivec2(next_pixel), 0).x;
    bool is_tissue = depth < 1.0;
    // Metres, where they count: close to the surface.
    float next_gap = is_tissue ? at.z * (at.z * (depth_terms.x + depth_terms.y * depth) - 1.0) : -1.0;
    // What lies far before the ray does not end it: it goes on behind.
    if (next_gap > min(3.0 * step, 0.12 * scene_center.w)) break;
    float approach = (next_gap - gap) / step;
    bool goes_on = is_tissue && pixel.x >= 0.0 && approach > 0.0;
    to_go = goes_on ? -next_gap / approach : next_gap > 0.0 ? 0.0 : 1e3;
    pixel = is_tissue ? next_pixel : vec2(-1.0);
    gap = next_gap;
    way = next_way;
    if (gap > 0.0) break;
    step *= kGrowth;
  }
  if (pixel.x < 0.0) return vec4(0.0);
  float near = exp2(-9.0 * max(way + to_go, 0.0) / scene_center.w);
  vec3 normal = normalize(texelFetch(seen_normal, ivec2(pixel), 0).xyz);
  return vec4(lit_tissue(position + way * direction, normal), near);
}

// Along the tool, in the triangle's plane, from how the distance along it changes between pixels (Mikkelsen 2010); not
// of length one, and zero where it does not change.
vec3 along_tool(vec3 normal) {
  vec3 across_pixels = dFdx(position), up_pixels = dFdy(position);
  vec3 plane = cross(across_pixels, up_pixels);
  vec3 axis = dFdx(finish.y) * cross(up_pixels, plane) + dFdy(finish.y) * cross(plane, across_pixels);
  axis -= dot(axis, normal) * normal;
  float size = length(axis);
  return size > 0.0 ? axis / size : vec3(0.0);
}

// What a lamp's light leaves of a streak on brushed steel: fine grooves run around the tool and spread what they mirror
// along it (after Ward 1992). In the units of glint().
float streak(vec3 normal, vec3 axis, vec3 view, vec3 toward) {
  const float kAcross = 0.11, kAlong = 0.55;  // widths of the slopes across the tool and along it
  vec3 halfway = normalize(view + toward);
  float nl = saturate(dot(normal, toward)), nv = max(dot(normal, view), 0.1), nh = max(dot(normal, halfway), 0.1);
  float along = dot(axis, halfway) / kAlong, aside = dot(cross(normal, axis), halfway) / kAcross;
  float part = exp(-(along * along + aside * aside) / square(nh)) * sqrt(nl / nv) / (4.0 * kAcross * kAlong);
  return dot(axis, axis) > 0.0 ? part : 0.0;
}

void main() {
  vec3 from_eye = position - camera_position.xyz;
  vec3 view = -normalize(from_eye);
  vec3 normal = normalize(smooth_normal);
  // Where the normal turns within a pixel, the pixel sees as much more of the surroundings as on a rougher surface
  // (Tokuyoshi and Kaplanyan 2019).
  vec3 across = dFdx(normal), along = dFdy(normal);
  float roughness = sqrt(square(finish.x) + min(0.5 * (dot(across, across) + dot(along, along)), 0.04));
  normal = dot(normal, view) < 0.0 ? -normal : normal;
  vec3 axis = along_tool(normal);

  // Rings of the handle, and the marks that grinding has left; neither is finer than the pixels.
  float pixel = environment.w * dot(from_eye, ray_middle.xyz) / scene_center.w;
  const float kMarks = 560.0;  // over the scene's size
  float turn = 2.0 * kPi * kToolRings * finish.y;
  float ring = finish.z * (1.0 - smoothstep(0.2, 0.5, kToolRings * pixel));
  float groove = finish.z * smoothstep(0.2, 0.9, sin(turn));
  vec4 marks = noise(vec3(kMarks * finish.y, 14.0 * aside));
  vec4 wear = noise(vec3(16.0 * finish.y, 40.0 * aside) + 7.0);
  float marked = (1.0 - smoothstep(0.15, 0.5, kMarks * pixel)) * finish.x;
  vec3 smooth_mirrored = reflect(-view, normal);
  normal = normalize(normal + (0.25 * marked * marks.x + 0.30 * ring * cos(turn)) * axis);
  float nv = max(dot(normal, view), 0.02);

  float visible = key_visibility(position, normal);
  vec3 mirrored = reflect(-view, normal);
  vec3 light = environment_light(mirrored, roughness, mix(0.25, 1.0, visible));
#ifdef ENDOSCOPE
  vec3 toward = lamp_direction(position);
  // The lamp lights what lies before the lens; behind it there is the dark that steel shows in its middle.
  float ahead = dot(mirrored, normalize(ray_middle.xyz));
  light *= 0.12;
  light += kSurroundings * lamp_light(scene_center.xyz) * smoothstep(-0.15 - roughness, 0.95, ahead) * (1.0 + 0.8 * noise(1.6 * mirrored + 5.0).w);
  vec3 tissue_light = 0.45 * tissue.rgb * lamp_light(scene_center.xyz);
#else
  vec3 tissue_light = tissue.rgb * (0.15 + 0.8 * key_direction.w * saturate(key_direction.z)) * environment.x;
#endif
  light = mix(light, tissue_light, 0.6 * tissue_part(mirrored, roughness));
  vec4 sent = mirrored_tissue(smooth_mirrored);
  // The rougher, the more of it is lost among all else.
  light = mix(light, mix(0.72, 0.36, saturate(7.0 * (finish.x - 0.10))) * sent.rgb, sent.w) * (1.0 + marked * marks.w);
#ifdef ENDOSCOPE
  // Brushed: a sharp highlight in a streak.
  float highlight = 0.55 * glint(normal, view, toward, max(square(roughness), 0.02)) +
                    0.06 * glint(normal, view, toward, 0.35) + 0.30 * streak(normal, axis, view, toward);
  light += visible * highlight * (1.0 + 0.9 * marked * marks.w) * lamp_light(position);
#else
  light += 0.25 * mix(0.25, 1.0, visible) * streak(normal, axis, view, key_direction.xyz) * lamp_light(position);
#endif

  const vec3 steel = vec3(0.62, 0.60, 0.575);
  vec3 reflectance = steel + (1.0 - steel) * fresnel_weight(max(nv, 0.25)) * (1.0 - roughness);
  vec3 result = reflectance * light * (1.0 - 0.5 * groove) * (1.0 + 0.10 * wear.w);
  if (tissue.w == 0.0) result = vec3(dot(result, vec3(0.2126, 0.7152, 0.0722)));
  color = finished(result, from_eye / dot(from_eye, ray_middle.xyz), gl_FragCoord.xy);
}
