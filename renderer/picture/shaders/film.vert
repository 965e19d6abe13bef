#version 450 core
#include "taken.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in vec4 film;  // inward, width, height, dry
layout(location = 4) in vec2 lie;  // lift, kind
layout(location = 5) in vec3 slope;

layout(location = 2) uniform bool meets_ground;  // which takes up what falls on it

out float gl_ClipDistance[1];

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec3 out_rest;
layout(location = 3) out vec4 out_film;
layout(location = 4) out float out_kind;
layout(location = 5) out vec3 out_slope;

void main() {
  take_frame_along();
  out_position = position;
  gl_ClipDistance[0] = meets_ground && floor_plane.y > 0.0 ? position.z - floor_plane.x : 1.0;
  out_normal = normal;
  out_rest = rest;
  out_film = film;
  out_kind = lie.y;
  out_slope = slope;
  gl_Position = view_projection * vec4(position, 1.0);
  // What lies on a wall of flat triangles dips below it between them.
  vec3 toward_eye = lie.x * normalize(camera_position.xyz - position);
  vec4 nearer = view_projection * vec4(position + toward_eye, 1.0);
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
