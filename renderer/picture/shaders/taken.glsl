#include "frame.glsl"

// For vertices: the shared fields of the frame on their way to the fragments, see frame.glsl.

out FrameOfVertices { SHARED_FIELDS(flat) } taken;

void take_frame_along() {
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
}
