#include "environment.glsl"
#include "lamp.glsl"
#include "mirror.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "seen.glsl"
#include "shadow.glsl"
#include "tone.glsl"
#include "tool_rings.glsl"

// Steel: it shows nothing but its surroundings, here the studio or the cavity, the floor, and the tissue that is seen.

layout(location = 0) in vec3 ray;
in MirrorOfVertices { MIRROR_FIELDS(flat) };

layout(location = 0) out vec4 color;

layout(binding = 2) uniform usampler2D seen_tissue;
layout(binding = 3) uniform sampler2D tool_place;    // these three: see tool.frag
layout(binding = 4) uniform sampler2D tissue_depth;  // 1 where no tissue is, 0 outside the field stop
layout(binding = 6) uniform sampler2D tool_normal;
layout(binding = 7) uniform sampler2D tool_axis;

// What is seen of a tool at a pixel.
struct Steel {
  vec3 position;     // metres
  float depth;       // along the line of sight, metres
  float along;       // the tool from its tip, in units of the scene's size
  vec2 aside;        // of its middle line, likewise
  vec3 normal;       // smooth
  float finish;      // roughness
  float roughness;   // as much more of it as the normal turns within the pixel
  float flatness;    // 1 on flat faces, 0 on round ones
  vec3 axis;         // along the tool, or zero where nothing tells
  float ring_depth;  // 0 to 1
  float shade;       // part of the light that parts of the tool close by take
};

Steel steel_at(ivec2 pixel) {
  vec4 place = texelFetch(tool_place, pixel, 0), normal = texelFetch(tool_normal, pixel, 0);
  vec4 axis = texelFetch(tool_axis, pixel, 0);
  float size = length(normal.xyz);
  return Steel(camera_position.xyz + place.w * ray, place.w, place.x, place.yz, normal.xyz / size, size - 1.0,
               abs(normal.w), normal.w < 0.0 ? 1.0 : 0.0, axis.xyz, max(axis.w, 0.0), max(-axis.w, 0.0));
}

// 0 where it is polished, 1 where it is brushed.
float brushing(Steel steel) { return saturate(7.0 * (steel.finish - 0.10)); }

// What an endoscope's lamp lights around the scene, as matte colours: all of it, hollows, and what glistens.
const vec3 kSurroundings = vec3(0.125, 0.050, 0.036);
const vec3 kHollow = vec3(0.037, 0.034, 0.033);
const vec3 kGlistening = vec3(0.95, 0.89, 0.87);

// Part of a lamp's light that the fine scratches of brushed steel send everywhere: it is grey between its highlights.
const float kScratched = 0.035;

// The tissue as a ball around the scene's centre: its part of what `direction` sees, blurred; it fades up the shaft.
float tissue_part(Steel steel, vec3 direction) {
  vec3 toward = scene_center.xyz - steel.position;
  float distance = length(toward);
  float sine = min(0.40 * scene_center.w / max(distance, 1e-9), 1.0);
  float edge = sqrt(1.0 - square(sine)), blur = steel.roughness;
  float seen = smoothstep(edge - 0.2 - blur, edge + 0.2 + blur, dot(direction, toward) / max(distance, 1e-9));
  return 0.85 * seen * exp(-12.0 * steel.along);
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
// that it passed over is taken to go on, and for a step where it leaves the tissue, whose outline would show as a straight
// edge. xyz: what comes from there, w: how much of the mirror it fills, less the farther away it is, as what brushed steel
// shows blurs with the distance.
vec4 mirrored_tissue(Steel steel, vec3 direction) {
  const int kSteps = 7, kStepsInDents = 3;
  const float kFirst = 0.006, kGrowth = 1.55;  // parts of the scene's size
  float onward = dot(line_of_sight.xyz, direction);
  vec2 here = gl_FragCoord.xy * vec2(floor_key.w, floor_sky.w);
  vec3 start = steel.depth * vec3(here, 1.0);
  vec3 go = vec3(0.5 * (vec2(dot(clip_x.xyz, direction), dot(clip_y.xyz, direction)) + onward), onward);
  vec2 size = vec2(textureSize(tissue_depth, 0));
  float way = 0.0, step = kFirst * scene_center.w;
  float meets = 1e3, beyond = 1.0;  // how far it goes until it meets the tissue, and after it was over that, in steps
  vec2 pixel = vec2(-1.0);  // where the ray passes over tissue
  float gap = -1.0;         // metres by which it lies behind what is seen there
  bool goes_on = true, is_over = false;  // tissue, after the last step
  // Without a way out of it the loop is unrolled, which on llvmpipe takes half as long.
  for (int i = 0; i < kSteps; ++i) {
    vec3 at = start + (way + step) * go;
    vec2 place = at.xy / at.z;
    goes_on = goes_on && at.z > 0.0 && all(lessThanEqual(abs(place - 0.5), vec2(0.5)));
    vec2 next_pixel = clamp(place * size, vec2(0.0), size - 1.0);
    float depth = texelFetch(tissue_depth, ivec2(next_pixel), 0).x;
    bool is_tissue = depth > 0.0 && depth < 1.0;
    // Metres, where they count: close to the surface.
    float next_gap = is_tissue ? at.z * (at.z * (clip_x.w + clip_y.w * depth) - 1.0) : -1.0;
    // What lies far before the ray does not end it: it goes on behind, unseen. In a dent, behind whose near border a tool
    // stands, the wall there is as that border is.
    bool is_before = goes_on && next_gap > min(3.0 * step, 0.12 * scene_center.w);
    bool is_in_dent = is_before && i < kStepsInDents;
    goes_on = goes_on && !is_before;
    float approach = (next_gap - gap) / step;
    bool nears = is_over && approach > 0.0;
    bool goes_over = goes_on && is_tissue;
    float to_go = nears ? -next_gap / approach : next_gap > 0.0 ? 0.0 : 1e3;
    meets = goes_over ? way + step + to_go : meets;
    beyond = goes_over ? to_go / step : beyond;
    meets = is_in_dent ? way + step : meets;
    pixel = goes_over || is_in_dent ? next_pixel : pixel;
    gap = goes_on ? next_gap : gap;
    is_over = goes_on ? is_tissue : is_over || is_in_dent;
    way = goes_on ? way + step : way;
    goes_on = goes_on && gap <= 0.0;
    step *= kGrowth;
  }
  if (pixel.x < 0.0) return vec4(0.0);
  float far = max(meets, 0.0) / scene_center.w;
  const float kReach = 0.22;  // of all steps
  float near = exp2(-9.0 * far) * (1.0 - smoothstep(0.5 * kReach, kReach, far));
  near *= is_over ? 1.0 : 1.0 - smoothstep(0.0, 1.0, beyond);
  // Where it meets the tissue, rather than at the step beyond, which flat faces would show as blocks.
  float met_way = min(meets, way + step);
  vec3 met = start + met_way * go;
  vec2 met_pixel = clamp(met.xy / met.z * size, vec2(0.0), size - 1.0);
  float met_depth = texelFetch(tissue_depth, ivec2(met_pixel), 0).x;
  pixel = met.z > 0.0 && met_depth > 0.0 && met_depth < 1.0 ? met_pixel : pixel;
  vec3 normal = direction_of(two_from(texelFetch(seen_tissue, ivec2(pixel), 0).w));
  return vec4(lit_tissue(steel.position + met_way * direction, normal), near);
}

// Seen along itself a flat face mirrors what lies behind it, however far away. It is narrow then, and hit by pixels here and
// there: were it dark it would show as dashes. Lips, rims and folds there would shine through the steel as if it were
// glass, so the tissue is as bright as where it faces the viewer. xyz: what it sends from there, w: how much of the mirror
// it fills.
vec4 tissue_behind(Steel steel, vec3 view, float nv) {
  const float kAlong = 0.03, kAside = 0.22;  // cosines
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(tissue_depth, pixel, 0).x;
  float part = depth > 0.0 && depth < 1.0 ? steel.flatness * (1.0 - smoothstep(kAlong, kAside, nv)) : 0.0;
  vec3 sent = lit_tissue(steel.position, view);
  // It may be steel that it borders on.
  const float kGrey = 0.6;
  return vec4(mix(sent, vec3(dot(sent, vec3(0.2126, 0.7152, 0.0722))), kGrey), part * tissue.w);
}

// What a lamp's light leaves of a streak on brushed steel: fine grooves run around the tool and spread what they mirror
// along it (after Ward 1992). In the units of glint().
float streak(vec3 normal, vec3 axis, vec3 view, vec3 toward, float turned) {
  // Widths of the slopes across the tool, where more the more the normal turns within the pixel, and along it.
  const float kAlong = 0.55;
  float across = sqrt(square(0.11) + turned);
  vec3 halfway = normalize(view + toward);
  float nl = saturate(dot(normal, toward)), nv = max(dot(normal, view), 0.1), nh = max(dot(normal, halfway), 0.1);
  float along = dot(axis, halfway) / kAlong, aside = dot(cross(normal, axis), halfway) / across;
  float part = exp(-(along * along + aside * aside) / square(nh)) * sqrt(nl / nv) / (4.0 * across * kAlong);
  return dot(axis, axis) > 0.0 ? part : 0.0;
}

// What comes from `mirrored`, but for what the picture shows; `smooth_mirrored` is that without marks.
vec3 surroundings_light(Steel steel, vec3 view, vec3 mirrored, vec3 smooth_mirrored, float visible) {
  float roughness = steel.roughness, flatness = steel.flatness;
  vec3 light = environment_light(mirrored, roughness, mix(0.25, 1.0, visible));
  // A flat face shows a small part of what is around, which is as far away as the scene is large: light and dark in turns,
  // whose borders are as sharp as the steel is smooth.
  vec3 seen_there = 3.0 * (steel.position - scene_center.xyz) / scene_center.w +
                    mix(3.0, 1.8, brushing(steel)) * mix(smooth_mirrored, mirrored, 0.3);
  float around = noise(mix(1.6 * mirrored, seen_there, flatness) + 5.0).w;
  float lit_there = smoothstep(-0.09 - 1.1 * roughness, 0.07 + 1.1 * roughness, around);
#ifdef ENDOSCOPE
  // The lamp lights what lies before the lens; behind it there is the dark that steel shows in its middle.
  float ahead = dot(mirrored, line_of_sight.xyz);
  light *= 0.12;
  light += mix(kSurroundings * (1.0 + 0.8 * around), mix(kHollow, (0.5 + 0.9 * saturate(1.6 * around)) * kGlistening, lit_there), flatness) *
           lamp_light(scene_center.xyz) * smoothstep(mix(-0.15, -0.6, flatness) - roughness, 0.95, ahead);
  vec3 tissue_light = 0.45 * tissue.rgb * lamp_light(scene_center.xyz);
#else
  // Below, the ground, which lies farther off than the tissue and is seen beside that.
  float below = floor_plane.y * smoothstep(-0.02 - roughness, 0.10 + roughness, -mirrored.z);
  light = mix(light, 0.8 * floor_key.rgb + floor_sky.rgb, 0.20 * below);
  // The front of the room, which a flat face shows that looks at the viewer.
  float toward_viewer = smoothstep(-0.3, 0.7, dot(mirrored.xy, view.xy));
  light += flatness * environment.x * environment.y * key_direction.w * toward_viewer * mix(0.10, 0.66, lit_there) * kFillColor;
  vec3 tissue_light = tissue.rgb * (0.15 + 0.8 * key_direction.w * saturate(key_direction.z)) * environment.x;
#endif
  return mix(light, tissue_light, mix(0.35, 0.15, flatness) * tissue_part(steel, mirrored));
}

void main() {
  Steel steel = steel_at(ivec2(gl_FragCoord.xy));
  vec3 position = steel.position, axis = steel.axis;
  float roughness = steel.roughness, turned = max(square(roughness) - square(steel.finish), 0.0);
  float flatness = steel.flatness;
  vec3 view = -normalize(ray);
  // The smooth normal of a rounded edge may turn away where the edge is still seen: there it is seen along itself. Turned
  // round it would mirror what is behind the viewer, in single pixels beside those that do not.
  vec3 normal = normalize(steel.normal - min(dot(steel.normal, view), 0.0) * view);

  // Rings of the handle, and the marks that grinding has left; neither is finer than the pixels.
  float level = environment.w * steel.depth / scene_center.w, facing = dot(normal, view);
  float pixel = level / max(facing, 0.2);
  // Of the way along the tool a pixel sees the more the nearer to the line of sight the tool lies.
  float pixel_along = level * sqrt(1.0 + square(dot(steel.axis, view) / max(facing, 0.02)));
  const float kMarks = 560.0;  // over the scene's size
  float turn = 2.0 * kPi * kToolRings * steel.along;
  float ring = steel.ring_depth * (1.0 - smoothstep(0.2, 0.5, kToolRings * max(pixel, pixel_along)));
  // Lands with a groove between them: only its flanks lean.
  float flank = saturate(2.0 * sin(turn) - 0.9);
  const float kMeanGroove = 0.249;  // of a whole ring
  float groove = steel.ring_depth * mix(flank * flank * (3.0 - 2.0 * flank), kMeanGroove,
                                        smoothstep(0.25, 0.6, kToolRings * pixel_along));
  float lean = 4.0 * flank * (1.0 - flank) * cos(turn);
  vec4 marks = noise(vec3(kMarks * steel.along, 14.0 * steel.aside));
  vec4 wear = noise(vec3(16.0 * steel.along, 40.0 * steel.aside) + 7.0);
  float marked = (1.0 - smoothstep(0.08, 0.32, kMarks * pixel)) * 0.55 * max(steel.finish - 0.10, 0.0);
  vec3 smooth_mirrored = reflect(-view, normal);
  normal = normalize(normal + (0.15 * marked * marks.x + 0.55 * ring * lean) * axis);
  float nv = max(dot(normal, view), 0.02);

  float visible = key_visibility(position, normal);
  vec3 mirrored = reflect(-view, normal);
  vec3 light = surroundings_light(steel, view, mirrored, smooth_mirrored, visible);
  vec4 sent = mirrored_tissue(steel, smooth_mirrored);
  // Beside what the lamps do to a flat face it is pale.
#ifdef ENDOSCOPE
  sent.w *= mix(1.0, 0.35, flatness);
#else
  sent.w *= mix(1.0, 0.6, flatness);
#endif
  // The rougher, the more of it is lost among all else.
  float brushed = brushing(steel);
  light = mix(light, mix(0.72, 0.45, brushed) * sent.rgb, mix(1.0, 0.45, brushed) * sent.w) * (1.0 + marked * marks.w);
  vec4 behind = tissue_behind(steel, view, nv);
  light = mix(light, behind.rgb, behind.w);
#ifdef ENDOSCOPE
  vec3 toward = lamp_direction(position);
  // Brushed: a sharp highlight in a streak, and a wide one that makes flat faces grey which are turned away from the lamp.
  float highlight = mix(0.55, 0.40, flatness) * glint(normal, view, toward, max(square(roughness), 0.02)) +
                    mix(0.06, 0.15, flatness) * glint(normal, view, toward, mix(0.28, 0.38, brushed)) +
                    mix(0.30, 0.20 * brushed, flatness) * streak(normal, axis, view, toward, turned) +
                    kScratched * brushed * saturate(dot(normal, toward));
  light += visible * highlight * (1.0 + 0.9 * marked * marks.w) * lamp_light(position);
#else
  float highlight = 0.25 * streak(normal, axis, view, key_direction.xyz, turned) +
                    kScratched * brushed * saturate(dot(normal, key_direction.xyz));
  light += mix(0.25, 1.0, visible) * highlight * lamp_light(position);
#endif

  const vec3 kSteel = vec3(0.62, 0.60, 0.575);
  vec3 reflectance = kSteel + (1.0 - kSteel) * fresnel_weight(max(nv, 0.25)) * (1.0 - roughness);
  vec3 result = reflectance * light * (1.0 - steel.shade) * (1.0 - 0.5 * groove) * (1.0 + 0.10 * wear.w);
  if (tissue.w == 0.0) result = vec3(dot(result, vec3(0.2126, 0.7152, 0.0722)));
  color = finished(result, ray, gl_FragCoord.xy);
}
