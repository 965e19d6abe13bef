#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 finish;  // roughness, distance along the tool, depth of the rings
layout(location = 3) in vec2 aside;

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec3 out_finish;
layout(location = 3) out vec2 out_aside;
layout(location = 4) flat out vec2 depth_terms;

void main() {
  out_position = position;
  out_normal = normal;
  out_finish = finish;
  out_aside = aside;
  // Before scaling to 0 to 1 depth on the screen is a - b / depth.
  float a = (view_projection * vec4(ray_middle.xyz, 0.0)).z, b = -(view_projection * camera_position).z;
  depth_terms = vec2(a + 1.0, -2.0) / b;
  gl_Position = view_projection * vec4(position, 1.0);
}
