#version 450 core

// What is seen of the tissue, for tissue.frag: shading after this pass is done once per pixel, not once per triangle that
// touches the pixel's block.

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 rest;
layout(location = 2) in vec4 state;

layout(location = 0) out vec4 seen_normal;  // xyz, of length 2^wound; w: depth along the line of sight, metres
layout(location = 1) out vec4 seen_rest;    // xyz; w: blanch, bend and thickness in steps of 1, 2^8 and 2^16

void main() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  seen_normal = vec4(side * exp2(state.w) * normalize(normal), 1.0 / gl_FragCoord.w);
  // 255 steps each: together they fill the 24 bits of a float's whole numbers.
  vec3 parts = clamp(vec3(state.x, 0.5 + 0.5 * side * state.y, 0.5 * state.z), 0.0, 1.0);
  seen_rest = vec4(rest, dot(floor(255.0 * parts + 0.5), vec3(1.0, 256.0, 65536.0)));
}
