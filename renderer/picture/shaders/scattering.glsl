// Light that enters the flesh leaves it nearby: where the surface bends within that distance, the border between light and
// dark is soft, and red, which travels farthest, goes deepest into the dark. Pre-integrated over the bend, after the idea
// of Penner (2011), with a curve of our own: a rounded max(cosine, 0), divided by what the rounding adds to its mean over
// all directions, so that a ball sends back as much light as a matte one.

// `width`: how far light travels over the radius of the bend, 0 to 0.7, for red, green and blue.
vec3 scattered_cosine(float cosine, vec3 width) {
  // The mean of max(cosine, 0) over that of the rounded curve, which is s + width^2 log((1 + s) / width) of it with
  // s^2 = 1 + width^2: fitted within 0.0016, as the logarithms take as long as a noise.
  vec3 part = 1.0 + width * (-0.10943 + width * (-2.77070 + width * (4.60236 - 2.43863 * width)));
  return 0.5 * part * (cosine + sqrt(cosine * cosine + width * width));
}
