// Smooth noise without a texture (Perlin 2002): at the corners of a lattice of whole numbers a hash gives a slope, between
// them the slopes' planes are blended with a curve whose first and second derivatives vanish at the corners.

uint hash(uvec3 cell) {
  // Multiply and fold; integers, so that every driver gives the same.
  uint h = cell.x * 0x8da6b343u ^ cell.y * 0xd8163841u ^ cell.z * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

// xyz: slope, each from -1 to 1; w: height of its plane at `offset` from the corner.
vec4 corner_plane(uvec3 cell, vec3 offset) {
  uint h = hash(cell);
  vec3 slope = vec3(uvec3(h, h >> 10, h >> 20) & 1023u) * (2.0 / 1023.0) - 1.0;
  return vec4(slope, dot(slope, offset));
}

// Gradient in xyz, value in w, about -1 to 1.
vec4 noise(vec3 place) {
  vec3 whole = floor(place);
  vec3 f = place - whole;
  uvec3 cell = uvec3(ivec3(whole));
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  vec4 a = corner_plane(cell, f);
  vec4 b = corner_plane(cell + uvec3(1, 0, 0), f - vec3(1, 0, 0));
  vec4 c = corner_plane(cell + uvec3(0, 1, 0), f - vec3(0, 1, 0));
  vec4 d = corner_plane(cell + uvec3(1, 1, 0), f - vec3(1, 1, 0));
  vec4 e = corner_plane(cell + uvec3(0, 0, 1), f - vec3(0, 0, 1));
  vec4 g = corner_plane(cell + uvec3(1, 0, 1), f - vec3(1, 0, 1));
  vec4 h = corner_plane(cell + uvec3(0, 1, 1), f - vec3(0, 1, 1));
  vec4 k = corner_plane(cell + uvec3(1, 1, 1), f - vec3(1, 1, 1));
  vec4 low = mix(mix(a, b, u.x), mix(c, d, u.x), u.y);
  vec4 high = mix(mix(e, g, u.x), mix(h, k, u.x), u.y);
  vec3 steps = vec3(mix(mix(b.w - a.w, d.w - c.w, u.y), mix(g.w - e.w, k.w - h.w, u.y), u.z),
                    mix(mix(c.w - a.w, d.w - b.w, u.x), mix(h.w - e.w, k.w - g.w, u.x), u.z), high.w - low.w);
  vec4 blended = mix(low, high, u.z);
  return 1.4 * vec4(blended.xyz + du * steps, blended.w);
}
