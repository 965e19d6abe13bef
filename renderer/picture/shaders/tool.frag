#version 450 core
#include "turning.glsl"

// What is seen of the tools, for metal.frag, as surface.frag is of the tissue: many of their triangles are so slender that
// a pixel would be shaded for several. What tells from pixel to pixel is found here, within each triangle.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;
layout(location = 2) in vec2 finish;  // roughness, of flat faces below 0; depth of the rings, or below 0 shade
layout(location = 3) in vec4 place;   // along the tool and off its middle line, in units of the scene's size; depth, metres

layout(location = 0) out vec4 seen_place;   // as it came
layout(location = 1) out vec4 seen_normal;  // xyz, of length 1 + roughness; w: roughness as the pixel sees it, below 0 on flat faces
layout(location = 2) out vec4 seen_axis;    // xyz: along the tool, of length one, or zero; w: depth of the rings, or below 0 shade

// Along the tool, in the triangle's plane, from how the distance along it changes between pixels (Mikkelsen 2010); not
// of length one, and zero where it does not change.
vec3 along_tool(vec3 normal) {
  vec3 across_pixels = dFdx(position), up_pixels = dFdy(position);
  // In units of a pixel: products of its metres in a near view are so small that they have no digits left.
  float over_pixel = 1.0 / max(max(length(across_pixels), length(up_pixels)), 1e-12);
  across_pixels *= over_pixel;
  up_pixels *= over_pixel;
  vec3 plane = cross(across_pixels, up_pixels);
  vec3 axis = dFdx(place.x) * cross(up_pixels, plane) + dFdy(place.x) * cross(plane, across_pixels);
  axis -= dot(axis, normal) * normal;
  float size = length(axis);
  return size > 0.0 ? axis / size : vec3(0.0);
}

void main() {
  vec3 normal = normalize(smooth_normal);
  float roughness = sqrt(finish.x * finish.x + turned_within_pixel(normal));
  seen_place = place;
  seen_normal = vec4((1.0 + abs(finish.x)) * normal, finish.x < 0.0 ? -roughness : roughness);
  seen_axis = vec4(along_tool(normal), finish.y);
}
