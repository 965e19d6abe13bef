// The lens of Lens.hpp: radial and tangential distortion with OpenCV's coefficients, in tangents of angles off the line of
// sight, x to the right and y DOWN.

struct Lens {
  vec4 first;  // k1, k2, p1, p2
  float k3;
  float unfolded;  // radius of ideal points beyond which the lens folds the plane over
};

// Where the lens puts the ideal point of a pinhole.
vec2 lens_distorted(Lens lens, vec2 ideal) {
  float r2 = dot(ideal, ideal);
  float scale = 1.0 + r2 * (lens.first.x + r2 * (lens.first.y + r2 * lens.k3));
  float xy = 2.0 * ideal.x * ideal.y;
  return ideal * scale + vec2(lens.first.z * xy + lens.first.w * (r2 + 2.0 * ideal.x * ideal.x),
                              lens.first.z * (r2 + 2.0 * ideal.y * ideal.y) + lens.first.w * xy);
}

// The ideal point that the lens puts at `seen`, by Newton's method; where the lens is one-to-one, to what floats allow.
vec2 lens_undistorted(Lens lens, vec2 seen) {
  const int few = 6;    // which a mild lens takes
  const int most = 50;  // far out, powers of seven let each step come nearer by a seventh only
  const float near = 1e-5;
  vec2 ideal = min(1.0, 0.9 * lens.unfolded / max(length(seen), 1e-30)) * seen;
  for (int i = 0; i < few || (i < most && distance(lens_distorted(lens, ideal), seen) > near); ++i) {
    float r2 = dot(ideal, ideal);
    float scale = 1.0 + r2 * (lens.first.x + r2 * (lens.first.y + r2 * lens.k3));
    float slope = lens.first.x + r2 * (2.0 * lens.first.y + 3.0 * lens.k3 * r2);
    float p1 = lens.first.z;
    float p2 = lens.first.w;
    float xx = scale + 2.0 * ideal.x * ideal.x * slope + 2.0 * p1 * ideal.y + 6.0 * p2 * ideal.x;
    float xy = 2.0 * ideal.x * ideal.y * slope + 2.0 * (p1 * ideal.x + p2 * ideal.y);
    float yy = scale + 2.0 * ideal.y * ideal.y * slope + 6.0 * p1 * ideal.y + 2.0 * p2 * ideal.x;
    vec2 error = lens_distorted(lens, ideal) - seen;
    ideal -= vec2(yy * error.x - xy * error.y, xx * error.y - xy * error.x) / (xx * yy - xy * xy);
  }
  return ideal;
}
