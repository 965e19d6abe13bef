#version 450 core
#define FRAME_FROM_VERTICES
#include "seen.glsl"
#include "tone.glsl"

// A number of the wall as a colour. Colours are those of the legend where the wall faces the viewer, and darker only
// where it turns away, so that its shape can be read.

layout(location = 0) in vec3 ray;

layout(location = 0) uniform bool by_root;  // colours go with the square root of the number

layout(location = 0) out vec4 color;

layout(binding = 2) uniform usampler2D seen_tissue;  // rest: x: the number, 0 to 1 from end to end; y: 1 where there is one
layout(binding = 5) uniform sampler2D colors;        // sRGB

const vec3 kNoNumber = vec3(0.45);

void main() {
  Seen seen = seen_from(texelFetch(seen_tissue, ivec2(gl_FragCoord.xy), 0), rest_grid, false);
  vec2 number = seen.rest.xy;
  int last = textureSize(colors, 0).x - 1;
  // Of the number between vertices, not at them: a root does not go evenly.
  float place = by_root ? sqrt(saturate(number.x)) : saturate(number.x);
  vec3 shown = texelFetch(colors, ivec2(int(0.5 + float(last) * place), 0), 0).rgb;
  float facing = dot(seen.normal, -normalize(ray));
  float shade = mix(0.5, 1.0, smoothstep(0.0, 0.55, facing));
  color = vec4(field_stop(ray) * shade * (number.y > 0.5 ? shown : kNoNumber), 1.0);
}
