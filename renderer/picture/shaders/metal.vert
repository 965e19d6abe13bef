#version 450 core
#include "screen.glsl"
#include "mirror.glsl"

// The whole picture, with what metal mirrors in it.

out MirrorOfVertices { MIRROR_FIELDS(flat) } passed;

vec3 row(int k) { return vec3(view_projection[0][k], view_projection[1][k], view_projection[2][k]); }

void main() {
  cover_screen();
  passed.tissue = tissue;
  passed.line_of_sight = vec4(normalize(ray_middle.xyz), 0.0);
  // Before scaling to 0 to 1 depth on the screen is a - b / depth.
  float a = (view_projection * vec4(ray_middle.xyz, 0.0)).z, b = -(view_projection * vec4(camera_position.xyz, 1.0)).z;
  passed.clip_x = vec4(row(0), (a + 1.0) / b);
  passed.clip_y = vec4(row(1), -2.0 / b);
}
