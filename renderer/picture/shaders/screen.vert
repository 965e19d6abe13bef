#version 450 core
#include "frame.glsl"

// One triangle over the whole picture, at the far end of depth, with the ray of each pixel: of length one along the line
// of sight.

layout(location = 0) out vec3 ray;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  ray = ray_middle.xyz + corner.x * ray_right.xyz + corner.y * ray_up.xyz;
  gl_Position = vec4(corner, 1.0, 1.0);
}
