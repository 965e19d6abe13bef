// Light that enters the flesh leaves it nearby: where the surface bends within that distance, the border between light and
// dark is soft, and red, which travels farthest, goes deepest into the dark. Pre-integrated over the bend, after the idea
// of Penner (2011), with a curve of our own: a rounded max(cosine, 0), divided by what the rounding adds to its mean over
// all directions, so that a ball sends back as much light as a matte one.

// `width`: how far light travels over the radius of the bend, above 0, for red, green and blue.
vec3 scattered_cosine(float cosine, vec3 width) {
  vec3 squared = width * width;
  vec3 root = sqrt(1.0 + squared);
  // The mean of the rounded curve over that of max(cosine, 0).
  vec3 mean = root + squared * log((1.0 + root) / width);
  return 0.5 * (cosine + sqrt(cosine * cosine + squared)) / mean;
}
