#version 450 core
#include "focus.glsl"

// The mean of a disc, of those places whose own discs reach this pixel. Places on a spiral by the golden angle.

layout(location = 0) out vec4 color;

layout(binding = 0) uniform sampler2D picture;

const int kPlaces = 14;
const mat2 kGoldenTurn = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

void main() {
  vec2 size = vec2(textureSize(picture, 0));
  vec4 own = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  color = own;
  if (own.a < 0.02) return;
  float radius = 0.5 * kLargest * own.a;  // of the picture of half the size
  vec4 sum = vec4(own.rgb, 1.0);
  vec2 sense = vec2(1.0, 0.0);
  for (int k = 1; k <= kPlaces; ++k) {
    float part = sqrt(float(k) / float(kPlaces));
    sense = kGoldenTurn * sense;
    vec4 other = texture(picture, (gl_FragCoord.xy + radius * part * sense) / size);
    float reaches = step(0.02, other.a) * clamp(2.0 * (other.a / own.a - part) + 1.0, 0.0, 1.0);
    sum += reaches * vec4(other.rgb, 1.0);
  }
  color = vec4(sum.rgb / sum.a, own.a);
}
