#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in vec4 state;  // blanch, curvature, thickness, wound

layout(location = 0) out vec4 out_normal;
layout(location = 1) out vec3 out_rest;
layout(location = 2) out vec3 out_state;

void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  // What can be computed here is not computed for each pixel of each triangle.
  out_normal = vec4((1.0 + state.w) * normal, gl_Position.w);
  out_rest = rest;
  out_state = clamp(vec3(state.x, 0.03 * scene_center.w * state.y, 0.5 * state.z), vec3(0.0, -1.0, 0.0), vec3(1.0));
}
