#include "frame.glsl"

// Linear radiance to display sRGB. The curve is Narkowicz's fit of the ACES filmic tone scale (2016); before it a part of
// each channel goes to the others, so that strong coloured light turns pale as on film instead of clipping.
vec3 displayed(vec3 radiance) {
  vec3 x = 0.92 * radiance + 0.08 * dot(radiance, vec3(0.2126, 0.7152, 0.0722));
  x *= 0.72;
  vec3 curve = clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
  return mix(12.92 * curve, 1.055 * pow(max(curve, 1e-5), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, curve));
}

// Breaks the bands of slow gradients by less than one 8-bit level, with a pattern fixed to the pixels (interleaved
// gradient noise, Jimenez 2014).
vec3 dithered(vec3 display, vec2 pixel) {
  float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  return display + (noise - 0.5) / 255.0;
}
