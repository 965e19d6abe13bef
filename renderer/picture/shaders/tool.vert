#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 finish;  // roughness, of flat faces below 0; distance along the tool, depth of the rings
layout(location = 3) in vec2 aside;   // distances from its middle line

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec2 out_finish;
layout(location = 3) out vec4 out_place;

void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  out_position = position;
  out_normal = normal;
  out_finish = finish.xz;
  out_place = vec4(finish.y, aside, gl_Position.w);
}
