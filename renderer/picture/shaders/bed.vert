#version 450 core
#include "screen.glsl"

// What bed.frag knows of its ball, the same for all pixels.

layout(location = 1) flat out vec4 ball;   // xyz: from its middle to the lens, metres; w: squared radius less the square of that
layout(location = 2) flat out vec4 parts;  // one over: squared half width of the plane, radius, height of the middle, scene's size

// How far above the plane the middle of the ball lies, and half the width of the plane at least, over the scene's size.
const float kMiddle = 1.0, kPlane = 0.8;

void main() {
  cover_screen();
  float lifted = kMiddle * scene_center.w;
  vec3 from_middle = camera_position.xyz - vec3(scene_center.xy, floor_plane.x + lifted);
  float squared_away = dot(from_middle, from_middle);
  float squared_radius = max(square(lifted) + square(kPlane * scene_center.w), 1.1 * squared_away);
  ball = vec4(from_middle, squared_radius - squared_away);
  parts = 1.0 / vec4(squared_radius - square(lifted), sqrt(squared_radius), lifted, scene_center.w);
}
