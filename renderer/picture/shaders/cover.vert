#version 450 core
#include "frame.glsl"

// The scene on the map of the floor's shade, seen along z.

layout(location = 0) in vec3 position;
layout(location = 0) out float height;  // above the floor, in units of the scene's size

void main() {
  height = (position.z - floor_plane.x) / scene_center.w;
  gl_Position = vec4((position.xy - scene_center.xy) / floor_plane.z, 0.0, 1.0);
}
