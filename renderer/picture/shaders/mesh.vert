#version 450 core
#include "frame.glsl"

// A strip of two triangles for each edge, as wide as its line and its soft border, a little before the wall.

layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in float strength;  // 1 at cuts, else 0

layout(location = 0) noperspective out float offset;  // from the line's middle, pixels
layout(location = 1) flat out float half_width;       // of the line, pixels
layout(location = 2) flat out float is_cut;

void main() {
  vec2 size = 1.0 / vec2(ray_right.w, ray_up.w);
  vec3 toward_eye = 0.002 * scene_center.w * normalize(camera_position.xyz - 0.5 * (start + end));
  vec4 clip[2] = vec4[2](view_projection * vec4(start, 1.0), view_projection * vec4(end, 1.0));
  int which = gl_VertexID / 2;
  vec4 near = view_projection * vec4((which == 0 ? start : end) + toward_eye, 1.0);
  // In small pictures, as those in a corner are, a cut would be too faint to be seen.
  const float kLeastCut = 0.7;  // pixels
  half_width = max(mix(0.55, 1.4, strength) * size.y / 720.0, kLeastCut * strength);
  is_cut = strength;
  offset = (gl_VertexID % 2 == 0 ? -1.0 : 1.0) * (half_width + 1.0);
  if (min(min(clip[0].w, clip[1].w), near.w) <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 along = (clip[1].xy / clip[1].w - clip[0].xy / clip[0].w) * size;
  vec2 across = dot(along, along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
  vec4 own = clip[which];
  gl_Position = vec4(own.xy + offset * across * 2.0 / size * own.w, near.z / near.w * own.w, own.w);
}
