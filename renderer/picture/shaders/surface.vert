#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in vec4 state;  // blanch, curvature, thickness, wound

layout(location = 0) uniform bool is_layered;

layout(location = 0) out vec4 out_normal;
layout(location = 1) out vec3 out_place;
layout(location = 2) out vec3 out_state;
layout(location = 3) flat out uint out_layered;

void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  // What can be computed here is not computed for each pixel of each triangle.
  out_normal = vec4(normal, gl_Position.w);
  out_place = (rest - rest_grid.xyz) / (65535.0 * rest_grid.w);
  float bend = clamp(0.03 * scene_center.w * state.y, -1.0, 1.0);
  out_state = vec3(is_layered ? 0.5 + 0.5 * state.w : state.x, 0.5 + 0.5 * bend, 0.5 * state.z);
  out_layered = is_layered ? 1u : 0u;
}
