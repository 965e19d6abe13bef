// What all shaders know of a picture. The fields are explained in FrameUniforms.hpp, which fills them.
layout(std140, binding = 0) uniform Frame {
  mat4 view_projection;
  mat4 shadow_matrix;
  vec4 camera_position;
  vec4 ray_middle;
  vec4 ray_right;
  vec4 ray_up;
  vec4 scene_center;
  vec4 floor_plane;
  vec4 key_direction;
  vec4 key_right;
  vec4 panels;
  vec4 fill_direction;
  vec4 environment;
  vec4 background;
  vec4 floor_key;
  vec4 floor_sky;
  vec4 tissue;
  vec4 rod_start[3];
  vec4 rod_span[3];
};

const float kPi = 3.14159265;
const vec3 kKeyColor = vec3(1.0, 0.955, 0.89);   // a warm lamp
const vec3 kFillColor = vec3(0.80, 0.90, 1.0);   // a cool wall

float square(float x) { return x * x; }
float saturate(float x) { return clamp(x, 0.0, 1.0); }
vec2 saturate2(vec2 x) { return clamp(x, 0.0, 1.0); }
