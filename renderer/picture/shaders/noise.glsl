// Smooth noise without a texture: at the corners of a lattice of whole numbers a hash gives a value from -1 to 1, between
// them it is blended with a curve whose first and second derivatives vanish at the corners (Perlin 2002).

uint hash(uvec3 cell) {
  // Two rounds of multiply and fold; integers, so that every driver gives the same.
  uint h = cell.x * 0x8da6b343u ^ cell.y * 0xd8163841u ^ cell.z * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

float lattice(uvec3 cell) { return float(hash(cell) & 0xffffu) * (2.0 / 65535.0) - 1.0; }

// Value in w, gradient in xyz.
vec4 noise(vec3 place) {
  vec3 corner = floor(place);
  vec3 f = place - corner;
  uvec3 cell = uvec3(ivec3(corner));
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = lattice(cell);
  float b = lattice(cell + uvec3(1, 0, 0));
  float c = lattice(cell + uvec3(0, 1, 0));
  float d = lattice(cell + uvec3(1, 1, 0));
  float e = lattice(cell + uvec3(0, 0, 1));
  float g = lattice(cell + uvec3(1, 0, 1));
  float h = lattice(cell + uvec3(0, 1, 1));
  float k = lattice(cell + uvec3(1, 1, 1));
  vec4 x0 = vec4(a, c, e, h);
  vec4 x_step = vec4(b, d, g, k) - x0;
  vec4 x = x0 + u.x * x_step;
  vec2 y = mix(x.xz, x.yw, u.y);
  vec2 y_step = x.yw - x.xz;
  vec2 dx = mix(x_step.xz, x_step.yw, u.y);
  vec3 slope = vec3(mix(dx.x, dx.y, u.z), mix(y_step.x, y_step.y, u.z), y.y - y.x);
  return vec4(slope * du, mix(y.x, y.y, u.z));
}
