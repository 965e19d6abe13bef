#version 450 core

// What is seen of the tissue, for tissue.frag: shading after this pass is done once per pixel, not once per triangle that
// touches the pixel's block.

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 rest;
layout(location = 2) in vec2 state;

layout(location = 0) out vec4 seen_normal;  // xyz; w: depth along the line of sight, metres
layout(location = 1) out vec4 seen_rest;    // xyz; w: blanch in the fraction, hollow in steps of 2 ^ -10 before it

void main() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  seen_normal = vec4(side * normal, 1.0 / gl_FragCoord.w);
  seen_rest = vec4(rest, floor(512.0 * side * state.y + 0.5) + clamp(state.x, 0.0, 0.999));
}
