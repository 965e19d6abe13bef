#include "frame.glsl"

// Parts of the tree of vessels, see pattern.glsl.

// Part of the light that meets a vessel of half the width `width`, seen `away` from its middle, with soft sides.
float vessel(float away, float width, float blur) {
  float wide = width + blur, squared_wide = wide * wide, squared_away = away * away;
  return width * wide * squared_wide / (squared_wide * squared_wide + squared_away * squared_away);
}

// The angle of `side` in turns, -0.5 to 0.5, within 0.003: arcs of tangents take as long as a noise.
float turns(vec2 side, float over_sum) {
  float part = side.y * over_sum, rise = abs(part);
  part *= 1.0 - 0.363 * (1.0 - rise) * (1.0 - 2.0 * rise);
  return 0.25 * (side.x < 0.0 ? (side.y < 0.0 ? -2.0 : 2.0) - part : part);
}

// How much is seen of a branch `away` from the middle of the vessel that it leaves, over half that one's width. The deeper
// that lies (`up`: 0 deep, 1 at the surface), the farther the branch has to go before it is seen as well: beside a faint
// vessel a red end would stand alone.
float risen(float away, float up) { return saturate((away - 0.7) * mix(0.3, 2.0, up)); }

// The room that a vessel has in fields that are `room` apart. One that has forked by `apart` of the field comes to 0.25 and
// into fields of half the room, so it loses that all along: were it to find itself without where the fields change, it would
// end as an arrowhead.
float room_in_fork(float room, float apart) { return room * (1.0 - 2.0 * apart); }
