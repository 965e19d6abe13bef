#version 450 core
#include "lens.glsl"

// Bends a pinhole's picture as the lens does: each pixel looks up the place of the wider pinhole's picture that the lens
// brings there.

layout(location = 0) out vec4 color;

layout(location = 0) uniform vec4 first;     // k1, k2, p1, p2
layout(location = 1) uniform float k3;
layout(location = 2) uniform vec4 tangents;  // of half the fields of view: of the picture, of the pinhole's
layout(location = 3) uniform vec2 pixel;     // 1 / picture size
layout(location = 4) uniform float unfolded; // radius of ideal points beyond which the lens folds the plane over
layout(binding = 0) uniform sampler2D picture;

void main() {
  vec2 clip = 2.0 * gl_FragCoord.xy * pixel - 1.0;
  vec2 bent = clip * tangents.xy * vec2(1.0, -1.0);
  Lens lens = Lens(first, k3, unfolded);
  vec2 ideal = lens_undistorted(lens, bent);
  vec2 seen = ideal * vec2(1.0, -1.0) / tangents.zw;
  // Beyond what a field stop leaves the lens may bring no ray at all, and what was found is not its place, to half a
  // pixel: written so that what is no number is black too.
  bool is_found = length(ideal) <= unfolded && distance(lens_distorted(lens, ideal), bent) <= tangents.x * pixel.x;
  color = is_found && all(lessThan(abs(seen), vec2(1.0))) ? texture(picture, 0.5 + 0.5 * seen)
                                                          : vec4(0.0, 0.0, 0.0, 1.0);
}
