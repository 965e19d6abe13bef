// What is seen of the tissue at a pixel, in four whole numbers. On a driver without a GPU a picture's pixels wait for them
// to come from memory, the longer the more they are: twice as many took an eighth of the time of a whole picture.

struct Seen {
  vec3 normal;      // of length one, towards the viewer
  float depth;      // along the line of sight, metres, within 8e-6 of it
  vec3 rest;        // metres, within half a step of rest_grid
  float bend;       // -1 to 1
  float blanch;     // 0 to 1; 0 in layered parts
  float thickness;  // 0 to 2; 0 in layered parts
  float wound;      // -1 to 1; 0 but in layered parts
};

// A direction, not of length one, on the eight faces of an octahedron, which is laid flat: 0 to 1 (Meyer et al. 2010).
vec2 octahedral(vec3 direction) {
  vec2 place = direction.xy / (abs(direction.x) + abs(direction.y) + abs(direction.z));
  vec2 folded = (1.0 - abs(place.yx)) * vec2(place.x < 0.0 ? -1.0 : 1.0, place.y < 0.0 ? -1.0 : 1.0);
  return 0.5 + 0.5 * (direction.z < 0.0 ? folded : place);
}

vec3 direction_of(vec2 octahedral) {
  vec2 place = 2.0 * octahedral - 1.0;
  float height = 1.0 - abs(place.x) - abs(place.y);
  vec2 back = vec2(max(-height, 0.0));
  return normalize(vec3(place - back * vec2(place.x < 0.0 ? -1.0 : 1.0, place.y < 0.0 ? -1.0 : 1.0), height));
}

uint two_of(vec2 parts) {
  uvec2 steps = uvec2(ivec2(65535.0 * clamp(parts, 0.0, 1.0) + 0.5));
  return steps.x | steps.y << 16;
}

vec2 two_from(uint both) { return vec2(ivec2(both & 0xffffu, both >> 16)) * (1.0 / 65535.0); }

// Depth takes 24 bits of a float, which has no sign here; what shares its number takes 8.
uint with_depth(float depth, float part) {
  return ((floatBitsToUint(depth) << 1) + 128u & 0xffffff00u) | uint(int(255.0 * clamp(part, 0.0, 1.0) + 0.5));
}

float depth_from(uint number) { return uintBitsToFloat((number & 0xffffff00u) >> 1); }
float part_from(uint number) { return float(int(number & 0xffu)) * (1.0 / 255.0); }

// `place`: parts of the box of all stress-free positions; `state`: as of surface.vert.
uvec4 numbers_of(vec3 normal, float depth, vec3 place, vec3 state, bool is_layered) {
  vec2 parts = floor(255.0 * clamp(state.xz, 0.0, 1.0) + 0.5);
  uint told = is_layered ? uint(int(65535.0 * clamp(state.x, 0.0, 1.0) + 0.5)) : uint(int(parts.x + 256.0 * parts.y));
  return uvec4(with_depth(depth, state.y), two_of(place.xy), two_of(vec2(place.z, 0.0)) | told << 16,
               two_of(octahedral(normal)));
}

// `grid`: rest_grid of the frame.
Seen seen_from(uvec4 numbers, vec4 grid, bool is_layered) {
  uint told = numbers.z >> 16;
  vec3 place = vec3(ivec3(numbers.y & 0xffffu, numbers.y >> 16, numbers.z & 0xffffu));
  vec2 parts = is_layered ? vec2(0.0) : vec2(ivec2(told & 0xffu, told >> 8)) * (1.0 / 255.0);
  float wound = is_layered ? float(int(told)) * (2.0 / 65535.0) - 1.0 : 0.0;
  return Seen(direction_of(two_from(numbers.w)), depth_from(numbers.x), grid.xyz + grid.w * place,
              2.0 * part_from(numbers.x) - 1.0, parts.x, 2.0 * parts.y, wound);
}
