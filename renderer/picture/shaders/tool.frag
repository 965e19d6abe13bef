#version 450 core
#include "frame.glsl"
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

// Part to which the place is of a shaft so slender that its pixels see all around it, 0 to 1. What is close to the tip, which
// gets narrower towards that, is not.
float slender(vec3 normal) {
  const float kWide = 3.0, kSlender = 2.0;  // pixels, its radius
  const float kFlat = 0.02, kRound = 0.06;  // how its normal turns
  const float kTip = 4.0, kShaft = 8.0;     // ways from the tip, over the radius
  float radius = length(place.yz);
  float pixels = radius * scene_center.w / (environment.w * place.w);
  return smoothstep(kFlat, kRound, turning(normal)) * (1.0 - smoothstep(kSlender, kWide, pixels)) *
         smoothstep(kTip, kShaft, place.x / max(radius, 1e-9));
}

// As the outline of a slender shaft passes between pixels these see now more of one side and now of the other, as of the
// strands of a rope. It looks all across as its middle does.
vec3 steadied(vec3 normal, vec3 axis) {
  vec3 view = normalize(camera_position.xyz - position), middle = view - dot(view, axis) * axis;
  float part = finish.x >= 0.0 && dot(axis, axis) > 0.0 ? slender(normal) : 0.0;
  return normalize(mix(normal, middle * inversesqrt(max(dot(middle, middle), 1e-6)), part));
}

void main() {
  vec3 normal = normalize(smooth_normal), axis = along_tool(normal);
  float roughness = sqrt(finish.x * finish.x + turned_within_pixel(normal));
  seen_place = place;
  seen_normal = vec4((1.0 + abs(finish.x)) * steadied(normal, axis), finish.x < 0.0 ? -roughness : roughness);
  seen_axis = vec4(axis, finish.y);
}
