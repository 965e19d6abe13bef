// How far out of focus a pixel is, see FocusPass.hpp.

layout(location = 0) uniform vec4 optics;  // aperture in pixels, 1 / focus, and depth on the screen: z from a - b / z

const float kLargest = 18.0;  // pixels, radius of the widest disc

// Radius in pixels of the disc that a point of the depth buffer is seen as; the field stop, at depth 0, is sharp.
float disc_radius(float depth) {
  float inverse = (optics.z - (2.0 * depth - 1.0)) / optics.w;
  return depth > 0.0 ? min(0.5 * optics.x * abs(optics.y - inverse), kLargest) : 0.0;
}
