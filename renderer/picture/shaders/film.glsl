#define TOOLS_SHADE
#include "environment.glsl"
#include "lamp.glsl"
#include "noise.glsl"
#include "reflection.glsl"
#include "shadow.glsl"
#include "tone.glsl"
#include "turning.glsl"

// A fluid that lies on a wall or runs down it: rounded towards its edge, or a coat that thins to nothing; deeper in colour
// where it is thick, glossy until it is dry.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in vec4 film;  // metres from the edge inwards, metres to where it is thickest, height there, dry

layout(location = 4) in float kind;  // 0: a drop or run; 1: a coat that thins to nothing; 2: one that ends in an edge
layout(location = 5) in vec3 inward_slope;  // of what lies on the outer side: how film.x grows, 1 / metre

layout(location = 0, index = 0) out vec4 color;  // is added to what is left of the pixel
layout(location = 0, index = 1) out vec4 through;  // part of each channel that is left

layout(location = 0) uniform vec4 fluid;  // linear colour of a deep layer; w: 1 / clarity, 1 / metre
layout(location = 1) uniform float cloudiness;  // part of what it takes of the light that it sends back

void main() {
  float coat = min(kind, 1.0), edged = max(kind - 1.0, 0.0);
  vec3 from_eye = position - camera_position.xyz;
  float depth = 1.0 / gl_FragCoord.w;
  float pixel = environment.w * depth;
  // Its own tension keeps its edge from turning sharply.
  const float kWaves = 190.0, kFineWaves = 640.0;  // 1 / metre
  vec4 coarse = noise(kWaves * rest);
  vec4 fine = noise(kFineWaves * rest + 3.0);
  float width = max(film.y, 1e-6);
  // The narrower, the more of its sides is what is fine in the wall below it.
  float finely = 0.10 + min(0.14, 0.00006 / width);
  float uneven = width * (0.55 * coarse.w + finely * fine.w);
  float inward = film.x + uneven;
  // It meets the wall at the same angle everywhere: lower where it is narrower, and thin at its edge.
  float local = width + uneven;
  float rise = saturate(inward / local), fall = 1.0 - rise;
  float cap = 1.0 - fall * fall * fall;
  // Its tension levels what is fine but for its edge.
  float drop_height = film.z * cap * (1.0 + 0.70 * coarse.w);

  // A coat is as thick as what wells up and runs together makes it: here much, there hardly any. Where it wells up it
  // stands in beads, none finer than the pixels.
  const float kPatches = 0.90, kStreaks = 0.30, kBeads = 0.12;  // over the thickness where `film.x` is `film.y`
  const float kBeadFoot = 0.05, kBeadCrown = 0.65;             // of the noise
  float seen = 1.0 - smoothstep(0.2, 0.5, kFineWaves * pixel);
  float climb = saturate((fine.w - kBeadFoot) / (kBeadCrown - kBeadFoot));
  float bead = seen * climb * climb * (3.0 - 2.0 * climb);
  vec3 bead_change = seen * 6.0 * climb * (1.0 - climb) / (kBeadCrown - kBeadFoot) * kFineWaves * fine.xyz;
  // Where it ends in an edge its tension leaves no beads.
  float beads = kBeads * (1.0 - edged);
  float fullness = film.x / width + kPatches * coarse.w + kStreaks * seen * fine.w + beads * bead;
  vec3 full_change = kPatches * kWaves * coarse.xyz + kStreaks * seen * kFineWaves * fine.xyz + beads * bead_change;
  // Grows from nothing without an edge, then by as much as there is more. What ends in an edge grows sooner, as it meets
  // the wall at an angle there, and is level farther in.
  float fade = mix(0.5, 0.25, edged);
  const float kContact = 1.2;  // slope
  float full = max(fullness, 0.0), over = 1.0 / (full + fade);
  float grown = full * full * over;
  float steepness = kContact * width / max(film.z, 1e-7), lacking = exp(-steepness * grown);
  float coat_height = film.z * mix(grown, 1.0 - lacking, edged);
  float height = mix(drop_height, coat_height, coat);

  vec3 base = normalize(smooth_normal);
  // The slope of a drop or run over the wall. Its unevenness is taken to be turned as at rest: triangles of a run that bends
  // on a stretched wall would each turn and stretch it their own way, which shows as lines across what the run mirrors.
  vec3 uneven_change = width * (0.55 * kWaves * coarse.xyz + finely * kFineWaves * fine.xyz);
  vec3 lumpy = 0.70 * kWaves * coarse.xyz;
  vec3 drop_slope = film.z / width * 3.0 * fall * fall * (inward_slope + fall * uneven_change) + film.z * cap * lumpy;
  drop_slope -= dot(drop_slope, base) * base;
  // That of a coat from how its height changes between pixels (Mikkelsen 2010). What the noise adds is told by its
  // gradient: differences of it would stay the same over each two by two pixels.
  vec3 across = dFdx(position), along = dFdy(position);
  // The distance to an edge is told at vertices, and so turns at each of the triangles' borders. Coats that have a width of
  // 1 have no edge.
  vec2 inward_change = width < 0.5 ? vec2(dot(inward_slope, across), dot(inward_slope, along))
                                   : vec2(dFdx(film.x), dFdy(film.x));
  vec2 coat_change = film.z * full * (full + 2.0 * fade) * over * over * mix(1.0, steepness * lacking, edged) *
                     (inward_change / width + vec2(dot(full_change, dFdx(rest)), dot(full_change, dFdy(rest))));
  vec3 first = cross(along, base), second = cross(base, across);
  float area = dot(across, first);
  vec3 coat_slope = (coat_change.x * first + coat_change.y * second) / (abs(area) > 1e-16 ? area : 1e-16);
  vec3 slope = mix(drop_slope, coat_slope, coat);
  vec3 view = -normalize(from_eye);
  float facing = dot(base, view);
  // Seen along the wall it hides what of it is turned away.
  float steepest = mix(clamp(1.2 * facing - 0.2, 0.05, 0.6), max(2.0 * facing, 0.05), edged);
  slope *= inversesqrt(1.0 + dot(slope, slope) / square(steepest));
  // A coat follows what is fine in the wall below it, so its highlights are broken; where it is deep it is level. Faces of a
  // cut and the ground of a wound, whose coats have a width of 1, are of cut fibres and more uneven than skin.
  const float kOnSkin = 0.18, kInWound = 0.34;  // slope
  float followed = width < 0.5 ? kOnSkin : kInWound;
  vec3 relief = coat * (1.0 - 0.7 * edged) * followed / (1.0 + full * full) * fine.xyz;
  vec3 normal = normalize(base - slope - (relief - dot(relief, base) * base));
  // Along it its unevenness hides what would mirror most, of a coat more.
  const float kLeastCosine = 0.2, kLeastCoatCosine = 0.3;
  float nv = max(dot(normal, view), mix(kLeastCosine, kLeastCoatCosine, coat));

  const float kWets = 0.00005;  // metres that mirror as any more do
  float covered = mix(smoothstep(0.0, max(2.0 * pixel, 0.00006), inward), smoothstep(0.0, kWets, coat_height), coat);
  // A run, which is lifted towards the eye, is not hidden by the wall that it lies behind, so it ends where that turns away.
  // A drop that falls is inside its edge everywhere.
  float is_run = (1.0 - coat) * saturate(2.0 - inward / local);
  covered *= mix(1.0, smoothstep(0.0, 0.15, facing), is_run);
  // What a deep layer swallows most a thin one swallows first: it is tinted before it is opaque.
  vec3 swallowed = -log(clamp(fluid.rgb, 0.004, 0.9));
  // The rim of a drop is a wedge, which light leaves by its side: it is clearer than it is thin.
  float way = height * mix(0.6 + 0.4 * cap, 1.0, coat) * slant(nv);
  vec3 left = exp(-way * fluid.w * swallowed / dot(swallowed, vec3(1.0 / 3.0)));
  // A thin film tints what lies below; only a deep one hides it by what floats in it.
  float hidden = mix(0.4 + 0.6 * (1.0 - left.g), 1.0, coat);
  float dry = film.w;

  vec3 toward = lamp_direction(position);
  vec3 lamp = lamp_light(position);
  // Along its rim a run sends light on to its other side, which shows as a fine dark line where it is turned to the lamp; of
  // a clear one less.
  const float kRim = 0.00016;                        // metres
  const float kClearShade = 0.06, kDeepShade = 0.22;  // parts of the light
  float rim = max(kRim, 1.5 * pixel);
  float turned = saturate(0.5 - dot(inward_slope, toward) * inversesqrt(max(dot(inward_slope, inward_slope), 1e-12)));
  float rim_shade = turned * mix(kClearShade, kDeepShade, 1.0 - exp2(-1.5 * film.z * fluid.w));
  left *= 1.0 - rim_shade * is_run * (kRim / rim) * exp2(-6.0 * square(inward / rim - 0.5));
  float lit = key_visibility(position, base);
  float visible = mix(0.12, 1.0, lit);
  float cosine = saturate(0.25 + 0.75 * dot(normal, toward));
  vec3 deep = fluid.rgb * mix(1.0, 0.45, dry);
  vec3 body = deep * ((visible * cosine + coat * kFromWalls) * lamp + environment_irradiance(normal));
  float gloss = 1.0 - 0.85 * dry;
  float lost = turned_within_pixel(normal);
  // On what is cut some of the fibres below it are finer than pixels show.
  const float kFibres = 0.05;  // square of their slope
  lost += width < 0.5 ? 0.0 : kFibres / (1.0 + full * full);
  float mirror = gloss * (0.022 + 0.978 * fresnel_weight(nv));
  // In the shadow of a tool part of the room is seen, in that of a wound the other wall, wet with blood.
  float mirrors_key = mix(0.12, 1.0, key_mirrored(lit, base, toward));
  vec3 seen_room = mix(mix(vec3(0.3), vec3(0.11, 0.025, 0.020), coat), vec3(1.0), mirrors_key);
  // Where it slopes away from the eye it mirrors the wall beside it, which looks as what is seen through it does.
  vec3 mirrored_way = reflect(-view, normal);
  float mirrors_room = mix(smoothstep(-0.2, 0.3, dot(mirrored_way, base)), 1.0, coat - edged);
  vec3 shine = mirrors_room * mirror * seen_room * environment_light(mirrored_way, sqrt(0.0064 + lost), mirrors_key);
#ifdef ENDOSCOPE
  float lamp_mirror = gloss * (0.022 + 0.978 * fresnel_weight(dot(view, normalize(view + toward))));
  shine += visible * lamp_mirror * glint(normal, view, toward, sqrt(0.0036 + lost)) * lamp;
#endif
  // What the film mirrors is added as on film: it brightens what lies below, and never darkens it.
  vec3 ray = from_eye / depth;
  // Where it is steep, at its edge, a pixel would see single glints. Where a run wells up from nothing it is too flat to
  // level the wall below it, whose own wet layer is seen there.
  const float kFlat = 0.10;  // height over half the width
  float own = mix(smoothstep(0.0, 0.2, rise) * smoothstep(0.0, kFlat, film.z / width), 1.0, coat);
  vec3 mirrored = own * field_stop(ray) * displayed(lens_light(ray) * shine);
  vec3 below = hidden * cloudiness * (1.0 - left) * finished(body, ray, gl_FragCoord.xy).rgb;
  color = vec4(covered * (mirrored + (1.0 - mirrored) * below), 1.0);
  through = vec4(1.0 - covered * (1.0 - (1.0 - mirrored) * left), 1.0);
}
