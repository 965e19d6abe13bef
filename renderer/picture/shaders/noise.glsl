// Smooth noise without a texture (simplex noise, Perlin 2001): space is divided into tetrahedra, a hash gives each corner
// a slope, and what the four corners around a place say is blended with weights that vanish, with their first three
// derivatives, where a corner's neighbourhood ends.

uint hash(uvec3 cell) {
  // Multiply and fold; integers, so that every driver gives the same.
  uint h = cell.x * 0x8da6b343u ^ cell.y * 0xd8163841u ^ cell.z * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

// Gradient in xyz, value in w, of the corner `cell` at `offset` from it.
vec4 corner_part(uvec3 cell, vec3 offset) {
  uint h = hash(cell);
  vec3 slope = vec3(uvec3(h, h >> 10, h >> 20) & 1023u) * (2.0 / 1023.0) - 1.0;
  float height = dot(slope, offset);
  float reach = max(0.5 - dot(offset, offset), 0.0);
  float cubed = reach * reach * reach;
  return vec4(cubed * (reach * slope - 8.0 * height * offset), cubed * reach * height);
}

// Gradient in xyz, value in w, about -1 to 1; waves are some 1.5 long.
vec4 noise(vec3 place) {
  vec3 cell = floor(place + dot(place, vec3(1.0 / 3.0)));
  vec3 a = place - cell + dot(cell, vec3(1.0 / 6.0));
  // The corners of the tetrahedron on the way from the first to the last, largest part first; of equal parts the earlier.
  vec3 first = vec3(a.x >= a.y, a.y >= a.z, a.z > a.x);
  vec3 second = 1.0 - first.zxy;
  vec3 near = min(first, second);
  vec3 far = max(first, second);
  uvec3 corner = uvec3(ivec3(cell));
  vec4 sum = corner_part(corner, a) + corner_part(corner + uvec3(near), a - near + 1.0 / 6.0) +
             corner_part(corner + uvec3(far), a - far + 1.0 / 3.0) + corner_part(corner + 1u, a - 0.5);
  return 68.0 * sum;
}
