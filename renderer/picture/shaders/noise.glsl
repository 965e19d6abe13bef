// Smooth noise without a texture (simplex noise, Perlin 2001): space is divided into tetrahedra, a hash gives each corner
// a slope, and what the four corners around a place say is blended with weights that vanish, with their first three
// derivatives, where a corner's neighbourhood ends.

const uvec3 kPrimes = uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);

// Gradient in xyz, value in w, of the corner at `offset` from the place, in units that noise() takes back. `cell`: the
// corner's whole numbers times kPrimes.
vec4 corner_part(uvec3 cell, vec3 offset) {
  // Multiply and fold; integers, so that every driver gives the same.
  uint h = cell.x ^ cell.y ^ cell.z;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h ^= (h >> 13) ^ 0x20080200u;
  // Three times ten bits, each shifted to the top of a whole number with a sign; what lies below is too little to count.
  vec3 slope = vec3(ivec3(h << 22, h << 12, h << 2));
  float height = dot(slope, offset);
  float reach = max(0.5 - dot(offset, offset), 0.0);
  float cubed = reach * reach * reach;
  float fourth = cubed * reach;
  return vec4(fourth * slope - (8.0 * cubed * height) * offset, fourth * height);
}

uvec3 primes_where(vec3 taken) { return mix(uvec3(0u), kPrimes, greaterThan(taken, vec3(0.5))); }

// Gradient in xyz, value in w, about -1 to 1; waves are some 1.5 long.
vec4 noise(vec3 place) {
  vec3 cell = floor(place + dot(place, vec3(1.0 / 3.0)));
  vec3 a = place - cell + dot(cell, vec3(1.0 / 6.0));
  // The corners of the tetrahedron on the way from the first to the last, largest part first; of equal parts the earlier.
  vec3 first = vec3(a.x >= a.y, a.y >= a.z, a.z > a.x);
  vec3 second = 1.0 - first.zxy;
  vec3 near = min(first, second);
  vec3 far = max(first, second);
  uvec3 corner = uvec3(ivec3(cell)) * kPrimes;
  vec4 sum = corner_part(corner, a) + corner_part(corner + primes_where(near), a - near + 1.0 / 6.0) +
             corner_part(corner + primes_where(far), a - far + 1.0 / 3.0) + corner_part(corner + kPrimes, a - 0.5);
  return (68.0 / 511.5 / 4194304.0) * sum;
}
