#version 450 core
#include "frame.glsl"

// A ring from the field stop outwards, beyond the picture, as near as can be: a strip of quadrangles whose inner sides
// touch the stop from outside.

const int kSides = 64;

void main() {
  float angle = 2.0 * kPi * float(gl_VertexID / 2) / float(kSides);
  float radius = gl_VertexID % 2 == 0 ? floor_plane.w / cos(kPi / float(kSides)) : 1e3;
  vec2 field = vec2(length(ray_right.xyz), length(ray_up.xyz));
  gl_Position = vec4(radius * vec2(cos(angle), sin(angle)) / field, -1.0, 1.0);
}
