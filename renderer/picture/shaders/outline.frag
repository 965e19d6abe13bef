#version 450 core

layout(location = 0) flat in vec4 window_line;
layout(location = 0) out vec4 color;  // to be blended over the pixel by its alpha

layout(binding = 0) uniform sampler2D picture;

void main() {
  vec2 along = window_line.zw - window_line.xy;
  bool flat_line = abs(along.x) >= abs(along.y);
  vec2 from = gl_FragCoord.xy - window_line.xy;
  // Distance from the pixel's middle to the line, upward for lines that run across, rightward for those that run up.
  float offset = flat_line ? along.y / along.x * from.x - from.y : along.x / along.y * from.y - from.x;
  float share = max(0.5 - abs(offset), 0.0);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int side = offset > 0.0 ? 1 : -1;
  ivec2 neighbour = pixel + (flat_line ? ivec2(0, side) : ivec2(side, 0));
  neighbour = clamp(neighbour, ivec2(0), textureSize(picture, 0) - 1);
  color = vec4(texelFetch(picture, neighbour, 0).rgb, share);
}
