#include "frame.glsl"

const float kExposure = 0.72;

// Linear radiance to display sRGB: the film curve of Hejl and Burgess-Dawson (2010), a rational function that has the
// display's encoding in it and so needs no powers. Before it a part of each channel goes to the others, so that strong
// coloured light turns pale as on film.
vec3 displayed(vec3 radiance) {
  vec3 mixed = 0.95 * radiance + 0.05 * dot(radiance, vec3(0.2126, 0.7152, 0.0722));
  vec3 x = max(kExposure * mixed - 0.004, 0.0);
  return x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06);
}

// Breaks the bands of slow gradients by less than one 8-bit level, with a pattern fixed to the pixels (interleaved
// gradient noise, Jimenez 2014).
vec3 dithered(vec3 display, vec2 pixel) {
  float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  return display + (noise - 0.5) / 255.0;
}

// What the lens leaves of light along `ray` (of length one along the line of sight): it darkens towards the border.
float lens_light(vec3 ray) { return background.w / square(1.0 + key_right.w * (dot(ray, ray) - 1.0)); }

// 1 inside the field stop, 0 outside.
float field_stop(vec3 ray) {
  float radius = sqrt(max(dot(ray, ray) - 1.0, 0.0));
  return floor_plane.w > 0.0 ? 1.0 - smoothstep(0.985, 1.0, radius / floor_plane.w) : 1.0;
}

// What the lens and its field stop leave along `ray`: of the light, of the picture.
vec2 through_lens(vec3 ray) { return vec2(lens_light(ray), field_stop(ray)); }

// The colour of a pixel that sees `radiance` through the lens.
vec4 finished(vec3 radiance, vec2 through_lens, vec2 pixel) {
  return vec4(dithered(through_lens.y * displayed(through_lens.x * radiance), pixel), 1.0);
}

vec4 finished(vec3 radiance, vec3 ray, vec2 pixel) { return finished(radiance, through_lens(ray), pixel); }
