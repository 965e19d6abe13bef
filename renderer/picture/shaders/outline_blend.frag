#version 450 core

// Lays what outline.frag has drawn beside the colours over them: that reads the colours of neighbours, which must not have
// been smoothed yet.

layout(location = 0) out vec4 color;  // is blended over the pixel by its alpha

layout(binding = 0) uniform sampler2D smoothing;

void main() { color = texelFetch(smoothing, ivec2(gl_FragCoord.xy), 0); }
