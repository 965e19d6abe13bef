// Half the square of how far a normal turns from pixel to pixel.
float turning(vec3 normal) {
  vec3 across = dFdx(normal), up = dFdy(normal);
  return 0.5 * (dot(across, across) + dot(up, up));
}

// Square of the width by which a pixel mirrors as a rougher surface does, as the normal turns within it (Tokuyoshi and
// Kaplanyan 2019).
float turned_within_pixel(vec3 normal) { return min(turning(normal), 0.2); }
