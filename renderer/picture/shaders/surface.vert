#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in vec2 state;

layout(location = 0) out vec3 out_normal;
layout(location = 1) out vec3 out_rest;
layout(location = 2) out vec2 out_state;

void main() {
  out_normal = normal;
  out_rest = (rest - scene_center.xyz) / scene_center.w;
  out_state = state;
  gl_Position = view_projection * vec4(position, 1.0);
}
