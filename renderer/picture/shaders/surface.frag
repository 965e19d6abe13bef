#version 450 core
#include "seen.glsl"

// What is seen of the tissue, for tissue.frag: shading after this pass is done once per pixel, not once per triangle that
// touches the pixel's block.

layout(location = 0) in vec4 normal;  // w: depth along the line of sight, metres
layout(location = 1) in vec3 place;   // stress-free, 0 to 1 in the box of all
layout(location = 2) in vec3 state;   // blanch, or of layered parts half the wound and a half; bend, likewise; half the thickness
layout(location = 3) flat in uint is_layered;

layout(location = 0) out uvec4 seen;

void main() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  vec3 shown = vec3(state.x, 0.5 + side * (state.y - 0.5), state.z);
  seen = numbers_of(side * normal.xyz, normal.w, place, shown, is_layered != 0u);
}
