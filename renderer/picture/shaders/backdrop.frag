#version 450 core
#define FRAME_FROM_VERTICES
#include "tone.glsl"

// What lies behind the scene, drawn at a quarter of the size: nothing in it is sharp, and it fills half of the picture.

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 color;

layout(binding = 4) uniform sampler2D backdrop;

void main() {
  vec2 place = gl_FragCoord.xy * vec2(floor_key.w, floor_sky.w);
  color = vec4(dithered(field_stop(ray) * texture(backdrop, place).rgb, gl_FragCoord.xy), 1.0);
}
