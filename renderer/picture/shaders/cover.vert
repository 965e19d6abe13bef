#version 450 core
#include "frame.glsl"

// The scene on the map of the floor, seen along `toward_light`.

layout(location = 0) in vec3 position;
layout(location = 0) uniform vec3 toward_light;
layout(location = 0) out float height;  // above the floor, in units of the scene's size

void main() {
  float above = position.z - floor_plane.x;
  vec2 foot = position.xy - above / toward_light.z * toward_light.xy;
  height = above / scene_center.w;
  gl_Position = vec4((foot - scene_center.xy) / floor_plane.z, 0.0, 1.0);
}
