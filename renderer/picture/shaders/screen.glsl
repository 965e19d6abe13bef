#include "frame.glsl"

// One triangle over the whole picture, at the far end of depth, with the ray of each pixel: of length one along the line
// of sight. It takes the shared fields of the frame along, see frame.glsl.

layout(location = 0) out vec3 ray;
out FrameOfVertices { SHARED_FIELDS(flat) } taken;

void cover_screen() {
  taken.shadow_matrix = shadow_matrix;
  taken.camera_position = camera_position;
  taken.scene_center = scene_center;
  taken.floor_plane = floor_plane;
  taken.key_direction = key_direction;
  taken.key_right = key_right;
  taken.panels = panels;
  taken.fill_direction = fill_direction;
  taken.environment = environment;
  taken.background = background;
  taken.floor_key = floor_key;
  taken.floor_sky = floor_sky;
  taken.rest_grid = rest_grid;
  taken.rod_start = rod_start;
  taken.rod_span = rod_span;

  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec2 place = corner + sample_shift.xy;
  ray = ray_middle.xyz + place.x * ray_right.xyz + place.y * ray_up.xyz;
  gl_Position = vec4(corner, 1.0, 1.0);
}
