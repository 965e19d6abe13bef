// What all shaders know of a picture. The fields are explained in FrameUniforms.hpp, which fills them.
//
// llvmpipe spends half a nanosecond per pixel on each number that a fragment shader reads from a uniform block, and next to
// nothing on one that comes flat from the vertices. Shaders that read many therefore define FRAME_FROM_VERTICES before this
// file is included and get the shared fields from vertices that take them along (taken.glsl), under the same names.
#define SHARED_FIELDS(how) \
  how mat4 shadow_matrix; \
  how vec4 camera_position; \
  how vec4 scene_center; \
  how vec4 floor_plane; \
  how vec4 key_direction; \
  how vec4 key_right; \
  how vec4 panels; \
  how vec4 fill_direction; \
  how vec4 environment; \
  how vec4 background; \
  how vec4 floor_key; \
  how vec4 floor_sky; \
  how vec4 rest_grid; \
  how vec4 rod_start[3]; \
  how vec4 rod_span[3];

#ifdef FRAME_FROM_VERTICES
in FrameOfVertices { SHARED_FIELDS(flat) };
#else
layout(std140, binding = 0) uniform Frame {
  mat4 view_projection;
  vec4 ray_middle;
  vec4 ray_right;
  vec4 ray_up;
  vec4 tissue;
  vec4 sample_shift;
  SHARED_FIELDS(highp)
};
#endif

const float kPi = 3.14159265;
const vec3 kKeyColor = vec3(1.0, 0.955, 0.89);   // a warm lamp
const vec3 kLampColor = vec3(1.0, 0.97, 0.93);   // xenon behind glass fibres
const vec3 kFillColor = vec3(0.80, 0.90, 1.0);   // a cool wall

float square(float x) { return x * x; }
float saturate(float x) { return clamp(x, 0.0, 1.0); }
vec2 saturate2(vec2 x) { return clamp(x, 0.0, 1.0); }
vec3 saturate3(vec3 x) { return clamp(x, 0.0, 1.0); }
