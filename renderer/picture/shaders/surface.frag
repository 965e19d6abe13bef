#version 450 core

// What is seen of the tissue, for tissue.frag: shading after this pass is done once per pixel, not once per triangle that
// touches the pixel's block.

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 rest;
layout(location = 2) in vec2 state;

layout(location = 0) out vec4 seen_normal;  // w: blanch
layout(location = 1) out vec4 seen_rest;    // w: hollow
layout(location = 2) out float seen_depth;  // along the line of sight, metres

void main() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  seen_normal = vec4(side * normal, state.x);
  seen_rest = vec4(rest, side * state.y);
  seen_depth = 1.0 / gl_FragCoord.w;
}
