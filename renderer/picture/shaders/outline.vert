#version 450 core
#include "frame.glsl"

// One instance per segment, one vertex per end.

layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;

layout(location = 0) flat out vec4 window_line;  // both ends, pixels

vec2 window(vec4 clip) { return (0.5 + 0.5 * clip.xy / clip.w) / vec2(ray_right.w, ray_up.w); }

// `end_point`, or where the line from it to `other` comes to be `front` metres before the camera.
vec3 before_camera(vec3 end_point, vec3 other, float front) {
  float own = (view_projection * vec4(end_point, 1.0)).w, others = (view_projection * vec4(other, 1.0)).w;
  return own >= front || others <= front ? end_point : mix(end_point, other, (front - own) / (others - own));
}

void main() {
  // Near an outline the surface comes towards the eye within a pixel by much more than its own depth differs there; an
  // outline that is shown although something just hides it does no harm, for it mixes equal colours.
  float nearer = 0.02 * scene_center.w;
  // Behind the camera there is no window: of a tool that reaches past the camera the part before it is drawn.
  vec3 first = before_camera(start, end, 1.5 * nearer), last = before_camera(end, start, 1.5 * nearer);
  vec3 toward_eye = nearer * normalize(camera_position.xyz - 0.5 * (first + last));
  vec4 clip_start = view_projection * vec4(first + toward_eye, 1.0);
  vec4 clip_end = view_projection * vec4(last + toward_eye, 1.0);
  vec4 own_start = view_projection * vec4(first, 1.0);
  vec4 own_end = view_projection * vec4(last, 1.0);
  bool whole = min(min(clip_start.w, clip_end.w), min(own_start.w, own_end.w)) > 0.0;
  window_line = whole ? vec4(window(own_start), window(own_end)) : vec4(0.0);
  vec4 own = gl_VertexID == 0 ? own_start : own_end;
  vec4 near = gl_VertexID == 0 ? clip_start : clip_end;
  gl_Position = whole ? vec4(own.xy, near.z / near.w * own.w, own.w) : vec4(2.0, 2.0, 2.0, 1.0);
}
