// Square of the width by which a pixel mirrors as a rougher surface does, as the normal turns within it (Tokuyoshi and
// Kaplanyan 2019).
float turned_within_pixel(vec3 normal) {
  vec3 across = dFdx(normal), up = dFdy(normal);
  return min(0.5 * (dot(across, across) + dot(up, up)), 0.2);
}
