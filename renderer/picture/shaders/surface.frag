#version 450 core

// What is seen of the tissue, for tissue.frag: shading after this pass is done once per pixel, not once per triangle that
// touches the pixel's block.

layout(location = 0) in vec4 normal;  // xyz, of length 1 + wound; w: depth along the line of sight, metres
layout(location = 1) in vec3 rest;
layout(location = 2) in vec3 state;   // blanch 0 to 1, bend -1 to 1, half the thickness 0 to 1

layout(location = 0) out vec4 seen_normal;  // as it came, towards the viewer
layout(location = 1) out vec4 seen_rest;    // xyz; w: blanch, bend and thickness in steps of 1, 2^8 and 2^16

void main() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  seen_normal = vec4(side * normal.xyz, normal.w);
  // 255 steps each: together they fill the 24 bits of a float's whole numbers.
  vec3 parts = floor(vec3(255.0, 127.5 * side, 255.0) * state + vec3(0.5, 128.0, 0.5));
  seen_rest = vec4(rest, dot(parts, vec3(1.0, 256.0, 65536.0)));
}
