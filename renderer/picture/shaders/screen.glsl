#include "taken.glsl"

// One triangle over the whole picture, at the far end of depth, with the ray of each pixel: of length one along the line
// of sight. It takes the shared fields of the frame along, see frame.glsl.

layout(location = 0) out vec3 ray;

void cover_screen() {
  take_frame_along();
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec2 place = corner + sample_shift.xy;
  ray = ray_middle.xyz + place.x * ray_right.xyz + place.y * ray_up.xyz;
  gl_Position = vec4(corner, 1.0, 1.0);
}
