#include "frame.glsl"
#include "look.glsl"
#include "noise.glsl"
#include "vessel.glsl"

in LookOfVertices { LOOK_FIELDS(flat) };

// What the tissue is like at a place of the stress-free wall.
struct Skin {
  vec3 albedo;
  vec3 bump;        // slope of the fine relief, to be taken from the normal
  float lost_bump;  // square of the slope that is too fine to be seen
  float film;       // strength of the wet layer
};

// Part of a pattern with waves of 1 / `frequency` metres that pixels of `footprint` metres still show; the rest would
// sparkle when it moves.
float resolved(float frequency, float footprint) { return 1.0 - smoothstep(0.2, 0.55, frequency * footprint); }

// The tree of vessels, see VesselTree.hpp. Around its line the wall is divided into as many fields as there are trunks;
// in the middle of each runs a vessel, that forks into the middles of the two halves of its field, and so on. So no
// vessel ever meets another, and all fork at sharp angles.

struct Vessels {
  float trunks;
  float branches;
};

Vessels vessels_at(vec3 place, vec4 coarse, vec4 fine, vec4 broad, float footprint) {
  vec3 from_middle = place - tree_middle.xyz;
  float onward = dot(from_middle, tree_along.xyz);
  vec2 side = vec2(dot(from_middle, tree_across.xyz), dot(from_middle, tree_aside.xyz));
  float over_sum = 1.0 / max(abs(side.x) + abs(side.y), 1e-4);

  // Noise bends the fields, and with them the vessels.
  const float kSway = 0.10, kBend = 0.045, kCurl = 0.012;
  float field = tree_along.w * turns(side, over_sum) + kSway * broad.w + kBend * coarse.w + kCurl * fine.w;
  // The farther from the slender end the oftener it has forked, and the thinner it is.
  const float kForks = 3.0;
  float grown = clamp(0.6 * kForks + 0.5 * kForks * onward * tree_middle.w + 0.3 * broad.w, 0.0, kForks - 0.001);
  float forks = floor(grown), part = grown - forks;
  float fields = forks > 1.5 ? 4.0 : 1.0 + forks;
  float inside = fract(field * fields) - 0.5;
  float apart = 0.25 * part * part * (3.0 - 2.0 * part);
  // Metres from one vessel's field to the next's; that noise bends them changes it little.
  float room = 2.0 * kPi / tree_along.w * length(side) / fields;
  float beside = (abs(inside) - apart) * room;
  float width = tree_across.w * (1.0 - 0.24 * grown);

  // Here they lie at the surface, there they go deeper, softer to the eye; where fields end close together, none is left.
  float up = smoothstep(-0.6, 0.5, 0.6 * broad.y + 0.4 * coarse.x);
  float blur = 0.5 * footprint, over_width = 1.0 / width;
  float free_room = vessels.y * room_in_fork(room, apart);
  float shown = (0.55 + 0.45 * up) * saturate(7.0 * free_room - 1.75);
  float out_there = abs(beside);
  // Here rather than where it is used: there llvmpipe takes 4 % longer for the tissue.
  float there = risen(out_there * over_width, up);
  Vessels result;
  result.trunks = shown * vessel(beside, width, blur + 0.22 * tree_across.w * (1.0 - up));

  // Small ones leave them forward, now on this side, now on that, and end before they reach the next field's.
  const vec2 kForward = vec2(0.45, -0.80);  // waves over the spacing, along the wall and away from the vessel
  const float kWaves = 0.918;               // its length
  float wave = vessels.y * (kForward.x * onward + kForward.y * out_there) + (inside * beside < 0.0 ? 0.0 : 0.5) +
               0.12 * coarse.w + 0.03 * fine.w;
  float end = (abs(inside) > apart ? 0.5 - apart : apart) * room;
  float left = saturate(1.0 - 1.2 * out_there / max(end, 1e-6));
  // Beside a vessel that thins out they would stand alone.
  there *= smoothstep(-0.35, 0.15, broad.x + 0.5 * coarse.z) * saturate(3.0 * left) * saturate(12.0 * free_room - 4.3);
  float nearest = (fract(wave) - 0.5) / (kWaves * vessels.y);
  result.branches = there * vessel(nearest, tree_across.w * (0.14 + 0.28 * left), blur + 0.06 * tree_across.w);
  return result;
}

// Fat lies where broad noise is high. Its border is that of its lobules.
float fat_at(vec4 broad, vec4 fine, float lobes) {
  float cover = smoothstep(-0.03, 0.09, 0.8 * broad.w + 0.16 * fine.w + 0.12 * lobes + 2.0 * fat.w - 0.95);
  return FATTY ? cover : 0.0;
}

// Lobules of fat have reddish walls between them, where the grain passes through zero.
vec3 fat_color(float fine, float lobes) {
  return fat.rgb * mix(vec3(0.80, 0.60, 0.50), vec3(1.0 + 0.15 * fine), smoothstep(0.0, 0.16, abs(lobes)));
}

// What of a cut face are the mouths of vessels that bleed.
const vec3 kBleedingPoint = vec3(0.060, 0.0016, 0.0022);

// Layers of a wall that is cut through, by the depth in it: serosa, muscle, mucosa, or the skin's. The middle one is made of
// bundles in pale sheaths, with vessels between them; a pale layer lies between it and the innermost, but not where these
// look alike, as within a solid organ.
vec3 layers_at(float depth, vec4 coarse, vec4 fine, vec4 grain) {
  float wavy = depth + 0.05 * coarse.w + 0.06 * fine.w + 0.05 * grain.w;
  float bundles = 0.6 * fine.w + 0.7 * grain.w;
  vec3 middle = blood.rgb * (1.0 + 0.55 * bundles);
  float sheath = 1.0 - smoothstep(0.0, 0.11, abs(grain.w - 0.5 * fine.w));
  middle = mix(middle, 0.5 * (flesh.rgb + blood.rgb), 0.30 * sheath);
  middle = mix(middle, middle * vec3(0.62, 0.30, 0.32), smoothstep(0.35, 0.75, abs(fine.w) + 0.4 * grain.w));
  middle = mix(middle, kBleedingPoint, 0.8 * smoothstep(0.34, 0.52, 0.8 * fine.w - 0.5 * grain.w));
  // The outermost one has soaked up blood, here more, there less.
  vec3 outer = mix(flesh.rgb * (1.0 + 0.12 * grain.w), blood.rgb, 0.55 * smoothstep(-0.1, 0.6, coarse.w + 0.5 * fine.w));
  vec3 color = mix(outer, middle, smoothstep(-0.03, 0.03, wavy - pattern.z));
  // The innermost one is lobular: its lobules reach outwards here more, there less, with reddish walls between them.
  // Walls lie where the grain passes through zero.
  float lobule = smoothstep(0.0, 0.22, abs(grain.w));
  vec3 inner = fat.rgb * mix(vec3(0.78, 0.52, 0.48), vec3(1.0 + 0.25 * coarse.w), lobule);
  const float kHills = 0.22, kLobules = 0.30, kMeanGrain = 0.25;  // of the thickness; the last of abs(grain.w)
  float lobular = wavy + kHills * coarse.w + kLobules * (abs(grain.w) - kMeanGrain) - pattern.w;
  const float kAlike = 0.03, kUnlike = 0.10;  // linear colours
  float parted = smoothstep(kAlike, kUnlike, distance(fat.rgb, blood.rgb));
  float pale = 0.6 * parted * (1.0 - smoothstep(0.02, 0.10, abs(lobular + 0.05)));
  color = mix(color, flesh.rgb, pale);
  return mix(color, inner, smoothstep(-0.06, 0.06, lobular));
}

// Friction ridges run in a whorl around the middle of the pad, half a millimetre apart and closer beside it, and are
// lower farther off.
vec3 ridge_bump(vec3 place, vec4 broad, float footprint) {
  const float kRidges = 2000.0, kBends = 2.6;  // 1 / metre; ridges by which noise shifts them
  const float kSlender = 1.6;                  // square of how much longer the whorl is than wide
  const float kCore = 0.0005, kFrom = 0.008, kTo = 0.022;  // metres: of its middle, and between which it gets lower
  vec2 off = (place - tree_middle.xyz).xy;
  float away = sqrt(kSlender * square(off.x) + square(off.y) + square(kCore));
  float phase = kRidges * away + kBends * broad.w;
  float height = mix(1.0, 0.25, smoothstep(kFrom, kTo, away));
  float slope = relief.w * height * resolved(kRidges, footprint) * sin(2.0 * kPi * phase);
  return slope / away * vec3(kSlender * off.x, off.y, 0.0);
}

// Of what the skin sends back, what is left above a vein, which lies so deep that it is seen as a bluish shade.
const vec3 kVein = vec3(0.84, 0.90, 0.95);

// How much of one is seen, 0 to 1: they run side by side, far apart, and show here and there.
float vein_at(vec3 place, vec4 broad, vec4 coarse) {
  const float kApart = 0.036, kHalfWidth = 0.0011;  // metres
  float away = fract(dot(place, vec3(0.62, 0.74, 0.26) / kApart) + 0.10 * broad.w + 0.03 * coarse.w + 0.31) - 0.5;
  return exp2(-square(kApart / kHalfWidth * away)) * smoothstep(-0.5, 0.5, broad.y + 0.5 * coarse.x);
}

// Folds of a lining that is not stretched: plump, with narrow furrows between them, along the organ in bends, and here and
// there none. As many stand around its line as two for each of the outer side's vessels. xyz: their slope; w: 0 in a furrow
// to 1 on a fold.
vec4 folds_at(vec3 place, vec4 broad, vec4 coarse, float thickness, float footprint) {
  const float kBends = 0.32, kFineBends = 0.05;  // turns of a fold and its furrow
  const float kSteepness = 0.60, kRound = 0.05;
  const float kWidest = 90.0, kNarrowest = 150.0;  // pairs of a fold and a furrow, 1 / metre: between them folds end
  vec3 from_middle = place - tree_middle.xyz;
  vec2 side = vec2(dot(from_middle, tree_across.xyz), dot(from_middle, tree_aside.xyz));
  float away = max(length(side), 1e-5);
  float phase = tree_along.w * turns(side, 1.0 / max(abs(side.x) + abs(side.y), 1e-4)) + kBends * broad.w + kFineBends * coarse.w;
  float per_metre = tree_along.w / (2.0 * kPi * away);
  vec3 around = (side.x * tree_aside.xyz - side.y * tree_across.xyz) / away;
  vec3 across = normalize(per_metre * around + kBends * pattern.y * broad.xyz);
  float wave = sin(2.0 * kPi * phase);
  float slack = (pattern.w - 1.0) * smoothstep(0.40, 0.80, thickness) * resolved(2.0 * per_metre, footprint) * (1.0 - smoothstep(kWidest, kNarrowest, per_metre));
  slack *= smoothstep(-2.4, -0.6, broad.x);
  vec3 slope = wave * inversesqrt(square(wave) + kRound) * cos(2.0 * kPi * phase) * across;
  return vec4(kSteepness * slack * slope, mix(1.0, smoothstep(0.0, 0.75, abs(wave)), slack));
}

// Mucus lies on a lining in pale patches.
const vec3 kMucus = vec3(0.66, 0.46, 0.34);

// `place`: stress-free, metres; `footprint`: what a pixel covers, metres; `thickness`: over that of the stress-free wall;
// `depth`: in a rim from 0 outside to 1 inside.
Skin skin_at(vec3 place, float footprint, float blanch, float thickness, float depth) {
  vec4 broad = noise(pattern.y * place + 11.3);
  // Drawn out, so that vessels run along and seldom close to rings. Skin, which has none, is red in smaller spots.
  const float kSpots = 4.8;
  vec3 drawn_out = (PORED ? kSpots : 1.0) * vessels.y * vec3(0.6, 1.05, 0.95) * place;
  vec4 coarse = noise(drawn_out + 0.10 * broad.zxy + 3.1);
  vec4 fine = noise(2.7 * drawn_out + 0.12 * coarse.yzx + 7.7);
  // Lines of the skin run along it rather than across.
  vec3 drawn = PORED ? vec3(0.72, 1.15, 1.0) * place : place;
  vec4 grain = noise(relief.y * drawn + 0.05 * fine.xyz);
  vec4 dust = DUSTED ? noise(2.9 * relief.y * place + 0.08 * grain.zxy) : vec4(0.0);
  float grain_seen = resolved(0.7 * relief.y, footprint);
  float dust_seen = resolved(2.0 * relief.y, footprint);

  Skin skin;
  float redness = pattern.x * (0.75 * broad.w + 0.35 * coarse.w + 0.25 * fine.w + 0.12 * dust_seen * grain.w);
  vec3 redder = flesh.rgb * mix(vec3(1.0), blood.rgb / max(flesh.rgb, 0.02), 0.45);
  vec3 paler = 1.18 * flesh.rgb + 0.03;
  vec3 albedo = mix(flesh.rgb, redness > 0.0 ? redder : paler, saturate(abs(redness)));
  float lobes = mix(0.3, grain.w, grain_seen);
  float fatty = fat_at(broad, fine, lobes);
  if (FATTY) albedo = mix(albedo, fat_color(fine.w, lobes), 0.9 * fatty);

  // What lies behind shines through, the more the thinner the wall is (Lambert and Beer).
  float clear = CLEAR ? exp2(thickness * through.w) : 0.0;
  albedo = mix(albedo, through.rgb, clear * (1.0 - fatty));

  Vessels tree = VESSELED ? vessels_at(place, coarse, fine, broad, footprint) : Vessels(0.0, 0.0);
  float bloody = (1.0 - 0.85 * blanch) * (1.0 - 0.8 * fatty);
  // The wall above a deep vessel scatters blue light back before red, which makes trunks look darker and cooler.
  vec3 deep = mix(blood.rgb, albedo * vec3(0.42, 0.34, 0.44), 0.40);
  albedo = mix(albedo, deep, vessels.x * 0.90 * bloody * tree.trunks);
  albedo = mix(albedo, blood.rgb, vessels.z * 0.85 * bloody * tree.branches);

  float pore = PORED ? tree_aside.w * grain_seen * smoothstep(0.42, 0.75, grain.w) : 0.0;
  if (PORED) albedo *= mix(vec3(1.0), kVein, tree_aside.w * vein_at(place, broad, coarse)) * (1.0 - 0.18 * pore);

  vec4 fold = FOLDED ? folds_at(place, broad, coarse, thickness, footprint) : vec4(0.0, 0.0, 0.0, 1.0);
  if (FOLDED) {
    const vec3 kFurrow = vec3(0.74, 0.54, 0.49);  // parts of the light
    albedo *= mix(kFurrow, vec3(1.0), fold.w);
    albedo = mix(albedo, kMucus, 0.45 * smoothstep(0.25, 0.95, coarse.w + 0.35 * fine.w + 0.25 * (1.0 - fold.w)));
  }

  vec3 bloodless = mix(vec3(dot(albedo, vec3(0.35, 0.45, 0.20))) * vec3(1.10, 0.99, 0.88), vec3(0.70, 0.56, 0.44), 0.45);
  albedo = mix(albedo, bloodless, 0.65 * blanch);
  skin.albedo = mix(flesh.rgb, saturate3(albedo), vessels.w);
  if (LAYERED) skin.albedo = layers_at(depth, coarse, fine, grain);

  // Furrowed relief has sharp valleys where the noise passes through zero.
  float furrow = grain.w * inversesqrt(square(grain.w) + 0.02);
  float fine_furrow = dust.w * inversesqrt(square(dust.w) + 0.03);
  vec3 grain_bump = CREASED ? grain.xyz * mix(1.0, furrow, relief.z) : grain.xyz;
  vec3 dust_bump = CREASED ? dust.xyz * mix(1.0, fine_furrow, relief.z) : dust.xyz;
  float slope = 0.4 * relief.x * vessels.w;
  // Where its outer layer covers it, a wall ends smooth.
  if (LAYERED) slope *= mix(0.35, 1.0, smoothstep(-0.08, 0.0, depth));
  skin.bump = slope * (grain_seen * grain_bump + 0.55 * dust_seen * dust_bump + 0.30 * coarse.xyz + 1.2 * fatty * fine.xyz);
  if (FOLDED) skin.bump += fold.xyz;
  if (RIDGED) skin.bump += vessels.w * ridge_bump(place, broad, footprint);
  skin.lost_bump = square(slope) * (5.0 * (1.0 - square(grain_seen)) + 1.6 * (1.0 - square(dust_seen)));
  skin.film = blood.w * (1.0 - vessels.w * 0.35 * smoothstep(0.1, 0.7, 0.6 * coarse.w + 0.6 * fine.w));
  return skin;
}
