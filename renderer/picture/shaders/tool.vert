#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 finish;  // roughness, of flat faces below 0; distance along the tool, depth of the rings
layout(location = 3) in vec2 aside;   // distances from its middle line
layout(location = 4) in vec3 narrow;  // of a narrow side: out of a broad one, as long as it is wide, metres
layout(location = 5) in vec2 broad;   // and by which that leans there, and its roughness

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec2 out_finish;
layout(location = 3) out vec4 out_place;

// A side that is narrower than a pixel is hit by one here and there, and would show as dashes: it looks as the broad one
// beside it does. xyz: normal, w: roughness.
vec4 seen_steel(float depth) {
  float width = length(narrow);
  if (!(width > 0.0)) return vec4(normal, finish.x);
  vec3 view = normalize(camera_position.xyz - position), across = narrow / width;
  vec3 outward = normalize(normal - dot(normal, across) * across);
  vec3 beside = normalize((dot(across, view) < 0.0 ? -across : across) - broad.x * outward);
  float pixels = width * abs(dot(outward, view)) / (environment.w * depth);
  return mix(vec4(beside, broad.y), vec4(normal, finish.x), smoothstep(1.0, 1.8, pixels));
}

void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  out_position = position;
  vec4 steel = seen_steel(gl_Position.w);
  out_normal = steel.xyz;
  out_finish = vec2(steel.w, finish.z);
  out_place = vec4(finish.y, aside, gl_Position.w);
}
