#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in vec4 state;  // blanch, curvature, thickness, wound

layout(location = 0) out vec3 out_normal;
layout(location = 1) out vec3 out_rest;
layout(location = 2) out vec4 out_state;

void main() {
  out_normal = normal;
  out_rest = rest;
  out_state = vec4(state.x, 0.03 * scene_center.w * state.y, state.zw);
  gl_Position = view_projection * vec4(position, 1.0);
}
