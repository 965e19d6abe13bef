#version 450 core
#include "taken.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;

void main() {
  take_frame_along();
  out_position = position;
  out_normal = normal;
  gl_Position = view_projection * vec4(position, 1.0);
}
